//===- BrainFloatConvert.cpp - The upper halves of floats in memory -------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// __bf16 is a storage format: the upper 16 bits of a float. A number travels
// between functions as the 16 bits that memory holds.
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/builtins/DoubleFormat.h"
#include "runtime/lib/builtins/Libcall.h"

using namespace tp::soft;

extern "C" {

uint16_t TP_LIBCALL(__truncsfbf2)(float A) {
  uint32_t Bits = bits(A);
  if ((Bits & 0x7FFFFFFF) > 0x7F800000)
    return static_cast<uint16_t>(Bits >> 16 | 0x40);
  // To the nearest, ties to even; a carry may go through to infinity.
  return static_cast<uint16_t>((Bits + 0x7FFF + (Bits >> 16 & 1)) >> 16);
}

uint16_t TP_LIBCALL(__truncdfbf2)(double A) {
  // The float in between is cut off, not rounded; its lowest bit says whether
  // anything was lost, so that the second step rounds right.
  uint64_t Bits = bits(A);
  uint32_t Sign = tp::wide::high(Bits) & 0x80000000;
  uint64_t Magnitude = Bits & ~kSign;
  if (Magnitude > kInfinity)
    return static_cast<uint16_t>(Sign >> 16 | 0x7FC0);
  constexpr uint64_t Largest = uint64_t(kBias + 128) << 52;
  if (Magnitude >= Largest)
    return static_cast<uint16_t>(Sign >> 16 | 0x7F80);
  if (Magnitude == 0)
    return static_cast<uint16_t>(Sign >> 16);
  Unpacked U = unpack(Magnitude);
  int Exponent = U.Exponent - kBias + kFloatBias;
  uint64_t Significand = U.Significand;
  if (Exponent <= 0) {
    Significand = tp::wide::shiftRightSticky(Significand, 1 - Exponent);
    Exponent = 1;
  }
  uint32_t Float = (static_cast<uint32_t>(Exponent - 1) << 23) +
                   static_cast<uint32_t>(Significand >> 40);
  bool Lost = Significand << 24 != 0;
  return TP_LIBCALL(__truncsfbf2)(fromBits(Sign | Float | Lost));
}

} // extern "C"
