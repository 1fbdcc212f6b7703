//===- TimeReports.cpp - Where the compiler spends its time ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/TimeReports.h"
#include "llvm/ADT/Statistic.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/TimeProfiler.h"
#include "llvm/Support/Timer.h"
#include "llvm/Support/WithColor.h"
#include "llvm/Support/raw_ostream.h"

using namespace llvm;

namespace tp {

TimeTrace::TimeTrace(Settings Wanted) : Chosen(std::move(Wanted)) {
  if (!Chosen.Path.empty())
    timeTraceProfilerInitialize(Chosen.Granularity, "tpcc", Chosen.IsVerbose);
}

TimeTrace::~TimeTrace() {
  if (Chosen.Path.empty())
    return;
  std::error_code Failure;
  raw_fd_ostream File(Chosen.Path, Failure, sys::fs::OF_TextWithCRLF);
  if (Failure)
    WithColor::warning(errs(), "tpcc")
        << "cannot write the time trace '" << Chosen.Path
        << "': " << Failure.message() << '\n';
  else
    timeTraceProfilerWrite(File);
  timeTraceProfilerCleanup();
}

void printTimeReport() {
  std::unique_ptr<raw_ostream> Output = CreateInfoOutputFile();
  TimerGroup::printAll(*Output);
  TimerGroup::clearAll();
}

} // namespace tp
