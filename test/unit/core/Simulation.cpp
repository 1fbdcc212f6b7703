//===- Simulation.cpp - A small chip that runs a test program -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/core/Simulation.h"

#include "simulator/core/CodeGenerator.h"

#include "gtest/gtest.h"

#include <numeric>
#include <utility>

namespace tp::test {

ChipConfig quietChip(uint32_t TmCount, uint32_t TpsPerTm) {
  ChipConfig Chip;
  Chip.TmCount = TmCount;
  Chip.TpsPerTm = TpsPerTm;
  Chip.ArbitrationWindow = 16;
  Chip.MemoryLatency = 20;
  Chip.LocalStoreBytes = LocalStoreBytes;
  Chip.MemoryBytes = 1 << 20;
  Chip.IcacheBanks = 1;
  Chip.IcachePorts = TpsPerTm;
  for (UnitConfig &Type : Chip.Units)
    Type.Count = TpsPerTm;
  for (unsigned I = 0; I != NumLatencyClasses; ++I)
    Chip.Latency[I] = defaultLatency(LatencyClass(I));
  return Chip;
}

std::unique_ptr<CodeGenerator> (*Simulation::DefaultGenerator)() = nullptr;

Simulation::Simulation(const ChipConfig &Chip, const Assembly &Source,
                       unsigned HostThreads,
                       std::unique_ptr<MemorySystem> Hierarchy)
    : Chip(Chip), Global(Chip.MemoryBytes),
      Text(TextBegin, Source.words(), TextBegin),
      Simulated(this->Chip, Text, Global, std::move(Hierarchy)) {
  EXPECT_EQ(Simulated.error(), "");
  Simulated.setHostThreads(HostThreads);
  Simulated.setOutput([this](int, std::string_view Bytes) { Output += Bytes; });
}

void Simulation::record() {
  Recorder =
      std::make_unique<ExecutionRecorder>(Chip, Text, std::vector<uint32_t>());
  Simulated.setRecorder(*Recorder);
}

RunResult Simulation::run(uint64_t MaxCycles) {
  RunLimits Limits;
  Limits.MaxCycles = MaxCycles;
  return run(Limits);
}

RunResult Simulation::run(const RunLimits &Limits) {
  if (NewGenerator)
    Simulated.setCodeGenerator(std::exchange(NewGenerator, nullptr)());
  RunResult Result = Simulated.run(Limits);
  Counts = Simulated.statistics();
  expectConsistentStatistics();
  return Result;
}

uint64_t Simulation::cycles() {
  EXPECT_EQ(run().End, RunResult::Halted);
  return statistics().Cycles;
}

uint32_t Simulation::word(uint32_t Address) const {
  uint32_t Value = 0;
  EXPECT_TRUE(Global.read(Address, &Value, sizeof(Value)));
  return Value;
}

void Simulation::setWord(uint32_t Address, uint32_t Value) {
  EXPECT_TRUE(Global.write(Address, &Value, sizeof(Value)));
}

void Simulation::expectConsistentStatistics() const {
  const Statistics &S = statistics();
  LossCounts Lost{};
  uint64_t Issued = 0, Waited = 0, Conflicts = 0;
  for (const ThreadStatistics &T : S.Threads) {
    uint64_t Sum =
        std::accumulate(T.Lost.begin(), T.Lost.end(), T.Instructions);
    EXPECT_EQ(Sum, S.Cycles);
    for (unsigned I = 0; I != NumLosses; ++I)
      Lost[I] += T.Lost[I];
    Issued += T.Instructions;
    for (unsigned I = 0; I != NumLosses; ++I)
      if (isWaitForResult(Loss(I)))
        Waited += T.Lost[I];
    Conflicts += T.Lost[unsigned(Loss::UnitConflict)];
  }
  uint64_t IssuedAt = 0;
  LossCounts LostAt{};
  for (const PcStatistics &Pc : S.Pcs) {
    IssuedAt += Pc.Executed;
    for (unsigned I = 0; I != NumLosses; ++I)
      LostAt[I] += Pc.Lost[I];
  }
  EXPECT_EQ(IssuedAt, Issued);
  for (unsigned I = 0; I != unsigned(Loss::Finished); ++I)
    EXPECT_EQ(LostAt[I], Lost[I]) << "loss " << I;
  auto Total = [](const auto &Counts) {
    return std::accumulate(Counts.begin(), Counts.end(), uint64_t(0));
  };
  EXPECT_EQ(Total(S.Executed), Issued);
  EXPECT_EQ(Total(S.DataStall), Waited);
  EXPECT_EQ(Total(S.UnitConflict), Conflicts);
}

} // namespace tp::test
