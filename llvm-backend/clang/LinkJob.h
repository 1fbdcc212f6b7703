//===- LinkJob.h - The driver's last job ------------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_LINKJOB_H
#define TP_LLVM_BACKEND_CLANG_LINKJOB_H

#include "llvm-backend/clang/JobPlan.h"
#include "llvm-backend/clang/Sysroot.h"
#include "llvm-backend/clang/link/ProgramLinker.h"
#include "llvm-backend/clang/warnings/WarningOptions.h"
#include "clang/Driver/Compilation.h"
#include "llvm/ADT/StringMap.h"
#include "llvm/IR/LLVMContext.h"

namespace tp {

/// Links what the jobs of a compilation have made. Clang's driver plans the job
/// for a linker program; here it runs in this process.
class LinkJob {
public:
  LinkJob(const clang::driver::Compilation &Jobs, const JobPlan &Plan,
          const Sysroot &Folders, const WarningOptions &Warnings)
      : Jobs(Jobs), Plan(Plan), Folders(Folders), Warnings(Warnings) {}

  /// Where units that are to be linked have to be compiled.
  llvm::LLVMContext &context() { return Context; }

  /// Hands over the unit that the job with the output \p File has compiled.
  void addUnit(llvm::StringRef File, std::unique_ptr<llvm::Module> Unit) {
    Units[File] = std::move(Unit);
  }

  /// \returns false after an error, which has been reported.
  bool run(const clang::driver::Command &Job);

  /// Gives \p Job, which clang's driver planned for a foreign linker, the
  /// arguments with which tpcc does what run() does, for -### and -v.
  static void describe(const clang::driver::Compilation &Jobs,
                       const JobPlan &Plan, const std::string &ToolPath,
                       llvm::ArrayRef<const char *> WarningWords,
                       clang::driver::Command &Job);

private:
  const clang::driver::Compilation &Jobs;
  const JobPlan &Plan;
  const Sysroot &Folders;
  const WarningOptions &Warnings;
  llvm::LLVMContext Context;
  llvm::StringMap<std::unique_ptr<llvm::Module>> Units;
};

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_LINKJOB_H
