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

/// The text of the progress line: speed, share of the work that is done, time
/// left. \p Share is from 0 to 1, or nothing if the amount of work is unknown.
std::string progressText(const Progress &Now, double Seconds,
                         std::optional<double> Share);

/// One line on the terminal that standard error is, rewritten in place. Does
/// nothing if standard error is not a terminal or if it is disabled.
class ProgressLine {
public:
  explicit ProgressLine(bool Enabled);
  ~ProgressLine() { clear(); }

  void update(const Progress &Now, std::optional<double> Share);
  /// Takes the line away, so that other text can be written.
  void clear();
  /// Seconds since the construction.
  double seconds() const;

private:
  bool Enabled;
  bool Visible = false;
  std::chrono::steady_clock::time_point Start;
};

} // namespace tp

#endif // TP_SIMULATOR_TOOLS_PROGRESSLINE_H
