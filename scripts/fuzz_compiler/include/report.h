//===- report.h - A program's only output -----------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_FUZZ_COMPILER_REPORT_H
#define TP_FUZZ_COMPILER_REPORT_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// Prints \p Checksum, each call in a line of its own.
void report(uint32_t Checksum);

#ifdef __cplusplus
}
#endif

static inline uint32_t addToChecksum(uint32_t Checksum, uint64_t Value) {
  Checksum = (Checksum ^ (uint32_t)Value) * 0x9E3779B1u;
  Checksum ^= Checksum >> 15;
  Checksum = (Checksum ^ (uint32_t)(Value >> 32)) * 0x85EBCA77u;
  return Checksum ^ Checksum >> 13;
}

#endif // TP_FUZZ_COMPILER_REPORT_H
