//===- RunLoop.h - Runs the machine to its end ------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_TOOLS_RUNLOOP_H
#define TP_SIMULATOR_TOOLS_RUNLOOP_H

#include "simulator/core/Engine.h"

#include "llvm/ADT/ArrayRef.h"
#include "llvm/Support/Error.h"

#include <cstdint>
#include <vector>

namespace tp {

/// Something to be done in pauses of a run. It changes nothing in the run.
class RunTask {
public:
  virtual ~RunTask() = default;

  /// The cycle at whose window's beginning the run shall pause next; 0: none.
  virtual uint64_t nextPause() const { return 0; }
  /// The run shall pause at the end of a window in which a thread passed one of
  /// these profile markers.
  virtual std::vector<uint32_t> markers() const { return {}; }
  /// The run stands between two windows: in each pause, also in those of other
  /// tasks, and when it has ended, however that was.
  /// \p Now is Paused or how it has ended. Also once before the first cycle of
  /// a run, which may be a restored one.
  virtual llvm::Error pause(Engine &Machine, RunResult::EndKind Now) = 0;
  /// What a checkpoint must hold of it.
  virtual void serialize(Archive &) {}
};

/// Runs \p Machine within \p Limits, which say nothing of pauses, and does the
/// \p Tasks in this order. An error is a task's.
llvm::Expected<RunResult> runToEnd(Engine &Machine, RunLimits Limits,
                                   llvm::ArrayRef<RunTask *> Tasks);

} // namespace tp

#endif // TP_SIMULATOR_TOOLS_RUNLOOP_H
