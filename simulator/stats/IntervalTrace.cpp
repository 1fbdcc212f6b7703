//===- IntervalTrace.cpp - A series of intervals as a trace ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/stats/IntervalWriter.h"

#include "llvm/ADT/StringRef.h"
#include "llvm/Support/JSON.h"

using namespace llvm;

namespace tp {
namespace {

/// The events are counters ("ph": "C"): a track has the values of "args" from
/// the time "ts", in microseconds, up to its next event.
class TraceWriter final : public IntervalWriter {
public:
  TraceWriter(const ChipConfig &Chip, raw_ostream &OS)
      : CyclesPerMicrosecond(Chip.ClockGHz * 1e3), OS(OS), Json(OS) {
    Json.objectBegin();
    Json.attribute("displayTimeUnit", "ns");
    Json.attributeBegin("traceEvents");
    Json.arrayBegin();
    Json.object([&] {
      Json.attribute("name", "process_name");
      Json.attribute("ph", "M");
      Json.attribute("pid", 0);
      Json.attributeObject("args", [&] { Json.attribute("name", Chip.Name); });
    });
  }

  ~TraceWriter() override { finish(); }

  void write(uint64_t Begin, uint64_t End,
             ArrayRef<IntervalFigure> Figures) override {
    writeEvents(Begin, Figures);
    Last.assign(Figures.begin(), Figures.end());
    LastEnd = End;
  }

  /// Takes all curves to 0, so that the last interval has an end.
  void finish() override {
    if (IsFinished)
      return;
    IsFinished = true;
    for (IntervalFigure &Figure : Last)
      Figure.Value = 0;
    writeEvents(LastEnd, Last);
    Json.arrayEnd();
    Json.attributeEnd();
    Json.objectEnd();
    OS << '\n';
  }

private:
  const double CyclesPerMicrosecond;
  raw_ostream &OS;
  json::OStream Json;
  std::vector<IntervalFigure> Last;
  uint64_t LastEnd = 0;
  bool IsFinished = false;

  /// Figures of one track follow each other.
  void writeEvents(uint64_t Cycle, ArrayRef<IntervalFigure> Figures) {
    while (!Figures.empty()) {
      StringRef Track = Figures.front().Track;
      ArrayRef<IntervalFigure> Curves = Figures.take_while(
          [&](const IntervalFigure &Figure) { return Figure.Track == Track; });
      if (!Track.empty())
        writeEvent(Cycle, Track, Curves);
      Figures = Figures.drop_front(Curves.size());
    }
  }

  void writeEvent(uint64_t Cycle, StringRef Track,
                  ArrayRef<IntervalFigure> Curves) {
    Json.object([&] {
      Json.attribute("name", Track);
      Json.attribute("ph", "C");
      Json.attribute("pid", 0);
      Json.attribute("ts", double(Cycle) / CyclesPerMicrosecond);
      Json.attributeObject("args", [&] {
        for (const IntervalFigure &Curve : Curves)
          Json.attribute(Curve.Curve, Curve.Value * Curve.Scale);
      });
    });
  }
};

} // namespace

std::unique_ptr<IntervalWriter> makeTraceWriter(const ChipConfig &Chip,
                                                raw_ostream &OS) {
  return std::make_unique<TraceWriter>(Chip, OS);
}

} // namespace tp
