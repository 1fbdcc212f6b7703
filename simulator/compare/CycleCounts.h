//===- CycleCounts.h - Where thread-cycles went -----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_COMPARE_CYCLECOUNTS_H
#define TP_SIMULATOR_COMPARE_CYCLECOUNTS_H

#include "simulator/stats/RunSummary.h"

#include <array>
#include <cstdint>

namespace tp {

/// A thread-cycle was used to issue an instruction or lost for one reason.
inline constexpr unsigned NumCycleUses = NumLosses + 1;

/// Thread-cycles by use: entry 0 those in which an instruction was issued,
/// entry 1 + L those lost to Loss(L). Differences are negative.
using CycleCounts = std::array<int64_t, NumCycleUses>;

/// `issued` or the name of the loss.
inline const char *cycleUseName(unsigned Use) {
  return Use == 0 ? "issued" : lossName(Loss(Use - 1));
}

/// The entry of a loss.
constexpr unsigned useOf(Loss Reason) { return 1 + unsigned(Reason); }

/// Adds each entry of \p Other.
inline void add(CycleCounts &Counts, const CycleCounts &Other) {
  for (unsigned Use = 0; Use != NumCycleUses; ++Use)
    Counts[Use] += Other[Use];
}

/// All thread-cycles.
inline int64_t sumOf(const CycleCounts &Counts) {
  int64_t Sum = 0;
  for (int64_t Cycles : Counts)
    Sum += Cycles;
  return Sum;
}

} // namespace tp

#endif // TP_SIMULATOR_COMPARE_CYCLECOUNTS_H
