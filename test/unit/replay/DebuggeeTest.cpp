//===- DebuggeeTest.cpp - Small programs under a replay -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "runtime/include/tp/host_call.h"
#include "simulator/replay/Replay.h"
#include "test/unit/core/Simulation.h"

#include "gtest/gtest.h"

#include <array>
#include <atomic>
#include <memory>
#include <string>
#include <utility>

using namespace tp;
using namespace tp::test;

namespace {

constexpr uint32_t Local = LocalBegin + 64;
constexpr unsigned DataBase = 20, LocalBase = 21;

/// A program of the threads of one TM, with timing or without.
class Debuggee {
public:
  Debuggee(const ChipConfig &Chip, const Assembly &Source, bool HasTiming)
      : Chip(Chip), Text(TextBegin, Source.words(), TextBegin),
        Global(Chip.MemoryBytes) {
    std::string Error;
    ReplayOptions Request;
    Request.CheckpointCycles = 20;
    Request.Output = [this](int, std::string_view Bytes) { Output += Bytes; };
    auto Make = HasTiming ? makeCycleReplay : makeFunctionalReplay;
    Run = Make(this->Chip, Text, Global, std::move(Request), Error);
    EXPECT_EQ(Error, "");
  }

  Replay *operator->() { return Run.get(); }
  /// The instruction that wrote last; 0 if none did.
  uint32_t writer(uint32_t Address, uint32_t Bytes, uint32_t Thread = 0) {
    const LastWrite Last = Run->lastWrite(Thread, Address, Bytes);
    const auto *Record = std::get_if<WriteRecord>(&Last);
    return Record ? Record->Pc : 0;
  }

  std::string Output;

private:
  const ChipConfig Chip;
  const Program Text;
  Memory Global;
  std::unique_ptr<Replay> Run;
};

class DebuggeeTest : public testing::TestWithParam<bool> {};

} // namespace

INSTANTIATE_TEST_SUITE_P(Modes, DebuggeeTest, testing::Bool(),
                         [](const testing::TestParamInfo<bool> &HasTiming) {
                           return HasTiming.param ? "cycles" : "functional";
                         });

static Assembly bases() {
  Assembly A;
  A.constant(DataBase, DataBegin).constant(LocalBase, Local);
  return A("addi", 4, 0, 7);
}

TEST_P(DebuggeeTest, ByteOfAWordPartlyOverwritten) {
  for (unsigned Base : {DataBase, LocalBase}) {
    const uint32_t Address = Base == DataBase ? DataBegin : Local;
    Assembly A = bases();
    const uint32_t WordStore = A.nextAddress();
    A("sw", 4, Base, 0);
    const uint32_t ByteStore = A.nextAddress();
    A("sb", 4, Base, 1)("halt", 0);
    Debuggee Subject(quietChip(1, 1), A, GetParam());
    EXPECT_EQ(Subject.writer(Address, 4), 0u);
    EXPECT_EQ(Subject->forward({}).Kind, ReplayStop::Halted);
    EXPECT_EQ(Subject.writer(Address, 1), WordStore);
    EXPECT_EQ(Subject.writer(Address + 1, 1), ByteStore);
    EXPECT_EQ(Subject.writer(Address, 4), ByteStore);
    EXPECT_EQ(Subject.writer(Address + 2, 8), WordStore);
    EXPECT_EQ(Subject.writer(Address + 4, 4), 0u);
  }
}

TEST_P(DebuggeeTest, TheUserToo) {
  for (unsigned Base : {DataBase, LocalBase}) {
    const uint32_t Address = Base == DataBase ? DataBegin : Local;
    Assembly A = bases();
    const uint32_t First = A.nextAddress();
    A("sw", 4, Base, 0).repeat(100, "addi", 5, 0, 0);
    const uint32_t Second = A.nextAddress();
    A("sw", 4, Base, 0)("halt", 0);
    Debuggee Subject(quietChip(1, 2), A, GetParam());
    const Moment Changed{50, 0};
    Subject->goTo(Changed);
    EXPECT_TRUE(Subject->write(0, Address + 1, std::array<uint8_t, 1>{1}));
    const auto IsByUser = [&](uint32_t At, uint32_t Bytes) {
      const LastWrite Last = Subject->lastWrite(0, At, Bytes);
      const auto *User = std::get_if<WrittenByUser>(&Last);
      return User && User->At == Changed;
    };
    EXPECT_TRUE(IsByUser(Address, 4));
    EXPECT_TRUE(IsByUser(Address + 1, 1));
    EXPECT_EQ(Subject.writer(Address + 2, 2), First);
    if (Base == LocalBase && GetParam())
      EXPECT_EQ(Subject.writer(Address, 4, /*Thread=*/1), First);
    Subject->goTo({49, 0});
    EXPECT_EQ(Subject.writer(Address, 4), First);
    Subject->goTo({60, 0});
    EXPECT_TRUE(IsByUser(Address, 4));
    EXPECT_EQ(Subject->forward({}).Kind, ReplayStop::Halted);
    EXPECT_EQ(Subject.writer(Address, 4), Second);
    // What an earlier change makes undone is no write any more.
    Subject->goTo({40, 0});
    Subject->setRegister(0, 9, 1);
    Subject->goTo({60, 0});
    EXPECT_EQ(Subject.writer(Address, 4), First);
  }
}

TEST_P(DebuggeeTest, OfWhatIsPartlyNoMemory) {
  Assembly A = bases();
  Debuggee Subject(quietChip(1, 1), A("halt", 0), GetParam());
  Subject->forward({});
  const uint32_t End = quietChip(1, 1).MemoryBytes;
  EXPECT_EQ(Subject.writer(End - 4, 1 << 16), 0u);
  EXPECT_EQ(Subject.writer(End + (1 << 20), 4), 0u);
  EXPECT_EQ(Subject.writer(LocalBegin, 1 << 16), 0u);
}

TEST_P(DebuggeeTest, TheStopFlagEndsTheSearch) {
  Assembly A = bases();
  A("sw", 4, LocalBase, 0);
  Debuggee Subject(quietChip(1, 1), A("halt", 0), GetParam());
  const Moment End = Subject->forward({}).At;
  const std::atomic<bool> Stop = true;
  Subject->setStopFlag(&Stop);
  EXPECT_TRUE(std::holds_alternative<SearchInterrupted>(
      Subject->lastWrite(0, Local, 4)));
  EXPECT_EQ(Subject->now(), End);
}

/// Two threads store to a word each in the same cycle; the later of them in
/// the order of the cycle to the word behind.
static Assembly storesOfTwoThreads() {
  Assembly A = bases();
  A("mfsr", 5, int(SpecialRegister::thread))("sll", 5, 5, 2)("add", 5, 5,
                                                             DataBase);
  A("sw", 4, 5, 0)("halt", 0);
  return A;
}

TEST_P(DebuggeeTest, InOneCycleByTheOrderOfTheThreads) {
  Debuggee Subject(quietChip(1, 2), storesOfTwoThreads(), GetParam());
  EXPECT_EQ(Subject->forward({}).Kind, ReplayStop::Halted);
  const LastWrite Last = Subject->lastWrite(0, DataBegin, 8);
  ASSERT_TRUE(std::holds_alternative<WriteRecord>(Last));
  EXPECT_EQ(std::get<WriteRecord>(Last).Thread, 1u);
}

TEST_P(DebuggeeTest, AVisitPassesOverNoEvent) {
  Debuggee Subject(quietChip(1, 2), storesOfTwoThreads(), GetParam());
  Events Wanted;
  AccessEvents &Watched = Wanted.Accesses.emplace_back();
  Watched.Address = DataBegin;
  Watched.Bytes = 8;
  for (uint32_t Thread = 0; Thread != 2; ++Thread) {
    const ReplayStop Stop = Subject->forward(Wanted);
    ASSERT_EQ(Stop.Kind, ReplayStop::Access);
    EXPECT_EQ(Stop.Thread, Thread);
    const Moment Here = Subject->now();
    Subject->visit({}, [&] { EXPECT_EQ(Subject->now(), Moment()); });
    EXPECT_EQ(Subject->now(), Here);
  }
  EXPECT_EQ(Subject->forward(Wanted).Kind, ReplayStop::Halted);
}

TEST_P(DebuggeeTest, OutputIsShownOnceButAgainBehindAChange) {
  Assembly A = bases();
  constexpr unsigned Letter = 8;
  A("addi", 4, 0, 1)("add", 5, 0, DataBase)("addi", 6, 0, 1);
  A("addi", Letter, 0, 'a')("addi", 9, 0, 'z' + 1);
  A.label("next")("sb", Letter, 5, 0)("sync")("hostcall", kHostCallWrite);
  A("addi", Letter, Letter, 1)("bne", Letter, 9, "next")("halt", 0);
  Debuggee Subject(quietChip(1, 1), A, GetParam());
  const std::string Once = "abcdefghijklmnopqrstuvwxyz";
  const Moment End = Subject->forward({}).At;
  EXPECT_EQ(Subject.Output, Once);
  Subject->backward({});
  EXPECT_EQ(Subject->now(), Moment());
  const Moment Middle{End.Time / 2, 0};
  Subject->goTo(Middle);
  Subject->forward({});
  EXPECT_EQ(Subject.Output, Once);
  Subject->goTo(Middle);
  const auto Current = Subject->thread(0).Registers[Letter];
  Subject->setRegister(0, Letter, Current);
  Subject->forward({});
  EXPECT_GE(Subject.Output.size(), Once.size() + ('z' - Current));
  EXPECT_LT(Subject.Output.size(), 2 * Once.size());
  EXPECT_TRUE(Subject.Output.ends_with("xyz"));
}

TEST(CycleReplay, AWriteOfTheSameCycleIsNotYetInMemory) {
  // Thread 0 stores when thread 1, which comes behind it, is at an instruction.
  Assembly A = bases();
  const uint32_t First = A.nextAddress();
  A("sw", 4, LocalBase, 0)("addi", 5, 0, 1);
  const uint32_t Second = A.nextAddress();
  A("sw", 4, LocalBase, 0)("halt", 0);
  Debuggee Subject(quietChip(1, 2), A, /*HasTiming=*/true);
  Events AtSecond;
  AtSecond.Instructions.push_back({{Second}, 1, nullptr});
  ASSERT_EQ(Subject->forward(AtSecond).Thread, 1u);
  ASSERT_NE(Subject->now().Order, 0u);
  EXPECT_EQ(Subject.writer(Local, 4, /*Thread=*/0), First);
}

TEST(CycleReplay, AThreadWaitsForTheSourceThatIsReadyLast) {
  Assembly A = bases();
  A("lw", 4, DataBase, 0)("div", 5, DataBase, DataBase);
  const uint32_t Sum = A.nextAddress();
  A("add", 6, 4, 5)("halt", 0);
  Debuggee Subject(quietChip(1, 1), A, /*HasTiming=*/true);
  while (Subject->thread(0).Pc != Sum)
    Subject->goTo({Subject->now().Time + 1, 0});
  const ReplayThread Thread = Subject->thread(0);
  ASSERT_TRUE(Thread.Timing);
  EXPECT_EQ(Thread.Timing->UnderWay.size(), 2u);
  EXPECT_EQ(Thread.Timing->Reason, Loss::Memory);
  EXPECT_EQ(Thread.Timing->Producer, Opcode::LW);
}

TEST(CycleReplay, AStoreThatWaitsForRoomStopsOnce) {
  ChipConfig Chip = quietChip(1, 2);
  Chip.L1.emplace().Bytes = 1024;
  Chip.StoreBufferEntries = 1;
  Assembly A = bases();
  constexpr unsigned Stores = 20;
  const uint32_t Begin = A.nextAddress();
  A.repeat(Stores, "sw", 4, DataBase, 0)("halt", 0);
  Debuggee Subject(Chip, A, /*HasTiming=*/true);
  Events Wanted;
  InstructionEvents &Each = Wanted.Instructions.emplace_back();
  for (unsigned I = 0; I != Stores; ++I)
    Each.Pcs.push_back(Begin + 4 * I);
  for (unsigned I = 0; I != 2 * Stores; ++I)
    ASSERT_EQ(Subject->forward(Wanted).Kind, ReplayStop::Instruction) << I;
  EXPECT_EQ(Subject->forward(Wanted).Kind, ReplayStop::Halted);
  for (unsigned I = 0; I != 2 * Stores; ++I)
    ASSERT_EQ(Subject->backward(Wanted).Kind, ReplayStop::Instruction) << I;
  EXPECT_EQ(Subject->backward(Wanted).Kind, ReplayStop::Beginning);
}

TEST(CycleReplay, AWriteInTheCycleOfAnothersTrapIsFound) {
  Assembly A = bases();
  A("mfsr", 5, int(SpecialRegister::thread))("bne", 5, 0, "second");
  A("sw", 4, DataBase, 0)("halt", 0);
  A.label("second")("break", 0);
  Debuggee Subject(quietChip(1, 2), A, /*HasTiming=*/true);
  Events Wanted;
  AccessEvents &Watched = Wanted.Accesses.emplace_back();
  Watched.Address = DataBegin;
  Watched.Bytes = 4;
  const ReplayStop Stop = Subject->forward(Wanted);
  ASSERT_EQ(Stop.Kind, ReplayStop::Access);
  EXPECT_TRUE(Stop.New.empty());
  const ReplayStop End = Subject->forward(Wanted);
  ASSERT_EQ(End.Kind, ReplayStop::Trapped);
  ASSERT_EQ(End.At.Time, Stop.At.Time);
  EXPECT_EQ(Subject->backward(Wanted).Kind, ReplayStop::Access);
}
