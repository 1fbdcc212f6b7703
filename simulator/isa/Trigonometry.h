//===- Trigonometry.h - sin_s and cos_s -------------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// One algorithm in integers and double, without the host's math library, so
// that every host gets the same bits. The argument is reduced exactly: x times
// 2/pi as an integer product with the bits of 2/pi that matter (Payne and
// Hanek, "Radian reduction for trigonometric functions", 1983).
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_ISA_TRIGONOMETRY_H
#define TP_SIMULATOR_ISA_TRIGONOMETRY_H

#include <bit>
#include <cstdint>
#include <limits>

namespace tp {

namespace trigonometry {

/// x = Quadrant * pi/2 + Remainder, Remainder in [-pi/4, pi/4].
struct Reduced {
  uint32_t Quadrant;
  double Remainder;
};

/// The 64 bits of 2/pi from bit \p First after the binary point on; bits before
/// the point are 0.
inline uint64_t twoOverPiBits(int First) {
  constexpr uint64_t Digits[] = {0xa2f9836e4e441529, 0xfc2757d1f534ddc0,
                                 0xdb6295993c439041, 0xfe5163abdebbc561};
  if (First < 0)
    return First <= -64 ? 0 : Digits[0] >> -First;
  unsigned Word = unsigned(First) / 64, Bit = unsigned(First) % 64;
  uint64_t Bits = Digits[Word] << Bit;
  return Bit == 0 ? Bits : Bits | Digits[Word + 1] >> (64 - Bit);
}

/// Reduces |Value|, which is finite.
inline Reduced reduce(float Value) {
  uint32_t Bits = std::bit_cast<uint32_t>(Value) & 0x7FFFFFFF;
  double Magnitude = double(std::bit_cast<float>(Bits));
  if (Magnitude <= 0x1.921fb54442d18p-1) // pi/4
    return {0, Magnitude};
  // Value = Mantissa * 2^Exponent with 24 bits of mantissa. The bits of 2/pi *
  // 2^Exponent that are worth 4 and more make whole turns; of the others 128
  // are used.
  uint32_t Mantissa = (Bits & 0x7FFFFF) | 0x800000;
  int Exponent = int(Bits >> 23) - 150;
  unsigned __int128 Window = (unsigned __int128)twoOverPiBits(Exponent - 2)
                                 << 64 |
                             twoOverPiBits(Exponent + 62);
  // Modulo 4: two bits of quadrant, then 126 bits of fraction.
  unsigned __int128 Turns = Window * Mantissa;
  bool RoundsUp = Turns >> 125 & 1;
  uint32_t Quadrant = uint32_t(Turns >> 126) + RoundsUp;
  // The fraction in [-1/2, 1/2) as a multiple of 2^-128.
  double Remainder =
      double(__int128(Turns << 2)) * (0x1.921fb54442d18p+0 * 0x1p-128);
  return {Quadrant & 3, Remainder};
}

/// Sine for |X| <= pi/4: Taylor's series, truncated below 2^-50 relative.
inline double sineNearZero(double X) {
  double S = X * X;
  double P = -1.0 / 1307674368000.0;
  P = P * S + 1.0 / 6227020800.0;
  P = P * S - 1.0 / 39916800.0;
  P = P * S + 1.0 / 362880.0;
  P = P * S - 1.0 / 5040.0;
  P = P * S + 1.0 / 120.0;
  P = P * S - 1.0 / 6.0;
  return X + X * S * P;
}

/// Cosine for |X| <= pi/4: Taylor's series, truncated below 2^-50.
inline double cosineNearZero(double X) {
  double S = X * X;
  double P = 1.0 / 20922789888000.0;
  P = P * S - 1.0 / 87178291200.0;
  P = P * S + 1.0 / 479001600.0;
  P = P * S - 1.0 / 3628800.0;
  P = P * S + 1.0 / 40320.0;
  P = P * S - 1.0 / 720.0;
  P = P * S + 1.0 / 24.0;
  P = P * S - 0.5;
  return 1.0 + S * P;
}

/// Sine of Quadrant * pi/2 + Remainder.
inline double sineOf(Reduced Angle) {
  double Value = Angle.Quadrant & 1 ? cosineNearZero(Angle.Remainder)
                                    : sineNearZero(Angle.Remainder);
  return Angle.Quadrant & 2 ? -Value : Value;
}

inline bool isFinite(float Value) {
  return (std::bit_cast<uint32_t>(Value) & 0x7F800000) != 0x7F800000;
}

} // namespace trigonometry

/// Sine within 1 ulp; NaN for infinities and NaN.
inline float sine(float X) {
  if (!trigonometry::isFinite(X))
    return std::numeric_limits<float>::quiet_NaN();
  if (X == 0)
    return X;
  float Value = float(trigonometry::sineOf(trigonometry::reduce(X)));
  return X < 0 ? -Value : Value;
}

/// Cosine within 1 ulp; NaN for infinities and NaN.
inline float cosine(float X) {
  if (!trigonometry::isFinite(X))
    return std::numeric_limits<float>::quiet_NaN();
  trigonometry::Reduced Angle = trigonometry::reduce(X);
  ++Angle.Quadrant;
  return float(trigonometry::sineOf(Angle));
}

} // namespace tp

#endif // TP_SIMULATOR_ISA_TRIGONOMETRY_H
