//===- FloatParts.h - Bits of a float ---------------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_RUNTIME_LIB_MATH_FLOATPARTS_H
#define TP_RUNTIME_LIB_MATH_FLOATPARTS_H

#include "runtime/lib/math/PairArithmetic.h"
#include "tp/math.h"
#include <stdint.h>

namespace tp {

inline constexpr uint32_t kFloatSign = 0x80000000u;
inline constexpr uint32_t kFloatInfinity = 0x7F800000u;
inline constexpr uint32_t kFloatOne = 0x3F800000u;

inline uint32_t floatBits(float X) { return __builtin_bit_cast(uint32_t, X); }
inline float floatFromBits(uint32_t Bits) {
  return __builtin_bit_cast(float, Bits);
}
inline float floatNaN() { return floatFromBits(0x7FC00000u); }
inline float floatInfinity() { return floatFromBits(kFloatInfinity); }

/// 2 to the \p Exponent, which is in [-126, 127].
inline float powerOfTwo(int Exponent) {
  return floatFromBits(static_cast<uint32_t>(Exponent + 127) << 23);
}

/// \p X * 2^\p Exponent for \p X in [0.5, 2] and any exponent in [-252, 252],
/// rounded once.
inline float scale(float X, int Exponent) {
  if (Exponent > 126)
    return X * powerOfTwo(Exponent - 126) * powerOfTwo(126);
  if (Exponent < -125)
    return X * powerOfTwo(Exponent + 126) * powerOfTwo(-126);
  return X * powerOfTwo(Exponent);
}

using FloatPair = Pair<float>;

/// \p X times 2 to the \p Exponent taken apart so that the result is in
/// [sqrt(1/2), sqrt(2)). \p Bits are those of a finite number above 0.
inline float splitAroundOne(uint32_t Bits, int &Exponent) {
  Exponent = 0;
  if (Bits < 0x00800000u) {
    Bits = floatBits(floatFromBits(Bits) * 0x1p23f);
    Exponent = -23;
  }
  // The bits of sqrt(1/2), so that the exponent counts from there.
  constexpr uint32_t Start = 0x3F3504F3u;
  uint32_t FromStart = Bits - Start;
  Exponent += static_cast<int32_t>(FromStart) >> 23;
  return floatFromBits((FromStart & 0x007FFFFFu) + Start);
}

/// Base-2 logarithm to about 2^-33 of itself, of \p Bits as above. When the
/// result is 0 or its exponent part is not, the error is of that size against
/// the whole.
FloatPair logarithm2(uint32_t Bits);

/// Natural logarithm of a finite number above 0.
FloatPair logarithm(FloatPair X);

/// e^\p X times 2 to the \p Shift in [-2, 2], rounded once; for any number.
float exponential(float X, int Shift);

/// e^\p X - 1 for \p X in [-40, 40], to about 2^-28 of itself.
FloatPair exponentialMinus1(float X);

} // namespace tp

#endif // TP_RUNTIME_LIB_MATH_FLOATPARTS_H
