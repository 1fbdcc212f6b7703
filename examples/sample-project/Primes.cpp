//===- Primes.cpp - Counts prime numbers on all threads -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Prints how many prime numbers are below 100,000. With an argument it fails if
// that is another number.
//
//===----------------------------------------------------------------------===//

#include "Sieve.h"

#include "tp/atomic.h"
#include "tp/barrier.h"
#include "tp/thread.h"

#include <cstdio>
#include <cstdlib>

namespace {
// Global memory: one copy, seen by all threads.
uint32_t NextSieve;
uint32_t Primes;
} // namespace

int main(int ArgumentCount, char **Arguments) {
  constexpr uint32_t Sieves = 100;
  for (uint32_t I; (I = tp::atomicAdd(&NextSieve, 1)) < Sieves;)
    tp::atomicAdd(&Primes, countPrimes(I * kSieveLength));
  tp::barrier();
  if (tp::threadId() != 0)
    return 0;
  std::printf("%u\n", unsigned(Primes));
  if (ArgumentCount < 2)
    return 0;
  return Primes == uint32_t(std::atoi(Arguments[1])) ? 0 : 1;
}
