//===- ExecutionRecord.h - What a recorded run knows more -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_STATS_EXECUTIONRECORD_H
#define TP_SIMULATOR_STATS_EXECUTIONRECORD_H

#include "simulator/stats/Statistics.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace tp {

/// A function of the text as it was called through one chain of calls. One that
/// was called while it was in its own chain is the function there.
struct CalledFunction {
  /// Its first word in the text.
  uint32_t Entry = 0;
  /// The caller, an earlier element, and its word that called; nothing for
  /// functions of which no call was seen.
  std::optional<uint32_t> Caller;
  uint32_t CallSite = 0;
  uint64_t Calls = 0;
  /// What threads did in it, without what it called. Loss::Finished is 0.
  uint64_t Instructions = 0;
  LossCounts Lost{};
};

/// What an ExecutionRecorder has recorded.
struct ExecutionRecord {
  /// One per word of the text.
  std::vector<MemoryBehaviour> Pcs;
  /// In the order of their chains of calls.
  std::vector<CalledFunction> Calls;
  /// There were so many chains of calls that in the longest ones functions
  /// count for their callers.
  bool IsCallTreeCut = false;
};

} // namespace tp

#endif // TP_SIMULATOR_STATS_EXECUTIONRECORD_H
