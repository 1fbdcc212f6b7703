// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Programs whose first argument says what they do.
#pragma once

#include <stdint.h>
#include <string.h>

#define NOINLINE __attribute__((noinline))

// A value that the compiler does not know.
template <typename T> NOINLINE T hidden(uint64_t Bits) {
  volatile uint64_t Shown = Bits;
  if constexpr (sizeof(T) == 4)
    return __builtin_bit_cast(T, uint32_t(Shown));
  else
    return __builtin_bit_cast(T, uint64_t(Shown));
}
inline float floatOf(uint32_t Bits) { return hidden<float>(Bits); }
inline double doubleOf(uint64_t Bits) { return hidden<double>(Bits); }

constexpr uint32_t NaN = 0x7FC00000, Infinity = 0x7F800000;

#define CASE(Name, Statement)                                                  \
  if (!strcmp(Case, Name)) {                                                   \
    Statement;                                                                 \
    return 0;                                                                  \
  }
