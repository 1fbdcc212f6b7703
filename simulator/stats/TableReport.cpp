//===- TableReport.cpp - A run's statistics for people --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/stats/TableReport.h"

#include "kernels/profile/RayProfileText.h"
#include "kernels/profile/RayProfiler.h"

#include "simulator/chip/ChipArea.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/Format.h"
#include "llvm/Support/FormatVariadic.h"

using namespace llvm;

namespace tp {

/// 1234567 as `1,234,567`.
static std::string grouped(uint64_t Value) {
  return formatv("{0:N}", Value).str();
}

/// 0.1234 as `12.3 %`. Something that is not nothing never shows as `0.0 %`.
static std::string percent(double Share) {
  if (Share > 0 && Share < 0.0005)
    return "<0.1 %";
  return formatv("{0:F1} %", Share * 100).str();
}

/// A count by opcode and its share of all thread-cycles, largest first.
static std::string biggest(const std::vector<OpcodeCount> &Counts,
                           double Whole) {
  constexpr size_t Shown = 4;
  std::string Line;
  for (size_t I = 0; I != std::min(Counts.size(), Shown); ++I)
    Line += formatv("{0}{1} {2}", I ? ", " : "", mnemonic(Counts[I].Op),
                    percent(Counts[I].Count / Whole));
  return Line;
}

/// The counts of the opcodes for which \p Keep holds.
template <typename Predicate>
static std::vector<OpcodeCount> only(std::vector<OpcodeCount> Counts,
                                     Predicate Keep) {
  erase_if(Counts, [&](const OpcodeCount &C) { return !Keep(C.Op); });
  return Counts;
}

/// True for the opcodes whose results Loss::Memory waits for.
static bool isMemory(Opcode Op) { return unitOf(Op) == Unit::MEMORY; }

static void writeHead(const RunSummary &Run, raw_ostream &OS) {
  const ChipConfig &Chip = Run.Chip;
  OS << formatv("{0}: {1} TMs x {2} TPs at {3} GHz, {4:F1} mm2\n", Chip.Name,
                Chip.TmCount, Chip.TpsPerTm, format("%g", Chip.ClockGHz),
                totalAreaMm2(Chip));
  OS << formatv("run ended: {0}, status {1}\n\n", Run.Outcome, Run.ExitStatus);
  OS << formatv("{0,-16}{1,18}   {2:F3} ms at the chip's clock\n", "cycles",
                grouped(Run.Stats.Cycles), Run.seconds() * 1e3);
  OS << formatv("{0,-16}{1,18}   {2:F2} per cycle and TM\n", "instructions",
                grouped(Run.Stats.instructions()),
                Run.instructionsPerCycleAndTm());
  if (std::optional<RayRates> Rates = rayRates(Run)) {
    OS << formatv("{0,-16}{1,18}   {2:F2} Mrays/s\n", "rays",
                  grouped(Rates->Rays), Rates->Chip / 1e6);
    const auto &Thread = Rates->PerThread;
    OS << format("  of a thread   %.3g to %.3g Mrays/s, mean %.3g, median "
                 "%.3g\n",
                 Thread.Minimum / 1e6, Thread.Maximum / 1e6, Thread.Mean / 1e6,
                 Thread.Median / 1e6);
  }
  OS << '\n';
}

static void writeLosses(const RunSummary &Run, raw_ostream &OS) {
  const Statistics &Stats = Run.Stats;
  double Whole = std::max<uint64_t>(Run.threadCycles(), 1);
  auto Row = [&](const char *Name, uint64_t Cycles, StringRef Details) {
    if (Cycles != 0)
      OS << formatv("{0,-16}{1,9}{2}{3}\n", Name, percent(Cycles / Whole),
                    Details.empty() ? "" : "   ", Details);
  };
  std::vector<OpcodeCount> Stalls = largestFirst(Stats.DataStall);
  OS << "thread-cycles       share   most by\n";
  Row("issued", Stats.instructions(),
      biggest(largestFirst(Stats.Executed), Whole));
  Row("data", Stats.lost(Loss::Data),
      biggest(only(Stalls, [](Opcode Op) { return !isMemory(Op); }), Whole));
  Row("memory", Stats.lost(Loss::Memory),
      biggest(only(Stalls, isMemory), Whole));
  Row("L1", Stats.lost(Loss::L1), "");
  Row("L2", Stats.lost(Loss::L2), "");
  Row("DRAM", Stats.lost(Loss::Dram), "");
  Row("store buffer", Stats.lost(Loss::StoreBuffer), "");
  Row("unit conflict", Stats.lost(Loss::UnitConflict),
      biggest(largestFirst(Stats.UnitConflict), Whole));
  Row("icache conflict", Stats.lost(Loss::IcacheConflict), "");
  Row("icache miss", Stats.lost(Loss::IcacheMiss), "");
  Row("branch", Stats.lost(Loss::Branch), "");
  Row("barrier", Stats.lost(Loss::Barrier), "");
  Row("sync", Stats.lost(Loss::Sync), "");
  Row("sleep", Stats.lost(Loss::Sleep), "");
  Row("finished", Stats.lost(Loss::Finished), "");
  OS << '\n';
}

static void writeParts(const RunSummary &Run, raw_ostream &OS) {
  const ChipConfig &Chip = Run.Chip;
  std::vector<AreaPart> Area = chipArea(Chip);
  auto Row = [&](StringRef Name, const Twine &PerTm, const Twine &Operations,
                 const Twine &Used, double Mm2) {
    OS << formatv("{0,-14}{1,8}{2,20}{3,10}{4,10:F2}\n", Name, PerTm.str(),
                  Operations.str(), Used.str(), Mm2);
  };
  OS << "part            per TM          operations      used       mm2\n";
  for (unsigned I = 0; I != NumUnits; ++I)
    Row(Area[I].Name, Twine(Chip.Units[I].Count),
        grouped(Run.operations(Unit(I))), percent(Run.utilisation(Unit(I))),
        Area[I].TotalMm2);
  for (size_t I = NumUnits; I != Area.size(); ++I) {
    bool IsIcache = Area[I].Name == "icache";
    Row(Area[I].Name, Twine(Area[I].Count / Chip.TmCount),
        IsIcache ? grouped(Run.Stats.instructions()) : "",
        IsIcache ? percent(Run.icacheUtilisation()) : "", Area[I].TotalMm2);
  }
  Row("total", "", "", "", totalAreaMm2(Chip));
}

void writeTable(const RunSummary &Run, const HostSpeed &Speed,
                raw_ostream &OS) {
  writeHead(Run, OS);
  if (std::optional<RayProfile> Sum = sumOf(Run.RayProfiles))
    OS << describe(*Sum) << '\n';
  writeLosses(Run, OS);
  writeParts(Run, OS);
  double Million = Run.Stats.instructions() / 1e6;
  OS << formatv("\nsimulated in {0:F2} s on {1} host thread{2}: {3:F1} million "
                "thread-instructions/s\n",
                Speed.Seconds, Speed.Threads, Speed.Threads == 1 ? "" : "s",
                Million / std::max(Speed.Seconds, 1e-9));
}

} // namespace tp
