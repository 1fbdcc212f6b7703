//===- Trace.h - Instructions that are compiled together --------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_FUNCTIONAL_TRACE_H
#define TP_SIMULATOR_FUNCTIONAL_TRACE_H

#include "simulator/functional/FunctionalCode.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tp {

/// One instruction of a trace.
struct TraceStep {
  /// Number in the text.
  uint32_t Word = 0;
  /// Where a branch or jump goes, or likely goes, if that is known.
  std::optional<uint32_t> Target;
  /// The trace goes on at Target, not at the next word.
  bool FollowsTarget = false;
};

/// A way through the text that is entered at its first step only and may be
/// left at any. If the last step goes to the first one it is a loop.
using Trace = std::vector<TraceStep>;

/// The trace that begins at \p Head: along the more frequent side of each
/// branch, into functions and back to their callers. Empty if the interpreter
/// must do the first instruction. \p Executed says how often each word was
/// executed.
Trace formTrace(const FunctionalSubject &Subject, uint32_t Head,
                std::span<const uint64_t> Executed);

/// The words of the text where a thread may go on after the trace, as far as
/// the text says.
std::vector<uint32_t> exitsOf(const FunctionalSubject &Subject,
                              const Trace &Steps);

} // namespace tp

#endif // TP_SIMULATOR_FUNCTIONAL_TRACE_H
