//===- IntervalCsv.cpp - A series of intervals as a table -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/stats/IntervalWriter.h"

#include "llvm/Support/Format.h"

using namespace llvm;

namespace tp {
namespace {

class CsvWriter final : public IntervalWriter {
public:
  explicit CsvWriter(raw_ostream &OS) : OS(OS) {}

  void write(uint64_t Begin, uint64_t End,
             ArrayRef<IntervalFigure> Figures) override {
    if (!HasHead) {
      OS << "begin_cycle,end_cycle";
      for (const IntervalFigure &Figure : Figures)
        OS << ',' << Figure.Column;
      OS << '\n';
      HasHead = true;
    }
    OS << Begin << ',' << End;
    for (const IntervalFigure &Figure : Figures) {
      OS << ',';
      if (Figure.IsCount)
        OS << int64_t(Figure.Value);
      else
        OS << format("%.6g", Figure.Value);
    }
    OS << '\n';
  }

private:
  raw_ostream &OS;
  bool HasHead = false;
};

} // namespace

std::unique_ptr<IntervalWriter> makeCsvWriter(raw_ostream &OS) {
  return std::make_unique<CsvWriter>(OS);
}

} // namespace tp
