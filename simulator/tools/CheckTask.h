//===- CheckTask.h - The checkers of a run ----------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_TOOLS_CHECKTASK_H
#define TP_SIMULATOR_TOOLS_CHECKTASK_H

#include "simulator/functional/FunctionalMachine.h"
#include "simulator/tools/RunSetup.h"

#include <memory>

namespace tp {

/// Runs a program under the checkers that the user asked for. Reports go to
/// standard error as they come.
class CheckTask {
public:
  /// Has \p Machine make the checks. The arguments must outlive the task, and
  /// the task the machine's runs.
  static llvm::Expected<std::unique_ptr<CheckTask>>
  start(const Options &Request, const ChipConfig &Chip, RunSetup &Loaded,
        FunctionalMachine &Machine);
  ~CheckTask();

  /// The run has ended: the last checks, the line about all of them, and the
  /// JSON.
  llvm::Error finish(const RunResult &Result);
  /// Whether there was a fault that the user wants to see.
  bool hasFaults() const;

private:
  struct Implementation;

  CheckTask();

  std::unique_ptr<Implementation> Checks;
};

} // namespace tp

#endif // TP_SIMULATOR_TOOLS_CHECKTASK_H
