//===- ChipEnergy.cpp - Energy of a run by part ---------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/stats/ChipEnergy.h"

#include "simulator/chip/PartCosts.h"

namespace tp {
namespace {

constexpr double JoulesPerNj = 1e-9;

/// What the instructions did to the parts within the TMs.
struct Activity {
  std::array<uint64_t, NumUnits> UnitOperations{};
  uint64_t RegisterAccesses = 0;
  uint64_t LocalStoreAccesses = 0;
  uint64_t Fetches = 0;

  explicit Activity(const Statistics &Stats) {
    for (unsigned I = 0; I != NumOpcodes; ++I) {
      Opcode Op = Opcode(I);
      if (!takesTime(Op))
        continue;
      uint64_t Executed = Stats.Executed[I];
      UnitOperations[unsigned(unitOf(Op))] += Executed;
      Fetches += Executed;
      for (const OperandInfo &Operand : operandsOf(Op))
        if (Operand.Kind != OperandKind::Immediate)
          RegisterAccesses += Executed;
    }
    LocalStoreAccesses =
        UnitOperations[unsigned(Unit::MEMORY)] - Stats.GlobalAccesses;
  }
};

} // namespace

static uint64_t cacheAccesses(const CacheStatistics &Cache,
                              uint32_t LineBytes) {
  return Cache.Loads + Cache.Stores + Cache.Atomics + Cache.Fetches +
         Cache.Misses + Cache.WritebackBytes / LineBytes;
}

static double seconds(const ChipConfig &Chip, uint64_t Cycles) {
  return double(Cycles) / (Chip.ClockGHz * 1e9);
}

/// Of the chip's DRAM in a run of \p Cycles.
static EnergyPart
dramEnergy(const ChipConfig &Chip, const DramConfig &Dram, uint64_t Cycles,
           const std::vector<DramChannelStatistics> &Channels) {
  const DramEnergy Each = Dram.Energy.value_or(DramEnergy());
  EnergyPart Part{"dram", 0, 0, Each.Source};
  for (const DramChannelStatistics &Channel : Channels) {
    Part.Operations +=
        Channel.Activates + Channel.Reads + Channel.Writes + Channel.Refreshes;
    Part.Joules += JoulesPerNj * (double(Channel.Activates) * Each.ActivateNj +
                                  double(Channel.Reads) * Each.ReadNj +
                                  double(Channel.Writes) * Each.WriteNj +
                                  double(Channel.Refreshes) * Each.RefreshNj);
  }
  Part.Joules += seconds(Chip, Cycles) * Dram.Channels * Each.BackgroundW;
  return Part;
}

std::vector<EnergyPart> chipEnergy(const ChipConfig &Chip,
                                   const Statistics &Stats) {
  std::vector<EnergyPart> Parts;
  auto Add = [&Parts](std::string Name, uint64_t Operations,
                      const PartCost &Each) {
    Parts.push_back({std::move(Name), Operations,
                     JoulesPerNj * double(Operations) * Each.EnergyNj,
                     Each.Source});
  };
  Activity Done(Stats);
  for (unsigned I = 0; I != NumUnits; ++I)
    Add(std::string(unitName(Unit(I))), Done.UnitOperations[I],
        unitCost(Chip, Unit(I)));
  Add("register_file", Done.RegisterAccesses, registerFileCost(Chip));
  Add("local_store", Done.LocalStoreAccesses, localStoreCost(Chip));
  Add("icache", Done.Fetches, icacheCost(Chip));
  if (!Stats.Memory)
    return Parts;
  const MemoryStatistics &Memory = *Stats.Memory;
  if (Chip.L1 && Memory.L1)
    Add("l1", cacheAccesses(*Memory.L1, Chip.L1->LineBytes),
        cacheCost(Chip, *Chip.L1));
  if (Chip.L2 && Memory.L2)
    Add("l2", cacheAccesses(*Memory.L2, Chip.L2->LineBytes),
        cacheCost(Chip, *Chip.L2));
  if (Chip.Crossbar && Memory.Crossbar)
    Add("crossbar",
        Memory.Crossbar->RequestBytes + Memory.Crossbar->AnswerBytes,
        crossbarCost(Chip));
  if (Chip.Dram)
    Parts.push_back(
        dramEnergy(Chip, *Chip.Dram, Stats.Cycles, Memory.DramChannels));
  return Parts;
}

double totalEnergyJ(const ChipConfig &Chip, const Statistics &Stats) {
  double Total = 0;
  for (const EnergyPart &Part : chipEnergy(Chip, Stats))
    Total += Part.Joules;
  return Total;
}

double averagePowerW(const ChipConfig &Chip, const Statistics &Stats) {
  return Stats.Cycles == 0
             ? 0
             : totalEnergyJ(Chip, Stats) / seconds(Chip, Stats.Cycles);
}

} // namespace tp
