//===- FloatLoops.cpp - Loops that fast math is for -----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// What shading kernels compute most, over arrays in the local store, so that
// arithmetic and not memory takes the time. Prints a line for each loop: its
// name, cycles, instructions and the bits of a checksum. For one thread;
// bench/fast_math.py compiles it with several sets of flags.
//
//===----------------------------------------------------------------------===//

#include "kernels/common/Random.h"
#include "kernels/common/Vector3.h"
#include "tp/thread.h"

#include <cmath>
#include <stdio.h>

using namespace tp;

namespace {

constexpr uint32_t Count = 512;

/// Everything that the loops read and write.
struct Data {
  Vector3 Vectors[Count];
  Vector3 Others[Count];
  float Cosines[Count];
  float Roughness[Count];
  float Results[Count];
  Vector3 Directions[Count];
};

thread_local Data Local;

float inUnit(uint32_t Word) { return unitFloat(Word) * 0.9f + 0.05f; }

void fill(Data &D) {
  for (uint32_t I = 0; I != Count; ++I) {
    const RandomWords A = randomWords(I, 0, 0, 1);
    const RandomWords B = randomWords(I, 1, 0, 1);
    const RandomWords C = randomWords(I, 2, 0, 1);
    D.Vectors[I] = {inUnit(A.X), inUnit(A.Y), inUnit(A.Z)};
    D.Others[I] = {inUnit(B.X), inUnit(B.Y), inUnit(B.Z)};
    D.Cosines[I] = inUnit(C.X);
    D.Roughness[I] = inUnit(C.Y);
  }
}

/// Unit vectors, as they are written without thought.
[[gnu::noinline]] void normalize(Data &D) {
  for (uint32_t I = 0; I != Count; ++I) {
    const Vector3 V = D.Vectors[I];
    const float Length = std::sqrt(dot(V, V));
    D.Directions[I] = {V.X / Length, V.Y / Length, V.Z / Length};
  }
}

/// One over a distance.
[[gnu::noinline]] void inverseDistance(Data &D) {
  for (uint32_t I = 0; I != Count; ++I)
    D.Results[I] = 1.0f / std::sqrt(dot(D.Vectors[I], D.Others[I]));
}

/// Phong's highlight with a power written as such.
[[gnu::noinline]] void phong(Data &D) {
  for (uint32_t I = 0; I != Count; ++I)
    D.Results[I] =
        0.2f + 0.5f * D.Roughness[I] + 0.8f * std::pow(D.Cosines[I], 32.0f);
}

/// The report's x*x*x*x.
[[gnu::noinline]] void powers(Data &D) {
  for (uint32_t I = 0; I != Count; ++I) {
    const float X = D.Cosines[I], Y = D.Roughness[I];
    D.Results[I] = X * X * X * X + Y * Y * Y * Y * Y * Y * Y * Y;
  }
}

/// The microfacet model of Cook and Torrance with GGX, Smith and Schlick.
[[gnu::noinline]] void microfacets(Data &D) {
  constexpr float Pi = 3.14159265f;
  for (uint32_t I = 0; I != Count; ++I) {
    const float NH = D.Cosines[I], NL = D.Vectors[I].X, NV = D.Vectors[I].Y;
    const float VH = D.Vectors[I].Z;
    const float A = D.Roughness[I] * D.Roughness[I];
    const float Denominator = NH * NH * (A * A - 1.0f) + 1.0f;
    const float Distribution = A * A / (Pi * Denominator * Denominator);
    const float K = A / 2.0f;
    const float Shadowing =
        NL / (NL * (1.0f - K) + K) * (NV / (NV * (1.0f - K) + K));
    const float M = 1.0f - VH;
    const float Fresnel = 0.04f + 0.96f * (M * M * M * M * M);
    D.Results[I] = Distribution * Shadowing * Fresnel / (4.0f * NL * NV);
  }
}

/// Barycentric coordinates by Cramer's rule.
[[gnu::noinline]] void barycentric(Data &D) {
  for (uint32_t I = 0; I != Count; ++I) {
    const Vector3 A = D.Vectors[I], B = D.Others[I];
    const float Determinant = A.X * B.Y - A.Y * B.X + 2.0f;
    const float U = (A.Z * B.Y - A.Y * B.Z) / Determinant;
    const float V = (A.X * B.Z - A.Z * B.X) / Determinant;
    const float T = D.Cosines[I] / Determinant;
    D.Results[I] = U * V + T;
  }
}

/// Tone mapping and a division by a constant.
[[gnu::noinline]] void toneMap(Data &D) {
  for (uint32_t I = 0; I != Count; ++I) {
    const float X = D.Cosines[I] / 0.7f;
    D.Results[I] = X * (1.0f + X / 9.0f) / (1.0f + X);
  }
}

/// A division whose divisor does not change.
[[gnu::noinline]] void scale(Data &D) {
  const float Lower = D.Cosines[0], Extent = D.Cosines[1] + 1.0f;
  for (uint32_t I = 0; I != Count; ++I)
    D.Results[I] = 16.0f * ((D.Roughness[I] - Lower) / Extent);
}

/// Sums in their own order are a chain of dependent additions.
[[gnu::noinline]] void dotProduct(Data &D) {
  float Sum = 0;
  for (uint32_t I = 0; I != Count; ++I)
    Sum += D.Cosines[I] * D.Roughness[I];
  D.Results[0] = Sum;
}

struct Loop {
  const char *Name;
  void (*Run)(Data &);
};

constexpr Loop Loops[] = {
    {"normalize", normalize},
    {"inverse-distance", inverseDistance},
    {"phong", phong},
    {"powers", powers},
    {"microfacets", microfacets},
    {"barycentric", barycentric},
    {"tone-map", toneMap},
    {"scale", scale},
    {"dot-product", dotProduct},
};

} // namespace

static uint32_t checksum(const Data &D) {
  uint32_t Sum = 0;
  auto Add = [&](float Value) {
    Sum = Sum * 31 + __builtin_bit_cast(uint32_t, Value);
  };
  for (uint32_t I = 0; I != Count; ++I) {
    Add(D.Results[I]);
    Add(D.Directions[I].X);
    Add(D.Directions[I].Y);
    Add(D.Directions[I].Z);
  }
  return Sum;
}

int main() {
  fill(Local);
  for (const Loop &L : Loops) {
    // Once to fill the instruction cache.
    L.Run(Local);
    const uint64_t Cycles = cycleCount();
    const uint64_t Instructions = instructionCount();
    L.Run(Local);
    printf("%s %u %u %08x\n", L.Name,
           static_cast<unsigned>(cycleCount() - Cycles),
           static_cast<unsigned>(instructionCount() - Instructions),
           static_cast<unsigned>(checksum(Local)));
  }
  return 0;
}
