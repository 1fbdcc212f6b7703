//===- RunConsole.cpp - What the user sees during a run -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/RunConsole.h"

#include "llvm/Support/raw_ostream.h"

#include <algorithm>
#include <utility>

using namespace llvm;

namespace tp {

RunConsole::RunConsole(const Options &Request, const RunSetup &Loaded)
    : Request(Request), Loaded(Loaded), Line(!Request.Quiet) {}

void RunConsole::write(int Fd, std::string_view Bytes) {
  Line.clear();
  raw_fd_ostream &OS = Fd == 2 ? errs() : outs();
  OS << Bytes;
  if (OS.is_displayed())
    OS.flush();
  if (Request.CheckpointOutput.empty())
    return;
  if (Written.empty() || Written.back().Fd != Fd)
    Written.push_back({Fd, {}});
  Written.back().Bytes += Bytes;
}

void RunConsole::serialize(Archive &A) {
  A(Written);
  if (!A.isRestoring())
    return;
  std::vector<Piece> Restored = std::exchange(Written, {});
  for (const Piece &Old : Restored)
    write(Old.Fd, Old.Bytes);
}

std::optional<double> RunConsole::shareDone(const Progress &Now) const {
  std::optional<double> Share;
  if (Loaded.Source) {
    double Pixels = double(Loaded.Block.Width) * Loaded.Block.Height;
    Share = readPixelsTaken(Loaded.Block, Loaded.ThreadCount, Loaded.Launch) /
            Pixels;
  }
  if (Request.MaxCycles)
    Share = std::max(Share.value_or(0), Now.Cycles / double(Request.MaxCycles));
  return Share;
}

void RunConsole::report(const Progress &Now) {
  Line.update(Now, shareDone(Now));
  outs().flush();
}

void RunConsole::resumeAt(const Progress &Now) {
  Line.start(Now, shareDone(Now));
}

double RunConsole::finish() {
  Line.clear();
  return Line.seconds();
}

} // namespace tp
