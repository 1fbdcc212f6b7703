//===- IntervalWriter.h - A series of intervals as a file -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_STATS_INTERVALWRITER_H
#define TP_SIMULATOR_STATS_INTERVALWRITER_H

#include "simulator/stats/IntervalFigures.h"

#include "llvm/ADT/ArrayRef.h"
#include "llvm/Support/raw_ostream.h"

#include <memory>

namespace tp {

/// Writes the figures of consecutive intervals, each as soon as it is known.
class IntervalWriter {
public:
  virtual ~IntervalWriter() = default;

  /// The interval from cycle \p Begin on that ends in front of \p End.
  virtual void write(uint64_t Begin, uint64_t End,
                     llvm::ArrayRef<IntervalFigure> Figures) = 0;
  /// Ends the file. The destructor does it if nobody has: a run that fails
  /// leaves the intervals up to there.
  virtual void finish() {}
};

/// A table with a line of names and a line for each interval.
std::unique_ptr<IntervalWriter> makeCsvWriter(llvm::raw_ostream &OS);

/// Counter tracks in the format of Chrome's trace viewer, which Perfetto reads,
/// over the time at the clock of \p Chip.
std::unique_ptr<IntervalWriter> makeTraceWriter(const ChipConfig &Chip,
                                                llvm::raw_ostream &OS);

} // namespace tp

#endif // TP_SIMULATOR_STATS_INTERVALWRITER_H
