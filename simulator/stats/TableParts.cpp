//===- TableParts.cpp - The chip's parts and levels, for people -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/chip/ChipArea.h"
#include "simulator/stats/ChipEnergy.h"
#include "simulator/stats/MemorySummary.h"
#include "simulator/stats/Ratio.h"
#include "simulator/stats/TableBlocks.h"
#include "simulator/stats/TableText.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"

#include <algorithm>

using namespace llvm;

namespace tp {
namespace {

/// What there is to say of a part besides its cost.
struct PartUse {
  std::string Operations;
  std::string Used;
  std::string Details;
};

class PartsWriter {
public:
  PartsWriter(const RunSummary &Run, raw_ostream &OS)
      : Run(Run), Chip(Run.Chip), OS(OS) {
    if (Run.Stats.Memory)
      Memory = summarizeMemory(Chip, Run.Stats.Cycles, *Run.Stats.Memory);
  }

  void write() {
    OS << "part            per TM        operations      used"
       << (Chip.Technology ? "      mm2         W    (*: assumed)" : "")
       << '\n';
    for (const AreaPart &Part : chipArea(Chip))
      row(Part.Name, perTm(Part.Count), useOf(Part.Name),
          cost(Part.TotalMm2, Part.Source) + power(Part.Name));
    if (Memory.Dram)
      row("dram", "", use(*Memory.Dram), formatv("{0,10}", "") + power("dram"));
    if (Chip.Technology)
      row("total", "", {},
          cost(totalAreaMm2(Chip), {}) +
              cost(averagePowerW(Chip, Run.Stats), {}));
  }

private:
  const RunSummary &Run;
  const ChipConfig &Chip;
  raw_ostream &OS;
  MemorySummary Memory;

  void row(StringRef Name, StringRef PerTm, const PartUse &Use,
           const Twine &Costs) {
    std::string Line =
        formatv("{0,-14}{1,8}{2,18}{3,10}{4}  {5}", Name, PerTm, Use.Operations,
                Use.Used, Chip.Technology ? Costs.str() : "", Use.Details);
    OS << StringRef(Line).rtrim() << '\n';
  }

  static std::string cost(double Value, const FigureSource &Source) {
    return formatv("{0,9}{1}", formatv("{0:F2}", Value).str(),
                   Source.IsAssumption ? '*' : ' ');
  }

  std::string power(StringRef Name) const {
    for (const EnergyPart &Part : chipEnergy(Chip, Run.Stats))
      if (Name == Part.Name)
        return cost(ratio(Part.Joules, Run.seconds()), Part.Source);
    return "";
  }

  std::string perTm(uint64_t Count) const {
    if (Count < Chip.TmCount)
      return formatv("1/{0}", Chip.TmsPerL2);
    return std::to_string(Count / Chip.TmCount);
  }

  PartUse useOf(StringRef Name) const {
    for (unsigned I = 0; I != NumUnits; ++I)
      if (Name == StringRef(unitName(Unit(I))))
        return {grouped(Run.operations(Unit(I))),
                percent(Run.utilisation(Unit(I))), ""};
    if (Name == "icache")
      return {grouped(Run.Stats.instructions()),
              percent(Run.icacheUtilisation()), ""};
    if (Name == "l1" && Memory.L1)
      return use(*Memory.L1);
    if (Name == "l2" && Memory.L2)
      return use(*Memory.L2);
    if (Name == "crossbar" && Memory.Crossbar)
      return use(*Memory.Crossbar);
    return {};
  }

  static PartUse use(const CacheSummary &Cache) {
    const CacheStatistics &Counts = Cache.Counts;
    return {
        grouped(Counts.Loads + Counts.Stores + Counts.Atomics + Counts.Fetches),
        percent(Cache.BankUtilisation),
        formatv("hits {0}, merged {1}", percent(Cache.HitRate),
                percent(Cache.MergedRate))};
  }

  static PartUse use(const CrossbarSummary &Crossbar) {
    return {grouped(Crossbar.Counts.Requests),
            percent(std::max(Crossbar.Requests.ShareOfPeak,
                             Crossbar.Answers.ShareOfPeak)),
            formatv("{0:F1} GB/s, back {1:F1}", Crossbar.Requests.GBPerSecond,
                    Crossbar.Answers.GBPerSecond)};
  }

  static PartUse use(const DramSummary &Dram) {
    return {grouped(Dram.Counts.Reads + Dram.Counts.Writes),
            percent(Dram.Data.ShareOfPeak),
            formatv("{0:F1} GB/s, row hits {1}", Dram.Data.GBPerSecond,
                    percent(Dram.RowHitRate))};
  }
};

} // namespace

void writeParts(const RunSummary &Run, raw_ostream &OS) {
  PartsWriter(Run, OS).write();
}

} // namespace tp
