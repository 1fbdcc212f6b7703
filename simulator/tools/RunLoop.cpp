//===- RunLoop.cpp - Runs the machine to its end --------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/RunLoop.h"

#include "llvm/ADT/STLExtras.h"

#include <algorithm>

using namespace llvm;

namespace tp {

/// The first pause that a task wants; 0 if none wants one.
static uint64_t firstPause(ArrayRef<RunTask *> Tasks) {
  uint64_t First = 0;
  for (const RunTask *Task : Tasks)
    if (uint64_t Next = Task->nextPause())
      First = First == 0 ? Next : std::min(First, Next);
  return First;
}

static llvm::Error pauseAll(ArrayRef<RunTask *> Tasks, Engine &Machine,
                            RunResult::EndKind Now) {
  for (RunTask *Task : Tasks)
    if (llvm::Error E = Task->pause(Machine, Now))
      return E;
  return llvm::Error::success();
}

Expected<RunResult> runToEnd(Engine &Machine, RunLimits Limits,
                             ArrayRef<RunTask *> Tasks) {
  for (const RunTask *Task : Tasks)
    append_range(Limits.PauseMarkers, Task->markers());
  RunResult Result{RunResult::Paused, 0, std::nullopt};
  while (true) {
    if (llvm::Error E = pauseAll(Tasks, Machine, Result.End))
      return E;
    if (Result.End != RunResult::Paused)
      return Result;
    Limits.PauseCycle = firstPause(Tasks);
    Result = Machine.run(Limits);
  }
}

} // namespace tp
