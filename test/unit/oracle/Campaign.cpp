//===- Campaign.cpp - Many random programs against the model --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/oracle/Campaign.h"

#include "gtest/gtest.h"

#include <cstdlib>

namespace tp::test {

namespace {

uint64_t fromEnvironment(const char *Name, uint64_t Default) {
  const char *Text = std::getenv(Name);
  return Text ? std::strtoull(Text, nullptr, 10) : Default;
}

/// Counts what the programs did, for the test that nothing is left out.
struct Coverage {
  std::array<uint64_t, NumOpcodes> Executed{};
  std::array<uint64_t, 3> Ends{};
  LossCounts Lost{};
  uint64_t ProfileValues = 0;
  uint64_t Markers = 0;

  void add(const RunRecord &Record) {
    for (unsigned I = 0; I != NumOpcodes; ++I)
      Executed[I] += Record.Counts.Executed[I];
    ++Ends[Record.Result.End];
    for (const auto &Values : Record.ProfileValues)
      ProfileValues += Values.size();
    for (uint64_t Count : Record.Counts.Markers)
      Markers += Count;
    for (const ThreadStatistics &T : Record.Counts.Threads)
      for (unsigned I = 0; I != NumLosses; ++I)
        Lost[I] += T.Lost[I];
  }
};

bool isOfMemorySystem(Loss Reason) {
  return Reason == Loss::L1 || Reason == Loss::L2 || Reason == Loss::Dram ||
         Reason == Loss::StoreBuffer;
}

void expectEverything(const Coverage &C, bool WithMemorySystem) {
  for (unsigned I = 0; I != NumLosses; ++I) {
    bool Expected = WithMemorySystem || !isOfMemorySystem(Loss(I));
    if (Loss(I) != Loss::IcacheMiss)
      EXPECT_EQ(C.Lost[I] != 0, Expected) << "loss " << I;
  }
  for (unsigned I = 0; I != NumOpcodes; ++I)
    if (takesTime(Opcode(I)) && Opcode(I) != Opcode::BREAK)
      EXPECT_NE(C.Executed[I], 0u) << mnemonic(Opcode(I));
  for (uint64_t Count : C.Ends)
    EXPECT_NE(Count, 0u);
  EXPECT_NE(C.ProfileValues, 0u);
  EXPECT_NE(C.Markers, 0u);
}

} // namespace

void checkPrograms(ProgramShape Shape, ChipMaker MakeChip, uint64_t Count,
                   const EngineRun &Run) {
  uint64_t First = fromEnvironment("TP_ORACLE_SEED", 1);
  Count = fromEnvironment("TP_ORACLE_PROGRAMS", Count);
  Coverage C;
  for (uint64_t Seed = First; Seed != First + Count; ++Seed) {
    RandomSource Random(Seed);
    ChipConfig Chip = MakeChip(Random);
    RandomProgram Source(Random, Shape, Chip);
    uint64_t MaxCycles = Random.oneIn(4) ? Random.between(1, 1000) : 20000;
    RunRecord Model = runModel(Chip, Source, MaxCycles);
    C.add(Model);
    std::string Different =
        differences(Model, runEngine(Chip, Source, MaxCycles, Run));
    ASSERT_EQ(Different, "") << "TP_ORACLE_SEED=" << Seed;
  }
  if (Count >= 1000)
    expectEverything(C, MakeChip == randomMemoryChip);
}

} // namespace tp::test
