//===- ChipEnergyTest.cpp - Energy of a run by part -----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/stats/ChipEnergy.h"

#include "gtest/gtest.h"

using namespace tp;

namespace {

constexpr double Nj = 1e-9;

/// A chip in which a part's operation takes a nJ figure of its own.
ChipConfig chipWithCosts() {
  ChipConfig Chip;
  Chip.ClockGHz = 2;
  Chip.LocalStoreBytes = 1024;
  Chip.IcacheBanks = 1;
  Chip.IcachePorts = 1;
  Chip.IcacheBytes = 4096;
  TechnologyConfig T;
  for (unsigned I = 0; I != NumUnits; ++I)
    T.Units[I].EnergyNj = 100 + I;
  T.RegisterFile.EnergyNj = 3;
  T.LocalStore = {1024, {0, 5, {}}};
  T.IcacheBytes = 4096;
  T.Icache[0].EnergyNj = 7;
  // 16 KiB: 11 + 4 x 2 = 19.
  T.Cache[2] = {0, 0, 11, 2, {}};
  T.Crossbar.EnergyNj = 0.5;
  Chip.Technology = T;
  return Chip;
}

const EnergyPart &partOf(const std::vector<EnergyPart> &Parts,
                         std::string_view Name) {
  for (const EnergyPart &Part : Parts)
    if (Part.Name == Name)
      return Part;
  ADD_FAILURE() << Name;
  return Parts.front();
}

// 10 add (rd, rs, rt), 4 addi (rd, rs) and 6 lw (rd, rs), of which 2 go to
// global memory: 14 operations of INTADD, 6 of MEMORY, 20 fetches, 4 accesses
// to local stores, 3 x 10 + 2 x 4 + 2 x 6 = 50 accesses to registers.
TEST(ChipEnergy, CountsOperationsFetchesAndRegisterOperands) {
  ChipConfig Chip = chipWithCosts();
  Statistics Stats;
  Stats.Cycles = 1000;
  Stats.Executed[unsigned(Opcode::ADD)] = 10;
  Stats.Executed[unsigned(Opcode::ADDI)] = 4;
  Stats.Executed[unsigned(Opcode::LW)] = 6;
  Stats.GlobalAccesses = 2;
  std::vector<EnergyPart> Parts = chipEnergy(Chip, Stats);
  ASSERT_EQ(Parts.size(), NumUnits + 3);
  double IntAdd = 14 * (100.0 + unsigned(Unit::INTADD)) * Nj;
  double Memory = 6 * (100.0 + unsigned(Unit::MEMORY)) * Nj;
  EXPECT_EQ(Parts[unsigned(Unit::INTADD)].Operations, 14u);
  EXPECT_DOUBLE_EQ(Parts[unsigned(Unit::INTADD)].Joules, IntAdd);
  EXPECT_DOUBLE_EQ(Parts[unsigned(Unit::MEMORY)].Joules, Memory);
  EXPECT_EQ(partOf(Parts, "register_file").Operations, 50u);
  EXPECT_EQ(partOf(Parts, "local_store").Operations, 4u);
  EXPECT_EQ(partOf(Parts, "icache").Operations, 20u);
  double Total = IntAdd + Memory + (50 * 3 + 4 * 5 + 20 * 7) * Nj;
  EXPECT_NEAR(totalEnergyJ(Chip, Stats), Total, 1e-15);
  // 1000 cycles at 2 GHz are 500 ns.
  EXPECT_NEAR(averagePowerW(Chip, Stats), Total / 500e-9, 1e-6);
}

// Requests, fills and lines written back are accesses of a cache.
TEST(ChipEnergy, CountsTheMemorySystem) {
  ChipConfig Chip = chipWithCosts();
  Chip.L1 = CacheConfig{.Bytes = 16 << 10, .LineBytes = 64, .Banks = 4};
  Chip.Crossbar = CrossbarConfig();
  Chip.Dram = DramConfig();
  Chip.Dram->Channels = 2;
  Chip.Dram->Energy = DramEnergy{{"test", false}, 2, 3, 4, 50, 0.25};
  Statistics Stats;
  Stats.Cycles = 1000;
  Stats.Memory.emplace();
  CacheStatistics L1;
  L1.Loads = 30;
  L1.Stores = 20;
  L1.Misses = 7;
  L1.WritebackBytes = 192; // 3 lines
  Stats.Memory->L1 = L1;
  Stats.Memory->Crossbar.emplace();
  Stats.Memory->Crossbar->RequestBytes = 100;
  Stats.Memory->Crossbar->AnswerBytes = 300;
  Stats.Memory->DramChannels.resize(2);
  Stats.Memory->DramChannels[0].Activates = 5;
  Stats.Memory->DramChannels[0].Reads = 10;
  Stats.Memory->DramChannels[1].Writes = 6;
  Stats.Memory->DramChannels[1].Refreshes = 1;
  std::vector<EnergyPart> Parts = chipEnergy(Chip, Stats);
  EXPECT_EQ(partOf(Parts, "l1").Operations, 60u);
  EXPECT_DOUBLE_EQ(partOf(Parts, "l1").Joules, 60 * 19 * Nj);
  EXPECT_DOUBLE_EQ(partOf(Parts, "crossbar").Joules, 400 * .5 * Nj);
  EXPECT_EQ(partOf(Parts, "dram").Operations, 22u);
  // 500 ns of two channels of .25 W are 250 nJ.
  EXPECT_DOUBLE_EQ(partOf(Parts, "dram").Joules,
                   (5 * 2 + 10 * 3 + 6 * 4 + 50 + 250) * Nj);
}

TEST(ChipEnergy, IsNothingWithoutATechnology) {
  ChipConfig Chip = chipWithCosts();
  Chip.Technology.reset();
  Statistics Stats;
  Stats.Cycles = 10;
  Stats.Executed[unsigned(Opcode::ADD)] = 10;
  EXPECT_EQ(totalEnergyJ(Chip, Stats), 0);
  EXPECT_EQ(averagePowerW(Chip, Statistics()), 0);
}

} // namespace
