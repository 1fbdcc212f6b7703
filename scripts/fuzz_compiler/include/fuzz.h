//===- fuzz.h - What generated C++ programs use -----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Operations that are defined for all operands, and checksums of values. What
// a target may choose, like a NaN's bits, has one value here.
//
//===----------------------------------------------------------------------===//

#ifndef TP_FUZZ_COMPILER_FUZZ_H
#define TP_FUZZ_COMPILER_FUZZ_H

#include "report.h"
#include <stdarg.h>
#include <stddef.h>

#define NOINLINE __attribute__((noinline))
#define ALWAYS_INLINE inline __attribute__((always_inline))
#define PACKED __attribute__((packed))

#ifdef __tp__
#define THREAD_LOCAL thread_local
#else
#define THREAD_LOCAL
#endif

template <typename To, typename From> inline To bitCast(From Value) {
  static_assert(sizeof(To) == sizeof(From));
  To Result;
  __builtin_memcpy(&Result, &Value, sizeof(To));
  return Result;
}

#ifdef __tp__
using half = _Float16;
inline uint16_t halfBits(half Value) { return bitCast<uint16_t>(Value); }
#else
/// Binary16 in integer arithmetic, rounded to the nearest, ties to even.
class half {
public:
  half() = default;
  template <typename T> explicit half(T Value) : Bits(round((double)Value)) {}
  operator float() const { return (float)(double)*this; }
  explicit operator double() const {
    double Magnitude;
    int Exponent = Bits >> 10 & 31;
    int Fraction = Bits & 1023;
    if (Exponent == 31)
      Magnitude = Fraction ? __builtin_nan("") : __builtin_inf();
    else if (Exponent == 0)
      Magnitude = Fraction * 0x1p-24;
    else
      Magnitude = (Fraction + 1024) * 0x1p-25 * (double)(1ull << Exponent);
    return Bits >> 15 ? -Magnitude : Magnitude;
  }
  friend uint16_t halfBits(half Value) { return Value.Bits; }

private:
  static uint16_t round(double Value) {
    uint16_t Sign = (uint16_t)(bitCast<uint64_t>(Value) >> 63 << 15);
    double Magnitude = __builtin_fabs(Value);
    if (Value != Value)
      return 0x7e00;
    if (Magnitude >= 65520)
      return Sign | 0x7c00;
    int Exponent = 1;
    double Unit = 0x1p-24;
    while (Magnitude >= Unit * 2048) {
      Unit *= 2;
      ++Exponent;
    }
    double Scaled = Magnitude / Unit;
    int Fraction = (int)Scaled;
    double Rest = Scaled - Fraction;
    if (Rest > 0.5 || (Rest == 0.5 && (Fraction & 1)))
      ++Fraction;
    return (uint16_t)(Sign | (((Exponent - 1) << 10) + Fraction));
  }
  uint16_t Bits;
};
#endif

template <typename T> inline T divide(T Left, T Right) {
  if (Right == 0)
    return Left;
  if ((T)-1 < 0 && Right == (T)-1)
    return (T)(0 - (uint64_t)Left);
  return (T)(Left / Right);
}

template <typename T> inline T remainderOf(T Left, T Right) {
  if (Right == 0 || ((T)-1 < 0 && Right == (T)-1))
    return 0;
  return (T)(Left % Right);
}

template <typename T, typename F> inline T toInteger(F Value) {
  const bool Signed = (T)-1 < 0;
  const F Limit = (F)((uint64_t)1 << (sizeof(T) * 8 - 1)) * (Signed ? 1 : 2);
  if (Signed)
    return Value >= -Limit && Value < Limit ? (T)Value : (T)7;
  return Value > -1 && Value < Limit ? (T)Value : (T)9;
}

inline uint32_t bits(float Value) {
  return Value != Value ? 0x7fc00000u : bitCast<uint32_t>(Value);
}
inline uint64_t bits(double Value) {
  return Value != Value ? 0x7ff8000000000000u : bitCast<uint64_t>(Value);
}
inline uint16_t bits(half Value) {
  uint16_t Word = halfBits(Value);
  return (Word & 0x7fff) > 0x7c00 ? 0x7e00 : Word;
}
inline float fromBits(uint32_t Word) {
  return (Word & 0x7fffffff) > 0x7f800000 ? 1.5f : bitCast<float>(Word);
}
inline double fromBits(uint64_t Word) {
  return (Word & 0x7fffffffffffffff) > 0x7ff0000000000000
             ? -2.5
             : bitCast<double>(Word);
}

template <typename T> inline T copySign(T Magnitude, T Sign) {
  if (Sign != Sign)
    return Magnitude;
  if constexpr (sizeof(T) == 4)
    return __builtin_copysignf(Magnitude, Sign);
  else
    return __builtin_copysign(Magnitude, Sign);
}

inline int leadingZeros(uint32_t Value) {
  return Value ? __builtin_clz(Value) : 32;
}
inline int leadingZeros(uint64_t Value) {
  return Value ? __builtin_clzll(Value) : 64;
}
inline int trailingZeros(uint32_t Value) {
  return Value ? __builtin_ctz(Value) : 32;
}
inline int trailingZeros(uint64_t Value) {
  return Value ? __builtin_ctzll(Value) : 64;
}

template <typename T> inline T saturatingAdd(T Left, T Right) {
  T Sum;
  return __builtin_add_overflow(Left, Right, &Sum) ? (T)~Left : Sum;
}
template <typename T> inline T saturatingSub(T Left, T Right) {
  T Difference;
  return __builtin_sub_overflow(Left, Right, &Difference) ? (T)~Right
                                                          : Difference;
}
template <typename T> inline T saturatingMul(T Left, T Right) {
  T Product;
  return __builtin_mul_overflow(Left, Right, &Product) ? (T)(Left ^ Right)
                                                       : Product;
}

inline void mix(uint32_t &Checksum, uint64_t Value) {
  Checksum = addToChecksum(Checksum, Value);
}
inline void mix(uint32_t &Checksum, float Value) {
  mix(Checksum, (uint64_t)bits(Value));
}
inline void mix(uint32_t &Checksum, double Value) {
  mix(Checksum, bits(Value));
}
inline void mix(uint32_t &Checksum, half Value) {
  mix(Checksum, (uint64_t)bits(Value));
}
#define MIX_INTEGER(TYPE)                                                      \
  inline void mix(uint32_t &Checksum, TYPE Value) {                            \
    mix(Checksum, (uint64_t)Value);                                            \
  }
MIX_INTEGER(bool)
MIX_INTEGER(int8_t)
MIX_INTEGER(uint8_t)
MIX_INTEGER(int16_t)
MIX_INTEGER(uint16_t)
MIX_INTEGER(int32_t)
MIX_INTEGER(uint32_t)
MIX_INTEGER(int64_t)
#undef MIX_INTEGER

/// Of an object's bytes, padding included.
inline void mixBytes(uint32_t &Checksum, const void *Object, size_t Bytes) {
  for (size_t I = 0; I != Bytes; ++I)
    mix(Checksum, ((const uint8_t *)Object)[I]);
}

// A freestanding C++ compiler mangles its name.
int main() __asm__("main");

/// The main checksum.
inline uint32_t Total = 0x2545F491;

#endif // TP_FUZZ_COMPILER_FUZZ_H
