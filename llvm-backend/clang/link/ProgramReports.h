//===- ProgramReports.h - What the link writes besides a program -*- C++ -*-==//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_LINK_PROGRAMREPORTS_H
#define TP_LLVM_BACKEND_CLANG_LINK_PROGRAMREPORTS_H

#include <string>

namespace tp {

/// The passes whose remarks the link prints, as regular expressions: those of
/// -Rpass=, -Rpass-missed= and -Rpass-analysis=. An empty one is off.
struct RemarkPatterns {
  std::string Passed;
  std::string Missed;
  std::string Analysis;
};

/// What the compilation of the whole program writes besides the program. An
/// empty path is off.
struct ProgramReports {
  RemarkPatterns Remarks;
  /// -fsave-optimization-record.
  std::string RecordPath;
  std::string RecordFormat = "yaml";
  /// A regular expression; all passes if empty.
  std::string RecordPasses;
  /// -fstack-usage.
  std::string StackUsagePath;
  /// -save-temps: what the optimized program's bitcode, assembly and object
  /// are called, up to their suffixes.
  std::string TemporariesPath;
};

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_LINK_PROGRAMREPORTS_H
