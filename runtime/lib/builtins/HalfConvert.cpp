//===- HalfConvert.cpp - Half-precision floats in memory ------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// _Float16 is a storage format: it is computed with as float. A half travels
// between functions as the 16 bits that memory holds.
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/builtins/DoubleFormat.h"
#include "runtime/lib/builtins/Libcall.h"

using namespace tp::soft;

constexpr int kHalfMantissaBits = 10;
constexpr int kHalfBias = 15;
constexpr uint16_t kHalfInfinity = 0x7C00;
constexpr uint16_t kHalfNaN = 0x7E00;

/// The half nearest to the number with the unbiased \p Exponent whose
/// \p Significand has its leading bit at the top; to even on a tie.
static uint16_t roundToHalf(int Exponent, uint64_t Significand) {
  if (Exponent > kHalfBias)
    return kHalfInfinity;
  // Below the normal numbers a larger part of the significand is cut off.
  const int BelowNormal = 1 - kHalfBias - Exponent;
  const int Cut = 63 - kHalfMantissaBits + (BelowNormal > 0 ? BelowNormal : 0);
  if (Cut > 64)
    return 0;
  const uint64_t Kept = Cut == 64 ? 0 : Significand >> Cut;
  const uint64_t Rest = Significand << (64 - Cut);
  const uint64_t Tie = uint64_t(1) << 63;
  const bool Up = Rest > Tie || (Rest == Tie && (Kept & 1) != 0);
  // The leading bit of a normal number counts up the exponent, as does a carry
  // out of the mantissa.
  const int Base = BelowNormal > 0 ? 0 : Exponent + kHalfBias - 1;
  return static_cast<uint16_t>((Base << kHalfMantissaBits) +
                               static_cast<int>(Kept) + Up);
}

extern "C" {

uint16_t TP_LIBCALL(__truncdfhf2)(double A) {
  const uint64_t Bits = bits(A);
  const uint64_t Magnitude = Bits & ~kSign;
  const auto Sign = static_cast<uint16_t>(Bits >> 48 & 0x8000);
  if (Magnitude > kInfinity)
    return kHalfNaN;
  if (Magnitude == kInfinity)
    return Sign | kHalfInfinity;
  if (Magnitude == 0)
    return Sign;
  const Unpacked U = unpack(Magnitude);
  return Sign | roundToHalf(U.Exponent - kBias, U.Significand);
}

uint16_t TP_LIBCALL(__truncsfhf2)(float A) {
  // Every float is a double: the only rounding is the second one.
  return TP_LIBCALL(__truncdfhf2)(TP_LIBCALL(__extendsfdf2)(A));
}

float TP_LIBCALL(__extendhfsf2)(uint16_t A) {
  constexpr int Shift = 23 - kHalfMantissaBits;
  const uint32_t Sign = static_cast<uint32_t>(A & 0x8000) << 16;
  const uint32_t Magnitude = A & 0x7FFF;
  if (Magnitude >= kHalfInfinity)
    return __builtin_bit_cast(float, Sign | 0x7F800000 | Magnitude << Shift);
  // The exponent is off by the difference of the biases; multiplying by a power
  // of two mends it, exactly, for subnormal halves too.
  const float Scale = __builtin_bit_cast(float, (254u - kHalfBias) << 23);
  const float Scaled = __builtin_bit_cast(float, Magnitude << Shift) * Scale;
  return __builtin_bit_cast(float, Sign | __builtin_bit_cast(uint32_t, Scaled));
}

} // extern "C"
