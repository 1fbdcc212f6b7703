//===- RunConsole.h - What the user sees during a run -----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_TOOLS_RUNCONSOLE_H
#define TP_SIMULATOR_TOOLS_RUNCONSOLE_H

#include "simulator/tools/ProgressLine.h"
#include "simulator/tools/RunSetup.h"

#include <string>
#include <vector>

namespace tp {

/// The program's output and the progress line of a run.
class RunConsole {
public:
  /// \p Request and \p Loaded must outlive it.
  RunConsole(const Options &Request, const RunSetup &Loaded);

  /// Passes the program's output on, so that nothing else is on standard
  /// output.
  void write(int Fd, std::string_view Bytes);
  /// The output so far, if it is to be saved in checkpoints; restored, it is
  /// written again.
  void serialize(Archive &A);
  /// Shows how far the run is.
  void report(const Progress &Now);
  /// The run goes on from \p Now, so that speed and time left count from here.
  void resumeAt(const Progress &Now);

  /// Ends the progress line and gives the seconds since the construction.
  double finish();

private:
  /// The part of the work that is done, 0 to 1; nothing if nobody knows.
  std::optional<double> shareDone(const Progress &Now) const;

  const Options &Request;
  const RunSetup &Loaded;
  ProgressLine Line;
  /// What was written to each file descriptor, in order.
  struct Piece {
    int32_t Fd = 1;
    std::string Bytes;

    void serialize(Archive &A) {
      A(Fd);
      A(Bytes);
    }
  };
  std::vector<Piece> Written;
};

} // namespace tp

#endif // TP_SIMULATOR_TOOLS_RUNCONSOLE_H
