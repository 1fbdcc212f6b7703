//===- Segment.h - Instructions that are compiled together ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_JIT_SEGMENT_H
#define TP_SIMULATOR_JIT_SEGMENT_H

#include "simulator/core/CodeGenerator.h"
#include "simulator/jit/ControlFlow.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tp {

/// One instruction of a segment.
struct SegmentStep {
  /// Number in the text.
  uint32_t Word = 0;
  /// The next step is the instruction's target, not the next word.
  bool FollowsTarget = false;
};

/// A way through the text: it is entered at its first step only and may be left
/// at any.
using Segment = std::vector<SegmentStep>;

/// The longest segment. A thread that a window's end stops within one goes on
/// in the interpreter to the segment's end: longer ones leave more to it.
inline constexpr size_t MaxSegmentSteps = 8;

/// The segment that begins at \p Head: along the hotter side of each branch, up
/// to where another or another line of the instruction cache begins, to what
/// only the interpreter does, and to the first use of what it has itself loaded
/// from other than the stack: there a thread will likely sleep, and a segment
/// begins where it wakes up. Empty if the interpreter must do the first
/// instruction. \p ExecutedAt says how often each word was executed, \p IsHead
/// where segments begin.
Segment formSegment(const CodeSubject &Subject, uint32_t Head,
                    std::span<const uint64_t> ExecutedAt,
                    const std::vector<bool> &IsHead);

/// The words of the text where a thread may go from a segment, as far as the
/// text says, and where it will come back to from calls.
std::vector<uint32_t> successorsOf(const CodeSubject &Subject,
                                   const Segment &Steps);

} // namespace tp

#endif // TP_SIMULATOR_JIT_SEGMENT_H
