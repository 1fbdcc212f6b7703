//===- JobPlan.h - What the jobs of a compilation make ----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_JOBPLAN_H
#define TP_LLVM_BACKEND_CLANG_JOBPLAN_H

#include "clang/Driver/Compilation.h"
#include "clang/Driver/Job.h"
#include "llvm/ADT/SmallPtrSet.h"
#include "llvm/ADT/StringMap.h"

namespace tp {

/// Which of the jobs that clang's driver has planned make units of the program
/// that is optimized as a whole. Clang plans to compile them to assembly, with
/// -save-temps in jobs of their own; they end with bitcode instead.
class JobPlan {
public:
  JobPlan(const clang::driver::Compilation &Jobs, bool IsWholeProgram);

  /// Whether \p Job makes a unit of the program.
  bool isUnit(const clang::driver::Command &Job) const {
    return Units.contains(&Job);
  }
  /// Whether \p Job is not needed.
  bool isDropped(const clang::driver::Command &Job) const {
    return Dropped.contains(&Job);
  }
  /// The file that takes the place of \p File, an input of the link.
  llvm::StringRef linkInput(llvm::StringRef File) const {
    auto Known = Replacements.find(File);
    return Known == Replacements.end() ? File : llvm::StringRef(Known->second);
  }

private:
  using Command = clang::driver::Command;

  void addUnit(const clang::driver::Action &Assembly,
               const clang::driver::JobList &Jobs);

  llvm::SmallPtrSet<const Command *, 8> Units;
  llvm::SmallPtrSet<const Command *, 8> Dropped;
  llvm::StringMap<std::string> Replacements;
};

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_JOBPLAN_H
