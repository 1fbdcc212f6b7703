//===- ProgressLine.h - How far a run is, on a terminal ---------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_TOOLS_PROGRESSLINE_H
#define TP_SIMULATOR_TOOLS_PROGRESSLINE_H

#include "simulator/core/Engine.h"

#include <chrono>
#include <optional>
#include <string>

namespace tp {

/// How far a run is, or was at its start: the share of the work that is done is
/// from 0 to 1, or nothing if the amount of work is unknown.
struct ProgressPoint {
  Progress Counts;
  std::optional<double> Share;
};

/// The text of the progress line: speed, share of the work that is done, time
/// left. The run is \p Seconds away from its start.
std::string progressText(const ProgressPoint &Start, const ProgressPoint &Now,
                         double Seconds);

/// One line on the terminal that standard error is, rewritten in place. Does
/// nothing if standard error is not a terminal or if it is disabled.
class ProgressLine {
public:
  explicit ProgressLine(bool Enabled);
  ~ProgressLine() { clear(); }

  /// What was done before this run.
  void start(const Progress &Now, std::optional<double> Share) {
    First = {Now, Share};
  }
  void update(const Progress &Now, std::optional<double> Share);
  /// Takes the line away, so that other text can be written.
  void clear();
  /// Seconds since the construction.
  double seconds() const;

private:
  bool Enabled;
  bool Visible = false;
  ProgressPoint First;
  std::chrono::steady_clock::time_point Start;
};

} // namespace tp

#endif // TP_SIMULATOR_TOOLS_PROGRESSLINE_H
