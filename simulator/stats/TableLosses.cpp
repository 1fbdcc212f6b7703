//===- TableLosses.cpp - Where the thread-cycles went, for people ---------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/stats/TableBlocks.h"
#include "simulator/stats/TableText.h"

#include "llvm/ADT/STLExtras.h"

using namespace llvm;

namespace tp {

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

/// True for the opcodes whose results the memory losses wait for.
static bool isMemory(Opcode Op) { return unitOf(Op) == Unit::MEMORY; }

namespace {

/// A loss within a row of several.
struct NamedLoss {
  const char *Name;
  Loss Reason;
};

class LossWriter {
public:
  LossWriter(const RunSummary &Run, raw_ostream &OS)
      : Run(Run), Stats(Run.Stats),
        Whole(std::max<uint64_t>(Run.threadCycles(), 1)), OS(OS) {}

  void write() {
    std::vector<OpcodeCount> Stalls = largestFirst(Stats.DataStall);
    OS << "thread-cycles       share   most by\n";
    row("issued", Stats.instructions(),
        biggest(largestFirst(Stats.Executed), Whole));
    row("data", Stats.lost(Loss::Data),
        biggest(only(Stalls, [](Opcode Op) { return !isMemory(Op); }), Whole));
    if (Run.Chip.hasMemorySystem())
      rowOf("memory", {{"L1", Loss::L1},
                       {"L2", Loss::L2},
                       {"DRAM", Loss::Dram},
                       {"store buffer", Loss::StoreBuffer},
                       {Run.Chip.Dram ? "under way" : "memory", Loss::Memory}});
    else
      row("memory", Stats.lost(Loss::Memory),
          biggest(only(Stalls, isMemory), Whole));
    row("unit conflict", Stats.lost(Loss::UnitConflict),
        biggest(largestFirst(Stats.UnitConflict), Whole));
    rowOf("icache",
          {{"conflicts", Loss::IcacheConflict}, {"misses", Loss::IcacheMiss}});
    for (Loss Reason :
         {Loss::Branch, Loss::Barrier, Loss::Sync, Loss::Sleep, Loss::Finished})
      row(lossName(Reason), Stats.lost(Reason), "");
    OS << '\n';
  }

private:
  const RunSummary &Run;
  const Statistics &Stats;
  const double Whole;
  raw_ostream &OS;

  void row(const char *Name, int64_t Cycles, StringRef Details) {
    if (Cycles != 0)
      OS << formatv("{0,-16}{1,9}{2}{3}\n", Name, percent(Cycles / Whole),
                    Details.empty() ? "" : "   ", Details);
  }

  void rowOf(const char *Name, std::initializer_list<NamedLoss> Losses) {
    int64_t Sum = 0;
    std::string Parts;
    for (const NamedLoss &Part : Losses) {
      auto Cycles = int64_t(Stats.lost(Part.Reason));
      Sum += Cycles;
      if (Cycles != 0)
        Parts += formatv("{0}{1} {2}", Parts.empty() ? "" : ", ", Part.Name,
                         percent(Cycles / Whole));
    }
    row(Name, Sum, Parts);
  }
};

} // namespace

void writeLosses(const RunSummary &Run, raw_ostream &OS) {
  LossWriter(Run, OS).write();
}

} // namespace tp
