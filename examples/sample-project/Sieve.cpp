//===- Sieve.cpp - Prime numbers of an interval ---------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "Sieve.h"

#include <algorithm>
#include <array>

uint32_t countPrimes(uint32_t Begin) {
  std::array<bool, kSieveLength> IsPrime;
  IsPrime.fill(true);
  const uint32_t End = Begin + kSieveLength;
  for (uint32_t Number = Begin; Number < std::min(End, 2u); ++Number)
    IsPrime[Number - Begin] = false;
  for (uint32_t Factor = 2; Factor * Factor < End; ++Factor) {
    const uint32_t FirstInside = (Begin + Factor - 1) / Factor * Factor;
    for (uint32_t Multiple = std::max(Factor * Factor, FirstInside);
         Multiple < End; Multiple += Factor)
      IsPrime[Multiple - Begin] = false;
  }
  return std::count(IsPrime.begin(), IsPrime.end(), true);
}
