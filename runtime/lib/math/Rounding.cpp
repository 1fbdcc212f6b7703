//===- Rounding.cpp - Floats to whole numbers, exact remainders -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/math/FloatParts.h"

namespace tp {

/// From here on every float is whole; NaN counts as such.
static inline bool isWhole(float X) { return !(fabs(X) < 0x1p23f); }

/// A NaN's quiet form, or \p X itself.
static inline float wholeResult(float X) { return X != X ? floatNaN() : X; }

float trunc(float X) {
  if (isWhole(X))
    return wholeResult(X);
  return copysign(static_cast<float>(static_cast<int32_t>(X)), X);
}

float floor(float X) {
  if (isWhole(X))
    return wholeResult(X);
  float Whole = static_cast<float>(static_cast<int32_t>(X));
  return copysign(Whole > X ? Whole - 1.0f : Whole, X);
}

float ceil(float X) {
  if (isWhole(X))
    return wholeResult(X);
  float Whole = static_cast<float>(static_cast<int32_t>(X));
  return copysign(Whole < X ? Whole + 1.0f : Whole, X);
}

float round(float X) {
  if (isWhole(X))
    return wholeResult(X);
  float Magnitude = fabs(X);
  float Whole = static_cast<float>(static_cast<int32_t>(Magnitude));
  return copysign(Magnitude - Whole >= 0.5f ? Whole + 1.0f : Whole, X);
}

float rint(float X) {
  if (isWhole(X))
    return wholeResult(X);
  // The sum has no bits left for a fraction.
  return copysign((fabs(X) + 0x1p23f) - 0x1p23f, X);
}

float fmod(float X, float Y) {
  uint32_t Dividend = floatBits(X) & ~kFloatSign;
  uint32_t Divisor = floatBits(Y) & ~kFloatSign;
  uint32_t Sign = floatBits(X) & kFloatSign;
  if (Dividend >= kFloatInfinity || Divisor > kFloatInfinity || Divisor == 0)
    return floatNaN();
  if (Dividend < Divisor)
    return X;
  if (Dividend == Divisor)
    return floatFromBits(Sign);
  uint32_t ExponentX = Dividend >> 23;
  uint32_t ExponentY = Divisor >> 23;
  uint32_t Rest = Dividend & 0x007FFFFFu;
  uint32_t Unit = Divisor & 0x007FFFFFu;
  if (ExponentX != 0)
    Rest |= 0x00800000u;
  else
    ExponentX = 1;
  if (ExponentY != 0)
    Unit |= 0x00800000u;
  else
    ExponentY = 1;
  uint32_t Shift = ExponentX - ExponentY;
  Rest %= Unit;
  for (; Shift >= 8; Shift -= 8)
    Rest = (Rest << 8) % Unit;
  Rest = (Rest << Shift) % Unit;
  if (Rest == 0)
    return floatFromBits(Sign);
  // Rest counts units of the divisor's last place.
  uint32_t Lift = static_cast<uint32_t>(__builtin_clz(Rest)) - 8;
  if (Lift >= ExponentY)
    return floatFromBits(Sign | Rest << (ExponentY - 1));
  return floatFromBits(Sign |
                       (((ExponentY - Lift - 1) << 23) + (Rest << Lift)));
}

float ldexp(float X, int Exponent) {
  // Two steps that are exact unless they overflow, then one that rounds.
  if (Exponent > 127) {
    X *= 0x1p127f;
    Exponent -= 127;
    if (Exponent > 127) {
      X *= 0x1p127f;
      Exponent -= 127;
      if (Exponent > 127)
        Exponent = 127;
    }
  } else if (Exponent < -126) {
    // Keeps 24 bits above the subnormal range until the last step.
    X *= 0x1p-102f;
    Exponent += 102;
    if (Exponent < -126) {
      X *= 0x1p-102f;
      Exponent += 102;
      if (Exponent < -126)
        Exponent = -126;
    }
  }
  return X * powerOfTwo(Exponent);
}

} // namespace tp
