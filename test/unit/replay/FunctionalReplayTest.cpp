//===- FunctionalReplayTest.cpp - Back and forth without timing -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Random programs whose threads use the same memory. What a replay shows at any
// moment is compared with a machine that runs from the start to there and keeps
// nothing, and its end with a machine that is never stopped.
//
//===----------------------------------------------------------------------===//

#include "simulator/functional/FunctionalMachine.h"
#include "simulator/replay/Replay.h"
#include "test/unit/oracle/RandomProgram.h"

#include "gtest/gtest.h"

#include <algorithm>
#include <cstring>

using namespace tp;
using namespace tp::test;

namespace {

/// What can be seen of a machine at a moment.
struct State {
  std::vector<std::array<uint32_t, NumRegisters>> Registers;
  std::vector<uint32_t> Pcs;
  std::vector<uint64_t> Issued;
  std::vector<uint8_t> Memory;
  std::vector<uint8_t> LocalStores;
  std::vector<uint64_t> Executed;

  bool operator==(const State &) const = default;
};

void addMemory(State &To, const Memory &Global) {
  To.Memory.assign(Global.data() + kGlobalMemoryBegin,
                   Global.data() + Global.size());
}

void addCounts(State &To, const Statistics &Counts) {
  for (const PcStatistics &Pc : Counts.Pcs)
    To.Executed.push_back(Pc.Executed);
}

/// Some programs do not end; with many instructions, turns end by themselves.
constexpr uint32_t FewInstructions = 5000;
constexpr uint32_t ManyInstructions = 100000;

/// A random program, a chip for it, and how it ends.
struct Subject {
  uint32_t Most;
  RandomSource Random;
  ChipConfig Chip;
  RandomProgram Source;
  Program Text;
  LocalStoreRange Local;
  State End;
  uint64_t Instructions = 0;
  RunResult Result;

  explicit Subject(uint64_t Seed, uint32_t Most = FewInstructions)
      : Most(Most), Random(Seed), Chip(randomChip(Random)),
        Source(Random,
               Seed % 3 ? ProgramShape::Branching : ProgramShape::StraightLine,
               Chip),
        Text(Source.text()), Local(Chip.LocalStoreBytes) {
    End = run(Most, &Result);
    for (uint64_t Issued : End.Issued)
      Instructions += Issued;
  }
  bool traps() const { return Result.End == RunResult::Trapped; }

  /// By a machine from the start to before an instruction, or to the end before
  /// that.
  State run(uint64_t Before, RunResult *How = nullptr) const {
    Memory Global(Chip.MemoryBytes);
    Source.initialize(Global);
    FunctionalMachine Machine(Chip, Text, Global);
    FunctionalLimits Limits;
    Limits.PauseBefore = Before;
    const RunResult Ended = Machine.run(Limits);
    if (How)
      *How = Ended;
    State Seen;
    for (const ArchitecturalState &T : Machine.threads()) {
      Seen.Registers.push_back(T.Registers);
      Seen.Pcs.push_back(T.Pc);
      Seen.LocalStores.insert(Seen.LocalStores.end(), T.LocalStore,
                              T.LocalStore + Local.Size);
    }
    const Statistics Counts = Machine.statistics();
    for (const ThreadStatistics &T : Counts.Threads)
      Seen.Issued.push_back(T.Instructions);
    addCounts(Seen, Counts);
    addMemory(Seen, Global);
    return Seen;
  }
};

/// A replay and its memory.
struct Replayed {
  const Subject &S;
  Memory Global;
  std::unique_ptr<Replay> Run;
  std::string Output;

  explicit Replayed(Subject &S) : S(S), Global(S.Chip.MemoryBytes) {
    S.Source.initialize(Global);
    ReplayOptions Request;
    Request.MaxCycles = S.Most;
    Request.CheckpointCycles = S.Random.between(S.Most / 500, S.Most / 15);
    // Some runs must do with few.
    if (S.Random.oneIn(3))
      Request.CheckpointBytes = S.Random.between(1, 4) << 16;
    Request.Output = [this](int, std::string_view Bytes) { Output += Bytes; };
    std::string Error;
    Run =
        makeFunctionalReplay(S.Chip, S.Text, Global, std::move(Request), Error);
    EXPECT_EQ(Error, "");
  }

  State state() const {
    State Seen;
    for (uint32_t I = 0; I != Run->threadCount(); ++I) {
      const ReplayThread T = Run->thread(I);
      Seen.Registers.push_back(T.Registers);
      Seen.Pcs.push_back(T.Pc);
      Seen.Issued.push_back(T.Instructions);
      std::vector<uint8_t> Bytes(S.Local.Size);
      if (!Bytes.empty())
        EXPECT_TRUE(Run->read(I, S.Local.Begin, Bytes));
      Seen.LocalStores.insert(Seen.LocalStores.end(), Bytes.begin(),
                              Bytes.end());
    }
    addCounts(Seen, Run->statistics());
    addMemory(Seen, Global);
    return Seen;
  }

  /// All events of a run, forward.
  std::vector<ReplayStop> all(const Events &Wanted) {
    std::vector<ReplayStop> Stops;
    Run->goTo({});
    while (true) {
      ReplayStop Stop = Run->forward(Wanted);
      if (Stop.Kind != ReplayStop::Instruction &&
          Stop.Kind != ReplayStop::Access)
        return Stops;
      Stops.push_back(std::move(Stop));
    }
  }
};

constexpr uint64_t Programs = 40;
constexpr unsigned MomentsOfEach = 25;

TEST(FunctionalReplay, AnyMomentIsAsForwardExecutionHadIt) {
  for (uint64_t Seed = 1; Seed <= Programs; ++Seed) {
    Subject S(Seed, ManyInstructions);
    Replayed R(S);
    for (unsigned I = 0; I != MomentsOfEach; ++I) {
      const uint64_t Time = S.Random.below(uint32_t(S.Instructions));
      R.Run->goTo({Time, 0});
      ASSERT_EQ(R.Run->now().Time, Time) << "seed " << Seed;
      ASSERT_TRUE(R.state() == S.run(Time))
          << "seed " << Seed << " time " << Time;
    }
  }
}

TEST(FunctionalReplay, TheEndIsThatOfARunWithoutStops) {
  for (uint64_t Seed = 1; Seed <= Programs; ++Seed) {
    Subject S(Seed, ManyInstructions);
    Replayed R(S);
    R.Run->goTo({S.Random.below(uint32_t(S.Instructions)), 0});
    const ReplayStop Stop = R.Run->forward({});
    EXPECT_EQ(Stop.At.Time, S.Instructions) << "seed " << Seed;
    ASSERT_EQ(Stop.Kind == ReplayStop::Trapped, S.traps()) << "seed " << Seed;
    if (!S.traps()) {
      const bool Halts = S.Result.End == RunResult::Halted;
      EXPECT_EQ(Stop.Kind, Halts ? ReplayStop::Halted : ReplayStop::CycleLimit);
      EXPECT_EQ(Stop.ExitStatus, S.Result.ExitStatus);
      EXPECT_TRUE(R.state() == S.End) << "seed " << Seed;
      continue;
    }
    EXPECT_EQ(Stop.Thread, S.Result.TrapInfo->Thread);
    EXPECT_EQ(Stop.Pc, S.Result.TrapInfo->Pc);
    EXPECT_EQ(Stop.TrapInfo->Kind, S.Result.TrapInfo->Kind);
    EXPECT_EQ(R.Run->thread(Stop.Thread).State, ThreadState::Running);
    EXPECT_EQ(R.Run->forward({}).Kind, ReplayStop::Trapped);
  }
}

TEST(FunctionalReplay, EveryExecutionOfAnInstructionStopsOnce) {
  for (uint64_t Seed = 1; Seed <= Programs; ++Seed) {
    Subject S(Seed);
    if (S.traps())
      continue;
    Replayed R(S);
    Events Wanted;
    uint64_t Expected = 0;
    InstructionEvents &Some = Wanted.Instructions.emplace_back();
    for (unsigned I = 0; I != 3; ++I) {
      const auto Word = S.Random.below(uint32_t(S.End.Executed.size()));
      const uint32_t Pc = S.Text.textBegin() + Word * 4;
      const Opcode Op = S.Text.instructions()[Word].Op;
      if (Op == IllegalOpcode || !takesTime(Op) ||
          std::ranges::count(Some.Pcs, Pc) != 0)
        continue;
      Some.Pcs.push_back(Pc);
      Expected += S.End.Executed[Word];
    }
    if (Some.Pcs.empty())
      continue;
    const std::vector<ReplayStop> Stops = R.all(Wanted);
    // The very first moment is where a run begins, and is not behind itself.
    const bool BeginsThere = std::ranges::count(Some.Pcs, S.Source.Entry) != 0;
    EXPECT_EQ(Stops.size() + BeginsThere, Expected) << "seed " << Seed;
    EXPECT_TRUE(std::ranges::is_sorted(Stops, std::less(), &ReplayStop::At));
    for (size_t I = Stops.size(); I-- != 0;) {
      const ReplayStop Stop = R.Run->backward(Wanted);
      ASSERT_EQ(Stop.Kind, ReplayStop::Instruction) << "seed " << Seed;
      EXPECT_EQ(Stop.At, Stops[I].At);
      EXPECT_EQ(Stop.Thread, Stops[I].Thread);
      EXPECT_EQ(R.Run->thread(Stop.Thread).Pc, Stop.Pc);
    }
  }
}

TEST(FunctionalReplay, EveryMomentIsOneInstruction) {
  Subject S(2);
  Replayed R(S);
  Events Every;
  Every.Instructions.emplace_back();
  uint64_t Time = 0;
  for (const ReplayStop &Stop : R.all(Every))
    EXPECT_EQ(Stop.At.Time, ++Time);
  EXPECT_EQ(Time + 1, S.Instructions + S.traps());
}

TEST(FunctionalReplay, WritesAreFoundForwardAndBackwardAndByWhoWrote) {
  unsigned Found = 0;
  for (uint64_t Seed = 1; Seed <= Programs; ++Seed) {
    Subject S(Seed);
    if (S.traps() || S.Source.Data.empty())
      continue;
    Replayed R(S);
    Events Wanted;
    AccessEvents &Watched = Wanted.Accesses.emplace_back();
    const size_t Which = S.Random.below(uint32_t(S.Source.Data.size()));
    Watched.Address = S.Source.Data[Which].first;
    Watched.Bytes = 4;
    const std::vector<ReplayStop> Stops = R.all(Wanted);
    Found += unsigned(Stops.size());
    uint8_t Last[4];
    std::memcpy(Last, &S.Source.Data[Which].second, 4);
    for (const ReplayStop &Stop : Stops) {
      EXPECT_TRUE(Stop.IsWrite);
      ASSERT_EQ(Stop.Old.size(), 4u);
      EXPECT_EQ(std::memcmp(Stop.Old.data(), Last, 4), 0) << "seed " << Seed;
      std::memcpy(Last, Stop.New.data(), 4);
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
    EXPECT_TRUE(std::holds_alternative<AsLoaded>(
        R.Run->lastWrite(0, Watched.Address, 4)));
  }
  EXPECT_GT(Found, 0u);
}

TEST(FunctionalReplay, AChangeIsMadeAgain) {
  for (uint64_t Seed = 1; Seed <= Programs; ++Seed) {
    Subject S(Seed);
    Replayed R(S);
    const uint64_t Changed = S.Random.below(uint32_t(S.Instructions));
    R.Run->goTo({Changed, 0});
    const uint32_t Value = S.Random.word();
    uint8_t Bytes[4];
    std::memcpy(Bytes, &Value, 4);
    if (!S.Source.Data.empty()) {
      EXPECT_TRUE(R.Run->write(0, S.Source.Data[0].first, Bytes));
      EXPECT_TRUE(std::holds_alternative<WrittenByUser>(
          R.Run->lastWrite(0, S.Source.Data[0].first, 4)));
    }
    EXPECT_FALSE(R.Run->write(0, S.Text.textBegin(), Bytes));
    R.Run->setRegister(0, 7, Value);
    EXPECT_EQ(R.Run->thread(0).Registers[7], Value);
    R.Run->goTo({Changed + S.Random.below(100), 0});
    const Moment There = R.Run->now();
    const State Expected = R.state();
    R.Run->goTo({S.Random.below(uint32_t(Changed) + 1), 0});
    R.Run->goTo(There);
    EXPECT_TRUE(R.state() == Expected) << "seed " << Seed;
    if (Changed != 0) {
      R.Run->goTo({Changed - 1, 0});
      EXPECT_TRUE(R.state() == S.run(Changed - 1)) << "seed " << Seed;
    }
  }
}

TEST(FunctionalReplay, OutputIsShownOnce) {
  for (uint64_t Seed = 1; Seed <= Programs; ++Seed) {
    Subject S(Seed);
    Replayed R(S);
    R.Run->forward({});
    const std::string Once = R.Output;
    R.Run->backward({});
    EXPECT_EQ(R.Run->now(), Moment());
    R.Run->forward({});
    EXPECT_EQ(R.Output, Once);
  }
}

} // namespace
