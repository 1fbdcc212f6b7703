//===- ReplayTest.cpp - Going back is as if never gone on -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// What holds of replays with timing and without.
//
//===----------------------------------------------------------------------===//

#include "test/unit/replay/Subjects.h"

#include "gtest/gtest.h"

#include <algorithm>
#include <cstring>

using namespace tp;
using namespace tp::test;

namespace {

constexpr uint64_t Programs = 40;
constexpr unsigned MomentsOfEach = 25;

template <class SubjectType> class ReplayTest : public testing::Test {};

} // namespace

using Subjects = testing::Types<CycleSubject, FunctionalSubject>;
TYPED_TEST_SUITE(ReplayTest, Subjects);

TYPED_TEST(ReplayTest, AnyMomentIsAsForwardExecutionHadIt) {
  for (uint64_t Seed = 1; Seed <= Programs; ++Seed) {
    TypeParam S(Seed);
    Replayed R(S);
    for (unsigned I = 0; I != MomentsOfEach; ++I) {
      const uint64_t Time = S.Random.below(uint32_t(S.End));
      R.Run->goTo({Time, 0});
      ASSERT_EQ(R.Run->now().Time, Time) << "seed " << Seed;
      ASSERT_TRUE(R.state() == S.stateAt(Time))
          << "seed " << Seed << " time " << Time;
    }
  }
}

TYPED_TEST(ReplayTest, TheEndIsThatOfARunWithoutStops) {
  for (uint64_t Seed = 1; Seed <= Programs; ++Seed) {
    TypeParam S(Seed);
    Replayed R(S);
    R.Run->goTo({S.Random.below(uint32_t(S.End)), 0});
    const ReplayStop Stop = R.Run->forward({});
    EXPECT_EQ(Stop.At.Time, S.End) << "seed " << Seed;
    ASSERT_EQ(Stop.Kind == ReplayStop::Trapped, S.traps()) << "seed " << Seed;
    if (!S.traps()) {
      const bool Halts = S.Result.End == RunResult::Halted;
      EXPECT_EQ(Stop.Kind, Halts ? ReplayStop::Halted : ReplayStop::CycleLimit);
      EXPECT_EQ(Stop.ExitStatus, S.Result.ExitStatus);
      EXPECT_TRUE(R.state() == S.AtEnd) << "seed " << Seed;
      continue;
    }
    EXPECT_EQ(Stop.Thread, S.Result.TrapInfo->Thread);
    EXPECT_EQ(Stop.Pc, S.Result.TrapInfo->Pc);
    EXPECT_EQ(Stop.TrapInfo->Kind, S.Result.TrapInfo->Kind);
    EXPECT_EQ(R.Run->thread(Stop.Thread).State, ThreadState::Running);
    EXPECT_EQ(R.Run->forward({}).Kind, ReplayStop::Trapped);
  }
}

/// Up to three instructions of the text that take time.
static std::vector<uint32_t> somePcs(Subject &S) {
  std::vector<uint32_t> Pcs;
  for (unsigned I = 0; I != 3; ++I) {
    const auto Word = S.Random.below(uint32_t(S.AtEnd.Executed.size()));
    const uint32_t Pc = S.Text.textBegin() + Word * 4;
    const Opcode Op = S.Text.instructions()[Word].Op;
    if (Op != IllegalOpcode && takesTime(Op) &&
        std::ranges::count(Pcs, Pc) == 0 && S.AtEnd.Executed[Word] < 1000)
      Pcs.push_back(Pc);
  }
  return Pcs;
}

TYPED_TEST(ReplayTest, EveryExecutionOfAnInstructionStopsOnce) {
  for (uint64_t Seed = 1; Seed <= Programs; ++Seed) {
    TypeParam S(Seed);
    const std::vector<uint32_t> Pcs = somePcs(S);
    if (S.traps() || Pcs.empty())
      continue;
    Replayed R(S);
    Events Wanted;
    Wanted.Instructions.emplace_back().Pcs = Pcs;
    uint64_t Expected = 0;
    for (uint32_t Pc : Pcs)
      Expected += S.AtEnd.Executed[(Pc - S.Text.textBegin()) / 4];
    const std::vector<ReplayStop> Stops = R.all(Wanted);
    // The very first moment is where a run begins, and is not behind itself.
    const bool BeginsThere = std::ranges::count(Pcs, S.Source.Entry) != 0;
    EXPECT_EQ(Stops.size() + BeginsThere, Expected) << "seed " << Seed;
    EXPECT_TRUE(std::ranges::is_sorted(Stops, std::less(), &ReplayStop::At));
    for (size_t I = Stops.size(); I-- != 0;) {
      const ReplayStop Stop = R.Run->backward(Wanted);
      ASSERT_EQ(Stop.Kind, ReplayStop::Instruction) << "seed " << Seed;
      EXPECT_EQ(Stop.At, Stops[I].At);
      EXPECT_EQ(Stop.Thread, Stops[I].Thread);
      EXPECT_EQ(R.Run->thread(Stop.Thread).Pc, Stop.Pc);
      if (I % 8 == 0)
        EXPECT_TRUE(R.state() == S.stateAt(Stop.At.Time)) << "seed " << Seed;
    }
  }
}

TYPED_TEST(ReplayTest, WritesAreFoundForwardAndBackwardAndByWhoWrote) {
  size_t Found = 0, FoundInStreams = 0;
  for (uint64_t Seed = 1; Seed <= Programs; ++Seed) {
    TypeParam S(Seed);
    const bool IsOfStream = Seed % 2;
    const auto [Data, First] =
        S.Source.Data[S.Random.below(uint32_t(S.Source.Data.size()))];
    // The last of the data is the capacity of a stream.
    const uint32_t Address =
        IsOfStream ? S.Source.Data.back().first - 8 + 4 * S.Random.below(8)
                   : Data;
    Events Wanted;
    AccessEvents &Watched = Wanted.Accesses.emplace_back();
    Watched.Address = Address;
    Watched.Bytes = 4;
    Replayed R(S);
    const std::vector<ReplayStop> Stops = R.all(Wanted);
    if (S.traps() || Stops.size() > 200)
      continue;
    (IsOfStream ? FoundInStreams : Found) += Stops.size();
    std::vector<uint8_t> Last(4);
    std::memcpy(Last.data(), &First, 4);
    for (const ReplayStop &Stop : Stops) {
      EXPECT_TRUE(Stop.IsWrite);
      EXPECT_EQ(Stop.Old.size(), 4u);
      // Of those in one cycle each has the same bytes before it.
      if (IsOfStream || R.Run->thread(0).Timing)
        continue;
      EXPECT_EQ(Stop.Old, Last) << "seed " << Seed;
      Last = Stop.New;
    }
    for (size_t I = Stops.size(); I-- != 0;) {
      const LastWrite Writer = R.Run->lastWrite(0, Address, 4);
      ASSERT_TRUE(std::holds_alternative<WriteRecord>(Writer));
      const ReplayStop Stop = R.Run->backward(Wanted);
      ASSERT_EQ(Stop.Kind, ReplayStop::Access) << "seed " << Seed;
      EXPECT_EQ(std::get<WriteRecord>(Writer).Pc, Stop.Pc);
      EXPECT_EQ(std::get<WriteRecord>(Writer).At, Stop.At);
      EXPECT_EQ(Stop.Thread, Stops[I].Thread);
      EXPECT_EQ(Stop.Old, Stops[I].Old);
      EXPECT_EQ(Stop.New, Stops[I].New);
    }
    EXPECT_TRUE(
        std::holds_alternative<AsLoaded>(R.Run->lastWrite(0, Address, 4)));
  }
  EXPECT_GT(Found, 0u);
  EXPECT_GT(FoundInStreams, 0u);
}

TYPED_TEST(ReplayTest, AChangeIsMadeAgain) {
  for (uint64_t Seed = 1; Seed <= Programs; ++Seed) {
    TypeParam S(Seed);
    Replayed R(S);
    const uint64_t Changed = S.Random.below(uint32_t(S.End));
    R.Run->goTo({Changed, 0});
    const uint32_t Value = S.Random.word();
    uint8_t Bytes[4];
    std::memcpy(Bytes, &Value, 4);
    EXPECT_TRUE(R.Run->write(0, S.Source.Data[0].first, Bytes));
    EXPECT_FALSE(R.Run->write(0, S.Text.textBegin(), Bytes));
    R.Run->setRegister(0, 7, Value);
    EXPECT_EQ(R.Run->thread(0).Registers[7], Value);
    R.Run->goTo({Changed + S.Random.below(100), 0});
    const Moment There = R.Run->now();
    const State Expected = R.state();
    R.Run->goTo({S.Random.below(uint32_t(Changed) + 1), 0});
    R.Run->goTo(There);
    EXPECT_TRUE(R.state() == Expected) << "seed " << Seed;
    if (Changed == 0)
      continue;
    R.Run->goTo({Changed - 1, 0});
    EXPECT_TRUE(R.state() == S.stateAt(Changed - 1)) << "seed " << Seed;
  }
}

TEST(FunctionalReplay, EveryMomentIsOneInstruction) {
  FunctionalSubject S(2);
  Replayed R(S);
  Events Every;
  Every.Instructions.emplace_back();
  uint64_t Time = 0;
  for (const ReplayStop &Stop : R.all(Every))
    EXPECT_EQ(Stop.At.Time, ++Time);
  EXPECT_EQ(Time + 1, S.End + S.traps());
}
