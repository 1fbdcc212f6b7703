//===- CompareRuns.cpp - tpsim --compare ----------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/CompareRuns.h"

#include "simulator/compare/Comparison.h"
#include "simulator/tools/OutputFile.h"

using namespace llvm;

namespace tp {

llvm::Error compareRuns(const ComparisonRequest &Request) {
  Expected<ComparedRun> Before = loadComparedRun(Request.Before);
  if (!Before)
    return Before.takeError();
  Expected<ComparedRun> After = loadComparedRun(Request.After);
  if (!After)
    return After.takeError();
  Expected<Comparison> Runs = compare(*Before, *After);
  if (!Runs)
    return Runs.takeError();
  if (Request.Output != "-")
    writeTable(*Runs, Request.Rows, outs());
  llvm::Error Failure = Request.Output.empty()
                            ? llvm::Error::success()
                            : writeTo(Request.Output, [&](raw_ostream &OS) {
                                writeJson(*Runs, OS);
                              });
  return joinErrors(std::move(Failure), flushOutput());
}

} // namespace tp
