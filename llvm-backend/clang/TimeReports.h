//===- TimeReports.h - Where the compiler spends its time -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_TIMEREPORTS_H
#define TP_LLVM_BACKEND_CLANG_TIMEREPORTS_H

#include "llvm/ADT/StringRef.h"

#include <string>

namespace tp {

/// -ftime-trace: records what this process does while the object lives, then
/// writes it to a file. Does nothing without a file.
class TimeTrace {
public:
  struct Settings {
    std::string Path;
    /// The shortest span in microseconds that is recorded.
    unsigned Granularity = 500;
    bool IsVerbose = false;
  };

  explicit TimeTrace(Settings Chosen);
  TimeTrace(const TimeTrace &) = delete;
  TimeTrace &operator=(const TimeTrace &) = delete;
  ~TimeTrace();

private:
  Settings Chosen;
};

/// -ftime-report: prints the times of all passes since the last report.
void printTimeReport();

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_TIMEREPORTS_H
