//===- IntervalFigures.h - What is told of an interval ----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_STATS_INTERVALFIGURES_H
#define TP_SIMULATOR_STATS_INTERVALFIGURES_H

#include "simulator/chip/ChipConfig.h"
#include "simulator/stats/Statistics.h"

#include <string>
#include <vector>

namespace tp {

/// A figure of an interval, as a column of a table and as a curve of a track of
/// a trace.
struct IntervalFigure {
  std::string Column;
  double Value = 0;
  /// A whole number.
  bool IsCount = false;
  /// Empty: not in the trace.
  std::string Track = {};
  std::string Curve = {};
  /// The curve shows Value times this.
  double Scale = 1;
};

/// The figures of an interval with the counts \p Counts, the same for every
/// interval of a chip and in the same order.
std::vector<IntervalFigure> intervalFigures(const ChipConfig &Chip,
                                            const Statistics &Counts);

} // namespace tp

#endif // TP_SIMULATOR_STATS_INTERVALFIGURES_H
