//===- SegmentCode.h - A segment as an LLVM function ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_JIT_SEGMENTCODE_H
#define TP_SIMULATOR_JIT_SEGMENTCODE_H

#include "simulator/jit/Segment.h"

#include "llvm/IR/Module.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tp {

/// A wait for a result that the segment's own instructions make: its length is
/// known when the code is made.
struct KnownWait {
  uint32_t Cycles = 0;
  Opcode Producer = Opcode(0);
};

/// A place where a segment is left. The code counts how often.
struct SegmentExit {
  /// Steps that have been executed, and steps whose known wait is over.
  uint32_t Executed = 0;
  uint32_t Waited = 0;
};

/// What the counts of a segment's code mean.
struct SegmentCounts {
  Segment Steps;
  /// Of each step.
  std::vector<KnownWait> Waits;
  /// In the order of their counts.
  std::vector<SegmentExit> Exits;
};

/// Adds a handler named \p Name to a module that has the cycle engine's step
/// functions. It executes \p Steps for a thread that stands at their first,
/// until the thread leaves them, the window ends, or there is something to do
/// that only the interpreter can. Its counts begin at number \p FirstCount of
/// TmRunnerState::CodeCounts.
SegmentCounts addSegment(llvm::Module &M, const std::string &Name,
                         const CodeSubject &Subject, const Segment &Steps,
                         size_t FirstCount);

/// Replaces what the handler loads of the chip's context and never changes by
/// its values.
void foldConstants(llvm::Function &Handler, const CodeSubject &Subject);

} // namespace tp

#endif // TP_SIMULATOR_JIT_SEGMENTCODE_H
