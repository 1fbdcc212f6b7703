// Indexes that come of numbers which fast math may round otherwise.

// RUN: tpcc -ffast-math -fsyntax-only -Xclang -verify %s
// RUN: tpcc -ftp-fp=reproducible -fsyntax-only -Xclang -verify %s
// RUN: clang++ -std=c++20 -fplugin=%tp_bin/../lib/TPFloatingPoint.so \
// RUN:   -ffast-math -fsyntax-only -Xclang -verify %s

// RUN: tpcc -ffp-contract=fast -ffinite-math-only -fno-signed-zeros \
// RUN:   -fsyntax-only -Xclang -verify=silent %s
// silent-no-diagnostics

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

constexpr int Bins = 12;
int Counts[Bins];

// The bin of a textbook builder without its clamp: 1 ulp below the maximum it
// is Bins.
static int bin(float C, float Low, float High) {
  return (int)(Bins * ((C - Low) / (High - Low))); // expected-warning {{an index out of range may come of this conversion: fast math may round its operand up to the next integer [-Wtp-fp-conversion]}} expected-note {{this division may become a multiplication by the reciprocal; '#pragma clang fp reciprocal(off) reassociate(off)' keeps it as written}}
}
void throughFunction(float C, float Low, float High) {
  ++Counts[bin(C, Low, High)]; // expected-note {{used as an index here; clamp it to the range of the array}}
}

void throughVariable(float C, float Low, float High) {
  int Bin = Bins * ((C - Low) / (High - Low)); // expected-warning {{an index out of range}} expected-note {{this division}}
  ++Counts[Bin]; // expected-note {{used as an index here}}
}

void hoistedReciprocal(float C, float Low, float High) {
  const float Scale = 1.0f / (High - Low); // expected-note {{this operation may be regrouped with its neighbors; '#pragma clang fp reassociate(off)' keeps it as written}}
  float Position = (C - Low) * Scale;
  Position *= Bins;
  ++Counts[static_cast<int>(Position)]; // expected-warning {{an index out of range}} expected-note {{used as an index here}}
}

void rounded(int *Table, double X) {
  int Step;
  Step = std::floor(X / 0.1); // expected-warning {{an index out of range}} expected-note {{this division}}
  Table[3 * Step + 1] = 0; // expected-note {{used as an index here}}
}

void containers(std::vector<int> &V, std::array<int, 9> &A, float X, float W) {
  V[std::size_t(X / W)] = 0; // expected-warning {{an index out of range}} expected-note {{this division}} expected-note {{used as an index}}
  A[int(X / W)] = 0; // expected-warning {{an index out of range}} expected-note {{this division}} expected-note {{used as an index}}
}

void pointers(int *P, float X, float W, float K) {
  *(P + int(X / W)) = 0; // expected-warning {{an index out of range}} expected-note {{this division}} expected-note {{used as an index}}
  P += long(X * W * K);  // expected-warning {{an index out of range}} expected-note {{this operation}} expected-note {{used as an index}}
  *P = 0;
}

void lambda(float Width) {
  auto Count = [&](float X) {
    int Bin = int(X / Width); // expected-warning {{an index out of range}} expected-note {{this division}}
    ++Counts[Bin]; // expected-note {{used as an index}}
  };
  Count(1);
}

template <class Number> void inTemplate(Number X, Number W) {
  ++Counts[int(X / W)]; // expected-warning {{an index out of range}} expected-note {{this division}} expected-note {{used as an index}}
}
template void inTemplate(float, float);
template void inTemplate(double, double);

//===----------------------------------------------------------------------===//
// Looked at in between
//===----------------------------------------------------------------------===//

static int clampedBin(float C, float Low, float High) {
  int Bin = (int)(Bins * ((C - Low) / (High - Low)));
  return Bin < Bins ? Bin : Bins - 1;
}
void clamped(float C, float Low, float High) {
  ++Counts[clampedBin(C, Low, High)];
  int Compared = (C - Low) / (High - Low) * Bins;
  if (Compared >= Bins)
    Compared = Bins - 1;
  ++Counts[Compared];
  int Minimum = (C - Low) / (High - Low) * Bins;
  ++Counts[std::min(Minimum, Bins - 1)];
  float Position = (C - Low) / (High - Low);
  Position = std::clamp(Position, 0.0f, 0.99f);
  ++Counts[int(Position * Bins)];
  ++Counts[(int)std::fmin(Bins * ((C - Low) / (High - Low)), Bins - 1)];
  float Fraction = (C - Low) / (High - Low);
  ++Counts[Fraction < 1.0f ? int(Fraction * Bins) : Bins - 1];
  ++Counts[int((C - Low) / High) % Bins];
  ++Counts[int((C - Low) / High) & 7];
  for (int I = int(C / Low); I < Bins; ++I)
    ++Counts[I];
}
bool inRange(int);
void checked(float X, float W, std::map<int, int> &Map) {
  int Bin = int(X / W);
  if (inRange(Bin))
    ++Counts[Bin];
  ++Map[int(X / W)];
}

//===----------------------------------------------------------------------===//
// Nothing that fast math could change
//===----------------------------------------------------------------------===//

void exact(int *P, float U, unsigned N, float V) {
  P[int(U * N)] = 0;            // A random pick.
  P[int(U * 255.0f + 0.5f)] = 0; // A lookup table.
  P[int(V / 4)] = 0;
  P[int(U * N / 256.0f)] = 0;
  P[int(std::sqrt(V))] = 0;
  P[int(1.0f / V)] = 0;
  P[N / 3] = 0;
}
int notAnIndex(float X, float W) { return int(X / W); }
void kept(int *P, float X, float W) {
#pragma clang fp reciprocal(off) reassociate(off)
  P[int(X / W)] = 0;
}
