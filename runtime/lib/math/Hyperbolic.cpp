//===- Hyperbolic.cpp - Hyperbolic functions and roots of floats --------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/math/FloatParts.h"
#include "runtime/lib/math/HyperbolicFunctions.h"

namespace tp {

template <> struct Precision<float> {
  static constexpr float Tiny = 0x1p-25f;
  static constexpr float Small = 0x1p-13f;
  static constexpr float Large = 20.0f;
  static constexpr int CubeRootSteps = 1;
  static constexpr FloatPair Ln2 = {0x1.62e430p-1f, -0x1.05c610p-29f};
  static float infinity() { return floatInfinity(); }
  static float nan() { return floatNaN(); }
  static float magnitude(float X) { return fabs(X); }
  static float squareRoot(float X) { return sqrt(X); }
};

float expm1(float X) { return expMinus1(X); }
float log1p(float X) { return logOf1Plus(X); }
float sinh(float X) { return copysign(hyperbolicSine(fabs(X)), X); }
float cosh(float X) { return hyperbolicCosine(fabs(X)); }
float tanh(float X) { return copysign(hyperbolicTangent(fabs(X)), X); }
float asinh(float X) { return copysign(areaSine(fabs(X)), X); }
float acosh(float X) { return areaCosine(X); }
float atanh(float X) { return copysign(areaTangent(fabs(X)), X); }

float cbrt(float X) {
  uint32_t Magnitude = floatBits(X) & ~kFloatSign;
  if (Magnitude == 0 || Magnitude >= kFloatInfinity)
    return X;
  int Exponent = 0;
  if (Magnitude < 0x00800000u) {
    Magnitude = floatBits(floatFromBits(Magnitude) * 0x1p24f);
    Exponent = -24;
  }
  Exponent += static_cast<int>(Magnitude >> 23) - 126;
  // Rounded down, for negative exponents too.
  int Third = (Exponent + 300) / 3 - 100;
  float Fraction = floatFromBits((Magnitude & 0x007FFFFFu) | 0x3F000000u);
  float Root = cubeRoot(Fraction * powerOfTwo(Exponent - 3 * Third));
  return copysign(Root * powerOfTwo(Third), X);
}

} // namespace tp
