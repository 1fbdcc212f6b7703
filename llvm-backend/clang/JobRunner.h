//===- JobRunner.h - Runs the jobs of one compilation -----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_JOBRUNNER_H
#define TP_LLVM_BACKEND_CLANG_JOBRUNNER_H

#include "llvm-backend/clang/JobPlan.h"
#include "llvm-backend/clang/LinkJob.h"
#include "llvm/ADT/StringSet.h"

namespace tp {

/// Runs the jobs of one compilation one after the other in this process.
class JobRunner {
public:
  enum class Outcome { Succeeded, Failed, Crashed };

  /// The exit status of a job that LLVM has ended with a message.
  static constexpr int FatalErrorStatus = 1;

  JobRunner(clang::driver::Compilation &Jobs, const JobPlan &Plan,
            const std::string &ToolPath, const Sysroot &Folders,
            const WarningOptions &Warnings)
      : Jobs(Jobs), Plan(Plan), ToolPath(ToolPath),
        Link(Jobs, Plan, Folders, Warnings) {}

  /// Runs them all up to a crash; those that need the output of a failed one
  /// are left out. After a crash this object must not be destroyed: what it
  /// holds may be in any state.
  Outcome runAll(bool Verbose);

  /// The exit status that tells of the crash.
  int crashStatus() const { return CrashStatus; }

private:
  using Command = clang::driver::Command;

  bool dependsOnFailure(const Command &Job) const;
  bool compile(const Command &Job);
  bool run(const Command &Job);
  Outcome runSafely(const Command &Job);

  clang::driver::Compilation &Jobs;
  const JobPlan &Plan;
  const std::string &ToolPath;
  LinkJob Link;
  llvm::StringSet<> MissingOutputs;
  int CrashStatus = 0;
};

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_JOBRUNNER_H
