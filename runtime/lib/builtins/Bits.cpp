//===- Bits.cpp - Counting and moving bits for the code generator ---------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Written without the compiler's builtins for the same things, which may become
// calls of these functions.
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/builtins/Libcall.h"
#include "runtime/lib/builtins/WideInteger.h"

using namespace tp::wide;

static inline int countLeadingZeros(uint32_t Value) {
  int Count = 0;
  for (int Step = 16; Step != 0; Step >>= 1)
    if (!(Value >> (32 - Step))) {
      Count += Step;
      Value <<= Step;
    }
  return Value ? Count : 32;
}

static inline int countTrailingZeros(uint32_t Value) {
  return Value ? 31 - countLeadingZeros(Value & -Value) : 32;
}

/// Sums neighbouring fields of 1, 2 and 4 bits, then all bytes by a product.
static inline int countOnes(uint32_t Value) {
  Value -= Value >> 1 & 0x55555555;
  Value = (Value & 0x33333333) + (Value >> 2 & 0x33333333);
  Value = (Value + (Value >> 4)) & 0x0F0F0F0F;
  return static_cast<int>(Value * 0x01010101 >> 24);
}

static inline uint32_t swapBytes(uint32_t Value) {
  return Value << 24 | (Value & 0xFF00) << 8 | (Value >> 8 & 0xFF00) |
         Value >> 24;
}

extern "C" {

int TP_LIBCALL(__clzsi2)(uint32_t Value) { return countLeadingZeros(Value); }

int TP_LIBCALL(__clzdi2)(uint64_t Value) {
  return high(Value) ? countLeadingZeros(high(Value))
                     : 32 + countLeadingZeros(low(Value));
}

int TP_LIBCALL(__ctzsi2)(uint32_t Value) { return countTrailingZeros(Value); }

int TP_LIBCALL(__ctzdi2)(uint64_t Value) {
  return low(Value) ? countTrailingZeros(low(Value))
                    : 32 + countTrailingZeros(high(Value));
}

int TP_LIBCALL(__ffssi2)(uint32_t Value) {
  return Value ? 1 + countTrailingZeros(Value) : 0;
}

int TP_LIBCALL(__ffsdi2)(uint64_t Value) {
  return Value ? 1 + TP_LIBCALL(__ctzdi2)(Value) : 0;
}

int TP_LIBCALL(__paritysi2)(uint32_t Value) { return countOnes(Value) & 1; }

int TP_LIBCALL(__paritydi2)(uint64_t Value) {
  return countOnes(high(Value) ^ low(Value)) & 1;
}

int TP_LIBCALL(__popcountsi2)(uint32_t Value) { return countOnes(Value); }

int TP_LIBCALL(__popcountdi2)(uint64_t Value) {
  return countOnes(high(Value)) + countOnes(low(Value));
}

uint32_t TP_LIBCALL(__bswapsi2)(uint32_t Value) { return swapBytes(Value); }

uint64_t TP_LIBCALL(__bswapdi2)(uint64_t Value) {
  return make(swapBytes(low(Value)), swapBytes(high(Value)));
}

} // extern "C"
