//===- ComparisonJson.cpp - What changed between two runs, for programs ---===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/compare/Comparison.h"

#include "llvm/Support/JSON.h"

using namespace llvm;

namespace tp {

/// Raised when a name changes its meaning or goes away.
static constexpr int ComparisonFormatVersion = 1;

namespace {

class ComparisonWriter {
public:
  ComparisonWriter(const Comparison &Runs, raw_ostream &OS)
      : Runs(Runs), Json(OS, 2) {}

  void write() {
    Json.object([&] {
      Json.attribute("format_version", ComparisonFormatVersion);
      Json.attribute("mode", Runs.Before.HasCycles ? "cycle" : "functional");
      writeRun("before", Runs.Before);
      writeRun("after", Runs.After);
      writeCounts("counts", Runs.Counts);
      writePlaces("functions", Runs.Functions);
      writePlaces("lines", Runs.Lines);
      Json.attributeObject("instructions_by_opcode", [&] {
        for (const ComparedOpcode &Opcode : Runs.Opcodes)
          writeChange(Opcode.Name, Opcode.Before, Opcode.After);
      });
    });
  }

private:
  const Comparison &Runs;
  json::OStream Json;

  void writeRun(const char *Name, const ComparedRun &Run) {
    Json.attributeObject(Name, [&] {
      Json.attribute("path", Run.Path);
      Json.attribute("outcome", Run.Outcome);
      Json.attribute("chip", Run.Chip);
      Json.attribute("tm_count", Run.TmCount);
      Json.attribute("tps_per_tm", Run.TpsPerTm);
      if (Run.HasCycles)
        Json.attribute("cycles", Run.Cycles);
      Json.attributeObject("figures", [&] {
        for (const Figure &F : Run.Figures)
          Json.attribute(F.Name, F.Value);
      });
    });
  }

  void writeChange(StringRef Name, int64_t Before, int64_t After) {
    Json.attributeObject(Name, [&] {
      Json.attribute("before", Before);
      Json.attribute("after", After);
      Json.attribute("change", After - Before);
    });
  }

  /// What changed as a whole and by use, without uses that neither run has.
  void writeCounts(StringRef Name, const ComparedCounts &Counts) {
    writeChange(Name, sumOf(Counts.Before), sumOf(Counts.After));
    Json.attributeObject((Name + "_by_reason").str(), [&] {
      for (unsigned Use = 0; Use != NumCycleUses; ++Use)
        if (Counts.Before[Use] || Counts.After[Use])
          writeChange(cycleUseName(Use), Counts.Before[Use], Counts.After[Use]);
    });
  }

  void writePlaces(StringRef Name, ArrayRef<ComparedPlace> Places) {
    if (!Runs.HasPlaces)
      return;
    Json.attributeArray(Name, [&] {
      for (const ComparedPlace &Place : Places)
        Json.object([&] {
          Json.attribute("function", Place.Name.Function);
          Json.attribute("file", Place.Name.File);
          if (Place.Name.Line != 0)
            Json.attribute("line", Place.Name.Line);
          writeCounts("counts", Place.Counts);
        });
    });
  }
};

} // namespace

void writeJson(const Comparison &Runs, raw_ostream &OS) {
  ComparisonWriter(Runs, OS).write();
  OS << '\n';
}

} // namespace tp
