//===- csmith.h - What csmith's programs include ----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Stands in for csmith's header of this name: needs no C library, so that a
// program is compiled quickly and for any target.
//
//===----------------------------------------------------------------------===//

#ifndef TP_FUZZ_COMPILER_CSMITH_H
#define TP_FUZZ_COMPILER_CSMITH_H

#include "report.h"
#include <float.h>

#define CHAR_BIT __CHAR_BIT__
#define INT_MAX __INT_MAX__
#define INT_MIN (-INT_MAX - 1)
#define fabsf __builtin_fabsf
#define fabs __builtin_fabs
#define STATIC static
#define UNDEFINED(Value) (Value)
#define LOG_INDEX
#define LOG_EXEC
#define COUNT(Number)
#define FUNC_NAME(Name) (safe_##Name)
#include <csmith/safe_math.h>
#undef FUNC_NAME
#define _CSMITH_BITFIELD(Bits) ((Bits) > 32 ? (Bits) % 32 : (Bits))

static uint32_t crc32_context = 0xFFFFFFFFu;

static inline void crc32_gentab(void) {}

static inline void platform_main_begin(void) {}

static inline void transparent_crc(uint64_t Value, const char *Name, int Flag) {
  (void)Name;
  (void)Flag;
  crc32_context = addToChecksum(crc32_context, Value);
}

static inline void transparent_crc_bytes(char *Bytes, int Count,
                                         const char *Name, int Flag) {
  for (int I = 0; I < Count; ++I)
    transparent_crc((uint8_t)Bytes[I], Name, Flag);
}

static inline void platform_main_end(uint32_t Checksum, int Flag) {
  (void)Flag;
  report(Checksum);
}

static inline int strcmp(const char *Left, const char *Right) {
  while (*Left && *Left == *Right) {
    ++Left;
    ++Right;
  }
  return (uint8_t)*Left - (uint8_t)*Right;
}

#endif // TP_FUZZ_COMPILER_CSMITH_H
