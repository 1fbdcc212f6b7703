//===- UtilisationSampler.h - What each TM does over time -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_PROFILE_UTILISATIONSAMPLER_H
#define TP_SIMULATOR_PROFILE_UTILISATIONSAMPLER_H

#include "simulator/chip/ChipConfig.h"
#include "simulator/core/Archive.h"
#include "simulator/profile/Profile.h"
#include "simulator/stats/Statistics.h"

namespace tp {

/// Collects a bounded number of intervals, whatever the length of the run:
/// whenever there are too many, two and two become one.
class UtilisationSampler {
public:
  explicit UtilisationSampler(const ChipConfig &Chip);

  /// The cycle at which to look next.
  uint64_t nextLook() const { return NextEnd; }

  /// Sees the counts of the run up to now. Those of the first call begin the
  /// first interval; an interval ends with each later call that is not before
  /// nextLook(), and with \p IsLast.
  void look(const Statistics &Now, bool IsLast = false);

  /// What a checkpoint must hold.
  void serialize(Archive &A);

  Utilisation take() { return std::move(Result); }

private:
  void beginAt(const Statistics &Now);
  void addInterval(const Statistics &Now);
  void joinPairs();

  const ChipConfig &Chip;
  const size_t MaxIntervals;
  uint64_t Length;
  uint64_t NextEnd = 0;
  bool HasBegun = false;
  uint64_t Begin = 0;
  std::vector<ThreadStatistics> Before;
  Utilisation Result;
};

} // namespace tp

#endif // TP_SIMULATOR_PROFILE_UTILISATIONSAMPLER_H
