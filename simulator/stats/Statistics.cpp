//===- Statistics.cpp - What a simulation counts --------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/stats/Statistics.h"

#include <numeric>

namespace tp {

uint64_t Statistics::instructions() const {
  return std::accumulate(Executed.begin(), Executed.end(), uint64_t(0));
}

uint64_t Statistics::lost(Loss Reason) const {
  uint64_t Sum = 0;
  for (const ThreadStatistics &Thread : Threads)
    Sum += Thread.Lost[unsigned(Reason)];
  return Sum;
}

} // namespace tp
