//===- CycleReplayTest.cpp - Going back is as if never gone on ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Random programs on random chips, with and without caches and DRAM, in which
// threads use the same memory. What a replay shows at any moment is compared
// with an engine that runs from the start to there and knows no replay.
//
//===----------------------------------------------------------------------===//

#include "simulator/replay/Replay.h"
#include "test/unit/oracle/RandomProgram.h"

#include "gtest/gtest.h"

#include <algorithm>
#include <cstring>

using namespace tp;
using namespace tp::test;

namespace {

/// Many programs would never end.
constexpr uint64_t MostCycles = 3000;

/// A random program, a chip for it, and how it ends.
struct Subject {
  RandomSource Random;
  ChipConfig Chip;
  RandomProgram Source;
  Program Text;
  uint64_t End = 0;
  bool Traps = false;

  explicit Subject(uint64_t Seed)
      : Random(Seed),
        Chip(Seed % 2 ? randomMemoryChip(Random) : randomChip(Random)),
        Source(Random,
               Seed % 3 ? ProgramShape::Branching : ProgramShape::StraightLine,
               Chip),
        Text(Source.text()) {
    Memory Global(Chip.MemoryBytes);
    Source.initialize(Global);
    Engine Machine(Chip, Text, Global, makeMemorySystem(Chip));
    RunLimits Limits;
    Limits.MaxCycles = MostCycles;
    const RunResult Result = Machine.run(Limits);
    Traps = Result.End == RunResult::Trapped;
    End = Traps ? Result.TrapInfo->Cycle : Machine.cycles();
  }
};

/// What can be seen of a machine at a moment.
struct State {
  std::vector<std::array<uint32_t, NumRegisters>> Registers;
  std::vector<uint32_t> Words;
  std::vector<uint8_t> Memory;
  std::vector<uint64_t> Executed;
  std::vector<LossCounts> Lost;

  bool operator==(const State &) const = default;
};

void addCounts(State &To, const Statistics &Counts) {
  for (const PcStatistics &Pc : Counts.Pcs)
    To.Executed.push_back(Pc.Executed);
  for (const ThreadStatistics &Thread : Counts.Threads)
    To.Lost.push_back(Thread.Lost);
}

/// By an engine that is cut off there.
State stateByEngine(const Subject &S, uint64_t Cycle) {
  Memory Global(S.Chip.MemoryBytes);
  S.Source.initialize(Global);
  Engine Machine(S.Chip, S.Text, Global, makeMemorySystem(S.Chip));
  State Result;
  if (Cycle != 0) {
    RunLimits Limits;
    Limits.MaxCycles = Cycle;
    Machine.run(Limits);
    addCounts(Result, Machine.statistics());
  }
  for (uint32_t I = 0; I != S.Chip.threadCount(); ++I) {
    Result.Registers.push_back(Machine.thread(I).Registers);
    Result.Words.push_back(Machine.placeOf(I).Word);
  }
  Result.Memory.assign(Global.data() + kGlobalMemoryBegin,
                       Global.data() + Global.size());
  return Result;
}

State stateOf(const Replay &R, const Subject &S, const Memory &Global) {
  State Result;
  if (R.now().Time != 0)
    addCounts(Result, R.statistics());
  for (uint32_t I = 0; I != S.Chip.threadCount(); ++I) {
    const ReplayThread Thread = R.thread(I);
    Result.Registers.push_back(Thread.Registers);
    Result.Words.push_back((Thread.Pc - S.Text.textBegin()) / 4);
  }
  Result.Memory.assign(Global.data() + kGlobalMemoryBegin,
                       Global.data() + Global.size());
  return Result;
}

/// A replay and its memory.
struct Replayed {
  Memory Global;
  std::unique_ptr<Replay> Run;
  std::string Output;

  Replayed(const Subject &S, ReplayOptions Request)
      : Global(S.Chip.MemoryBytes) {
    S.Source.initialize(Global);
    std::string Error;
    Request.Output = [this](int, std::string_view Bytes) { Output += Bytes; };
    Run = makeCycleReplay(S.Chip, S.Text, Global, std::move(Request), Error);
    EXPECT_EQ(Error, "");
  }
};

ReplayOptions frequentCheckpoints(RandomSource &Random) {
  ReplayOptions Request;
  Request.MaxCycles = MostCycles;
  Request.CheckpointCycles = Random.between(1, 200);
  Request.HostThreads = Random.between(1, 2);
  // Some runs must do with few.
  if (Random.oneIn(3))
    Request.CheckpointBytes = Random.between(1, 4) << 16;
  return Request;
}

constexpr uint64_t Programs = 40;
constexpr unsigned MomentsOfEach = 25;

TEST(CycleReplay, AnyMomentIsAsForwardExecutionHadIt) {
  for (uint64_t Seed = 1; Seed <= Programs; ++Seed) {
    Subject S(Seed);
    Replayed R(S, frequentCheckpoints(S.Random));
    for (unsigned I = 0; I != MomentsOfEach; ++I) {
      const uint64_t Cycle = S.Random.below(uint32_t(S.End) + 1);
      R.Run->goTo({Cycle, 0});
      ASSERT_EQ(R.Run->now().Time, Cycle) << "seed " << Seed;
      ASSERT_TRUE(stateOf(*R.Run, S, R.Global) == stateByEngine(S, Cycle))
          << "seed " << Seed << " cycle " << Cycle;
    }
  }
}

/// Moments and threads of all events, forward.
std::vector<ReplayStop> allForward(Replay &R, const Events &Wanted) {
  std::vector<ReplayStop> Stops;
  R.goTo({});
  while (true) {
    ReplayStop Stop = R.forward(Wanted);
    if (Stop.Kind != ReplayStop::Instruction && Stop.Kind != ReplayStop::Access)
      return Stops;
    Stops.push_back(std::move(Stop));
  }
}

TEST(CycleReplay, EveryIssueOfAnInstructionStopsOnce) {
  for (uint64_t Seed = 1; Seed <= Programs; ++Seed) {
    Subject S(Seed);
    if (S.Traps)
      continue;
    Replayed R(S, frequentCheckpoints(S.Random));
    const State AtEnd = stateByEngine(S, S.End);
    Events Wanted;
    uint64_t Expected = 0;
    InstructionEvents &Some = Wanted.Instructions.emplace_back();
    for (unsigned I = 0; I != 3; ++I) {
      const auto Word = S.Random.below(uint32_t(AtEnd.Executed.size()));
      const uint32_t Pc = S.Text.textBegin() + Word * 4;
      const Opcode Op = S.Text.instructions()[Word].Op;
      if (Op == IllegalOpcode || !takesTime(Op) ||
          std::ranges::count(Some.Pcs, Pc) != 0)
        continue;
      Some.Pcs.push_back(Pc);
      Expected += AtEnd.Executed[Word];
    }
    if (Some.Pcs.empty())
      continue;
    std::vector<ReplayStop> Stops = allForward(*R.Run, Wanted);
    // The very first moment is where a run begins, and is not behind itself.
    EXPECT_LE(Expected - Stops.size(), Expected ? 1u : 0u) << "seed " << Seed;
    for (const ReplayStop &Stop : Stops)
      EXPECT_EQ(std::ranges::count(Some.Pcs, Stop.Pc), 1);
    EXPECT_TRUE(std::ranges::is_sorted(Stops, std::less(), &ReplayStop::At));
    for (size_t I = Stops.size(); I-- != 0;) {
      const ReplayStop Stop = R.Run->backward(Wanted);
      ASSERT_EQ(Stop.Kind, ReplayStop::Instruction) << "seed " << Seed;
      EXPECT_EQ(Stop.At, Stops[I].At);
      EXPECT_EQ(Stop.Thread, Stops[I].Thread);
      EXPECT_EQ(R.Run->thread(Stop.Thread).Pc, Stop.Pc);
      if (I % 8 == 0)
        EXPECT_TRUE(stateOf(*R.Run, S, R.Global) ==
                    stateByEngine(S, Stop.At.Time))
            << "seed " << Seed;
    }
  }
}

TEST(CycleReplay, WritesAreFoundForwardAndBackwardAndByWhoWrote) {
  for (uint64_t Seed = 1; Seed <= Programs; ++Seed) {
    Subject S(Seed);
    if (S.Traps || S.Source.Data.empty())
      continue;
    Replayed R(S, frequentCheckpoints(S.Random));
    Events Wanted;
    AccessEvents &Watched = Wanted.Accesses.emplace_back();
    const size_t Which = S.Random.below(uint32_t(S.Source.Data.size()));
    Watched.Address = S.Source.Data[Which].first;
    Watched.Bytes = 4;
    std::vector<ReplayStop> Stops = allForward(*R.Run, Wanted);
    std::vector<uint8_t> Before;
    for (const ReplayStop &Stop : Stops) {
      EXPECT_TRUE(Stop.IsWrite);
      ASSERT_EQ(Stop.Old.size(), 4u);
    }
    for (size_t I = Stops.size(); I-- != 0;) {
      const LastWrite Writer = R.Run->lastWrite(0, Watched.Address, 4);
      ASSERT_TRUE(std::holds_alternative<WriteRecord>(Writer));
      const ReplayStop Stop = R.Run->backward(Wanted);
      ASSERT_EQ(Stop.Kind, ReplayStop::Access) << "seed " << Seed;
      EXPECT_EQ(std::get<WriteRecord>(Writer).At, Stop.At);
      EXPECT_EQ(std::get<WriteRecord>(Writer).Pc, Stop.Pc);
      EXPECT_EQ(Stop.Thread, Stops[I].Thread);
      EXPECT_EQ(Stop.Old, Stops[I].Old);
      EXPECT_EQ(Stop.New, Stops[I].New);
    }
  }
}

TEST(CycleReplay, AChangeIsMadeAgain) {
  for (uint64_t Seed = 1; Seed <= Programs; ++Seed) {
    Subject S(Seed);
    Replayed R(S, frequentCheckpoints(S.Random));
    const uint64_t Changed = S.Random.below(uint32_t(S.End) + 1);
    R.Run->goTo({Changed, 0});
    const uint32_t Value = S.Random.word();
    uint8_t Bytes[4];
    std::memcpy(Bytes, &Value, 4);
    if (!S.Source.Data.empty())
      EXPECT_TRUE(R.Run->write(0, S.Source.Data[0].first, Bytes));
    R.Run->setRegister(0, 7, Value);
    EXPECT_EQ(R.Run->thread(0).Registers[7], Value);
    const uint64_t Later = Changed + S.Random.below(100);
    R.Run->goTo({Later, 0});
    const Moment There = R.Run->now();
    const State Expected = stateOf(*R.Run, S, R.Global);
    R.Run->goTo({S.Random.below(uint32_t(Changed) + 1), 0});
    R.Run->goTo(There);
    EXPECT_TRUE(stateOf(*R.Run, S, R.Global) == Expected) << "seed " << Seed;
    if (Changed != 0) {
      R.Run->goTo({Changed - 1, 0});
      EXPECT_TRUE(stateOf(*R.Run, S, R.Global) == stateByEngine(S, Changed - 1))
          << "seed " << Seed;
    }
  }
}

TEST(CycleReplay, OutputIsShownOnce) {
  for (uint64_t Seed = 1; Seed <= Programs; ++Seed) {
    Subject S(Seed);
    Replayed R(S, frequentCheckpoints(S.Random));
    R.Run->forward({});
    const std::string Once = R.Output;
    R.Run->backward({});
    EXPECT_EQ(R.Run->now(), Moment());
    R.Run->forward({});
    EXPECT_EQ(R.Output, Once);
  }
}

} // namespace
