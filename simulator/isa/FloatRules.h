//===- FloatRules.h - The TP's float arithmetic -----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// IEEE-754 binary32, round to nearest even; every NaN that arithmetic makes is
// the canonical one. Compile what includes this with -ffp-contract=off.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_ISA_FLOATRULES_H
#define TP_SIMULATOR_ISA_FLOATRULES_H

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace tp {

inline constexpr uint32_t CanonicalNaN = 0x7FC00000;
inline constexpr uint32_t FloatSignBit = 0x80000000;

/// The value of a register as an operand of type T sees it, and back.
template <class T> constexpr T fromBits(uint32_t Bits) {
  return std::bit_cast<T>(Bits);
}
template <class T> constexpr uint32_t toBits(T Value) {
  return std::bit_cast<uint32_t>(Value);
}

/// Whether a value is subnormal or zero.
inline bool isBelowNormal(float Value) {
  return std::fabs(Value) < std::numeric_limits<float>::min();
}

/// A subnormal becomes zero of the same sign.
inline float flushSubnormal(float Value) {
  return isBelowNormal(Value) ? std::copysign(0.0f, Value) : Value;
}

/// The canonical NaN for any NaN. In integers: the compiler may give any NaN
/// for a float expression that is one.
inline float canonicalized(float Value) {
  uint32_t Bits = toBits(Value);
  bool IsNaN = (Bits & ~FloatSignBit) > 0x7F800000;
  return fromBits<float>(IsNaN ? CanonicalNaN : Bits);
}

/// What becomes of subnormal operands and results: the chip's option, and
/// whether the code at hand wants to know.
enum class Subnormals : uint8_t {
  Keep,
  /// They become zero.
  Flush,
  /// They would become zero, and the instruction traps.
  Trap,
};

/// What happens to the operands and results of arithmetic, conversion and
/// compare instructions.
template <Subnormals Mode> struct FloatRules {
  static float operand(float Value) {
    return Mode == Subnormals::Keep ? Value : flushSubnormal(Value);
  }
  static float result(float Value) {
    if constexpr (Mode != Subnormals::Keep)
      Value = flushSubnormal(Value);
    return canonicalized(Value);
  }
};

/// IEEE 754-2019 minimumNumber: a NaN loses against a number, -0 < +0.
inline float minimumNumber(float A, float B) {
  if (A != A)
    return B;
  if (A == B)
    return std::signbit(A) ? A : B;
  return B < A ? B : A;
}

/// IEEE 754-2019 maximumNumber: a NaN loses against a number, -0 < +0.
inline float maximumNumber(float A, float B) {
  if (A != A)
    return B;
  if (A == B)
    return std::signbit(A) ? B : A;
  return B > A ? B : A;
}

/// An integral float as int32_t; saturates, NaN gives 0.
inline int32_t saturateToSigned(float Integral) {
  if (Integral != Integral)
    return 0;
  if (Integral >= 0x1p31f)
    return std::numeric_limits<int32_t>::max();
  if (Integral < -0x1p31f)
    return std::numeric_limits<int32_t>::min();
  return int32_t(Integral);
}

/// An integral float as uint32_t; saturates, NaN gives 0.
inline uint32_t saturateToUnsigned(float Integral) {
  if (!(Integral > 0))
    return 0;
  if (Integral >= 0x1p32f)
    return std::numeric_limits<uint32_t>::max();
  return uint32_t(Integral);
}

} // namespace tp

#endif // TP_SIMULATOR_ISA_FLOATRULES_H
