//===- DoubleFormat.h - IEEE formats taken apart and put together -*- C++ -*-=//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Numbers between their formats are a sign, an exponent biased as in the
// format, and a 64-bit significand whose top bit is set and stands for 1.
//
//===----------------------------------------------------------------------===//

#ifndef TP_RUNTIME_LIB_BUILTINS_DOUBLEFORMAT_H
#define TP_RUNTIME_LIB_BUILTINS_DOUBLEFORMAT_H

#include "runtime/lib/builtins/WideInteger.h"

namespace tp::soft {

inline constexpr uint64_t kSign = uint64_t(1) << 63;
inline constexpr uint64_t kInfinity = uint64_t(0x7FF) << 52;
/// The one NaN that arithmetic makes.
inline constexpr uint64_t kNaN = uint64_t(0x7FF8) << 48;
inline constexpr int kBias = 1023;
inline constexpr int kMaxExponent = 0x7FF;
inline constexpr int kFloatBias = 127;
inline constexpr int kFloatMaxExponent = 0xFF;

inline uint64_t bits(double Value) {
  return __builtin_bit_cast(uint64_t, Value);
}
inline uint32_t bits(float Value) {
  return __builtin_bit_cast(uint32_t, Value);
}
inline double fromBits(uint64_t Bits) {
  return __builtin_bit_cast(double, Bits);
}
inline float fromBits(uint32_t Bits) { return __builtin_bit_cast(float, Bits); }

/// A finite number that is not 0.
struct Unpacked {
  int Exponent;
  uint64_t Significand;
};

/// Takes \p Magnitude apart, the bits of a finite double above 0.
inline Unpacked unpack(uint64_t Magnitude) {
  int Exponent = static_cast<int>(wide::high(Magnitude) >> 20);
  uint64_t Significand = Magnitude << 11;
  if (Exponent != 0)
    return {Exponent, Significand | kSign};
  int Shift = wide::leadingZeros(Significand);
  return {1 - Shift, Significand << Shift};
}

/// The same for a float's bits; the exponent keeps the float's bias.
inline Unpacked unpackFloat(uint32_t Magnitude) {
  int Exponent = static_cast<int>(Magnitude >> 23);
  uint32_t Significand = Magnitude << 8;
  if (Exponent != 0)
    return {Exponent, wide::make(Significand | 0x80000000u, 0)};
  int Shift = __builtin_clz(Significand);
  return {1 - Shift, wide::make(Significand << Shift, 0)};
}

/// The double nearest to the number, ties to the even one. The lowest bit of
/// \p Significand stands for everything below it, too. \p Sign is 0 or kSign.
inline uint64_t pack(uint64_t Sign, int Exponent, uint64_t Significand) {
  if (Exponent >= kMaxExponent)
    return Sign | kInfinity;
  if (Exponent <= 0) {
    Significand = wide::shiftRightSticky(Significand, 1 - Exponent);
    Exponent = 1;
  }
  // The significand's leading 1, where there is one, counts the exponent up.
  uint64_t Result = wide::make(static_cast<uint32_t>(Exponent - 1) << 20, 0) +
                    (Significand >> 11);
  uint32_t Rest = wide::low(Significand) & 0x7FF;
  if (Rest > 0x400 || (Rest == 0x400 && (Result & 1)))
    ++Result;
  return Sign | Result;
}

/// The same for a float; \p Exponent has the float's bias, \p Sign is 0 or the
/// float's sign bit.
inline uint32_t packFloat(uint32_t Sign, int Exponent, uint64_t Significand) {
  if (Exponent >= kFloatMaxExponent)
    return Sign | 0x7F800000u;
  uint32_t Upper =
      wide::high(Significand) | (wide::low(Significand) != 0 ? 1 : 0);
  if (Exponent <= 0) {
    int Shift = 1 - Exponent;
    Upper =
        Shift > 31 ? 1 : Upper >> Shift | (Upper << (32 - Shift) != 0 ? 1 : 0);
    Exponent = 1;
  }
  uint32_t Result = (static_cast<uint32_t>(Exponent - 1) << 23) + (Upper >> 8);
  uint32_t Rest = Upper & 0xFF;
  if (Rest > 0x80 || (Rest == 0x80 && (Result & 1)))
    ++Result;
  return Sign | Result;
}

} // namespace tp::soft

#endif // TP_RUNTIME_LIB_BUILTINS_DOUBLEFORMAT_H
