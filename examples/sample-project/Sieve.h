//===- Sieve.h - Prime numbers of an interval -------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef SAMPLE_SIEVE_H
#define SAMPLE_SIEVE_H

#include <cstdint>

/// Numbers of one call of countPrimes().
inline constexpr uint32_t kSieveLength = 1000;

/// How many of the kSieveLength numbers from \p Begin, below 2^20, are prime.
uint32_t countPrimes(uint32_t Begin);

#endif // SAMPLE_SIEVE_H
