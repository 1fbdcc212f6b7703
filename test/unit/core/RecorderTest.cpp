//===- RecorderTest.cpp - The tree of calls -------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/core/BufferArchive.h"
#include "test/unit/core/Simulation.h"

#include "gtest/gtest.h"

using namespace tp;
using namespace tp::test;

namespace {

constexpr int Link = LinkRegister;

/// A node of the tree as tests state it.
struct Expected {
  uint32_t Entry;
  std::optional<uint32_t> Caller;
  uint64_t Calls;
  uint64_t Instructions;
};

} // namespace

static void expectTree(const ExecutionRecord &Record,
                       std::initializer_list<Expected> Tree) {
  ASSERT_EQ(Record.Calls.size(), Tree.size());
  for (size_t I = 0; I != Tree.size(); ++I) {
    const CalledFunction &Called = Record.Calls[I];
    const Expected &Wanted = Tree.begin()[I];
    EXPECT_EQ(Called.Entry, Wanted.Entry) << I;
    EXPECT_EQ(Called.Caller, Wanted.Caller) << I;
    EXPECT_EQ(Called.Calls, Wanted.Calls) << I;
    EXPECT_EQ(Called.Instructions, Wanted.Instructions) << I;
  }
}

/// Nodes and instructions have the same counts in sum, but for what halted
/// threads wait.
static void expectSums(const Simulation &S) {
  uint64_t Instructions = 0;
  LossCounts Lost{};
  for (const CalledFunction &Called : S.recorded().Calls) {
    Instructions += Called.Instructions;
    for (unsigned Reason = 0; Reason != NumLosses; ++Reason)
      Lost[Reason] += Called.Lost[Reason];
  }
  uint64_t Issued = 0;
  for (const ThreadStatistics &Thread : S.statistics().Threads)
    Issued += Thread.Instructions;
  EXPECT_EQ(Instructions, Issued);
  LossCounts AtPcs{};
  for (const PcStatistics &Pc : S.statistics().Pcs)
    for (unsigned Reason = 0; Reason != NumLosses; ++Reason)
      AtPcs[Reason] += Pc.Lost[Reason];
  EXPECT_EQ(Lost, AtPcs);
}

TEST(Recorder, CountsByChainOfCalls) {
  // 0..3: calls twice the first, then the second, which calls the first.
  Assembly A;
  A("jal", "first")("jal", "first")("jal", "second")("halt", 0);
  A.label("first")("addi", 5, 0, 1)("addi", 6, 0, 1)("jr", Link);
  A.label("second")("or", 20, Link, 0)("jal", "first")("jr", 20);
  Simulation S(quietChip(1, 2), A);
  S.record();
  S.cycles();
  expectTree(S.recorded(), {{0, std::nullopt, 2, 8},
                            {4, 0u, 2, 6},
                            {4, 0u, 2, 6},
                            {7, 0u, 2, 6},
                            {4, 3u, 2, 6}});
  EXPECT_EQ(S.recorded().Calls[1].CallSite, 0u);
  EXPECT_EQ(S.recorded().Calls[2].CallSite, 1u);
  EXPECT_EQ(S.recorded().Calls[4].CallSite, 8u);
  expectSums(S);
}

TEST(Recorder, LossesAreOfTheFunctionThatLostThem) {
  // Branches take 3 cycles: two are lost behind each. The callee waits 19
  // cycles for its load, the caller sleeps 7.
  Assembly A;
  A("addi", 6, 0, 7)("sleep", 6)("jal", "load")("halt", 0);
  A.label("load")("lui", 20, DataBegin >> 16)("lw", 5, 20, 0)("addi", 5, 5,
                                                              1)("jr", Link);
  ChipConfig Chip = quietChip(1, 1);
  Chip.Latency[unsigned(LatencyClass::Branch)] = 3;
  Simulation S(Chip, A);
  S.record();
  S.cycles();
  ExecutionRecord Record = S.recorded();
  expectTree(Record, {{0, std::nullopt, 1, 4}, {4, 0u, 1, 4}});
  auto Lost = [&](unsigned Node, Loss Reason) {
    return Record.Calls[Node].Lost[unsigned(Reason)];
  };
  EXPECT_EQ(Lost(0, Loss::Sleep), 7u);
  EXPECT_EQ(Lost(0, Loss::Branch), 2u);
  EXPECT_EQ(Lost(0, Loss::Memory), 0u);
  EXPECT_EQ(Lost(1, Loss::Memory), 19u);
  EXPECT_EQ(Lost(1, Loss::Branch), 2u);
  expectSums(S);
}

TEST(Recorder, ABranchThatTheEndCutsIsTheCallers) {
  // jal in 0, its target would come in 3.
  Assembly A;
  A("jal", "called")("halt", 0);
  A.label("called")("jr", Link);
  ChipConfig Chip = quietChip(1, 1);
  Chip.Latency[unsigned(LatencyClass::Branch)] = 3;
  for (uint64_t Cycles : {1, 2, 3, 4, 5}) {
    Simulation S(Chip, A);
    S.record();
    S.run(Cycles);
    EXPECT_EQ(S.recorded().Calls[0].Lost[unsigned(Loss::Branch)],
              std::min<uint64_t>(Cycles - 1, 2));
    expectSums(S);
  }
}

TEST(Recorder, RecursionIsOneNode) {
  // r4 = 3: the function calls itself twice in a row, with r4 one less.
  Assembly A;
  A("addi", 29, 0, -64)("addi", 4, 0, 3)("jal", "again")("halt", 0);
  A.label("again")("addi", 29, 29, -4)("sw", Link, 29, 0)("addi", 4, 4, -1)(
      "beq", 4, 0, "done")("jal", "again");
  A.label("done")("lw", Link, 29, 0)("addi", 29, 29, 4)("jr", Link);
  Simulation S(quietChip(1, 1), A);
  S.record();
  S.cycles();
  expectTree(S.recorded(), {{0, std::nullopt, 1, 4}, {4, 0u, 3, 23}});
  expectSums(S);
}

TEST(Recorder, AJumpToAFunctionIsACallThatReturnsForItsCaller) {
  // first goes on in second, which returns to 1.
  Assembly A;
  A("jal", "first")("jal", "second")("halt", 0);
  A.label("first")("addi", 5, 0, 1)("j", "second");
  A.label("second")("addi", 5, 0, 2)("jr", Link);
  Simulation S(quietChip(1, 1), A);
  S.record();
  S.cycles();
  expectTree(
      S.recorded(),
      {{0, std::nullopt, 1, 3}, {3, 0u, 1, 2}, {5, 1u, 1, 2}, {5, 0u, 1, 2}});
  expectSums(S);
}

TEST(Recorder, IndirectCallsAndJumps) {
  // A call by register, and a switch within the function that is called.
  Assembly A;
  A("lui", 20, TextBegin >> 16)("addi", 20, 20, 16)("jalr", 20)("jal",
                                                                "called");
  A.label("called")("addi", 20, 20, 12)("jr", 20)("halt", 1)("halt", 0);
  Simulation S(quietChip(1, 1), A);
  S.record();
  S.cycles();
  expectTree(S.recorded(), {{0, std::nullopt, 1, 3}, {4, 0u, 1, 3}});
  EXPECT_EQ(S.recorded().Calls[1].CallSite, 2u);
  expectSums(S);
}

TEST(Recorder, AReturnFromWhereNoCallWasSeenIsANewRoot) {
  Assembly A;
  A("lui", Link, TextBegin >> 16)("addi", Link, Link, 16)("jr", Link)("jal",
                                                                      "behind");
  A.label("behind")("halt", 0);
  Simulation S(quietChip(1, 1), A);
  S.record();
  S.cycles();
  expectTree(S.recorded(), {{0, std::nullopt, 1, 3}, {4, std::nullopt, 1, 1}});
  expectSums(S);
}

TEST(Recorder, HostThreadsChangeNothing) {
  // Threads go different ways.
  Assembly A;
  A("mfsr", 4, 0)("andi", 4, 4, 1)("beq", 4, 0, "even")("jal", "first");
  A.label("even")("jal", "second")("halt", 0);
  A.label("first")("jr", Link);
  A.label("second")("or", 20, Link, 0)("jal", "first")("jr", 20);
  auto Run = [&](unsigned HostThreads) {
    Simulation S(quietChip(8, 4), A, HostThreads);
    S.record();
    S.cycles();
    expectSums(S);
    return S.recorded();
  };
  ExecutionRecord One = Run(1), Three = Run(3);
  ASSERT_EQ(One.Calls.size(), 4u);
  ASSERT_EQ(Three.Calls.size(), 4u);
  for (size_t I = 0; I != 4; ++I) {
    EXPECT_EQ(One.Calls[I].Entry, Three.Calls[I].Entry);
    EXPECT_EQ(One.Calls[I].Caller, Three.Calls[I].Caller);
    EXPECT_EQ(One.Calls[I].Instructions, Three.Calls[I].Instructions);
    EXPECT_EQ(One.Calls[I].Lost, Three.Calls[I].Lost);
  }
}

TEST(Recorder, GlobalAccessesOfFixedLatency) {
  // A load and a store go to global memory; a load and a store do not.
  Assembly A;
  A("lui", 20, DataBegin >> 16)("lw", 5, 20, 0)("sw", 5, 20, 4)(
      "lw", 6, 0, -64)("sw", 6, 0, -60)("halt", 0);
  Simulation S(quietChip(1, 2), A);
  S.record();
  S.cycles();
  ExecutionRecord Record = S.recorded();
  auto Memory = unsigned(ServedBy::Memory);
  EXPECT_EQ(Record.Pcs[1].Global, 2u);
  EXPECT_EQ(Record.Pcs[1].Served[Memory], (ServedAccesses{2, 40}));
  EXPECT_EQ(Record.Pcs[2].Global, 2u);
  EXPECT_EQ(Record.Pcs[2].Served[Memory], ServedAccesses());
  EXPECT_EQ(Record.Pcs[3].Global, 0u);
  EXPECT_EQ(Record.Pcs[4].Global, 0u);
  EXPECT_EQ(S.statistics().GlobalAccesses, 4u);
}

TEST(Recorder, RestoringKeepsThePartsOfHostThreads) {
  const ChipConfig Chip = quietChip(2, 1);
  Assembly A;
  A("halt", 0);
  const Program Text(TextBegin, A.words(), TextBegin);
  const AnsweredRequest Answer{0, 0, 10, 30, ServedBy::L2};
  SavingArchive Saved;
  ExecutionRecorder Before(Chip, Text, {0});
  Before.addPart().served(Answer);
  Before.addPart().served(Answer);
  Before.serialize(Saved);

  ExecutionRecorder After(Chip, Text, {0});
  RecorderPart &First = After.addPart();
  RecorderPart &Second = After.addPart();
  First.served(Answer);
  RestoringArchive Restored(Saved.collected());
  After.serialize(Restored);
  EXPECT_TRUE(Restored.isComplete());
  First.served(Answer);
  Second.served(Answer);
  Statistics Now;
  Now.Pcs.resize(1);
  const ServedAccesses Sum =
      After.record(Now).Pcs[0].Served[unsigned(ServedBy::L2)];
  EXPECT_EQ(Sum.Accesses, 4u);
  EXPECT_EQ(Sum.Cycles, 80u);
}

TEST(CallTree, IsBounded) {
  CallTree Tree;
  constexpr uint32_t Many = 100000;
  for (uint32_t Function = 0; Function != Many; ++Function)
    Tree.numberOf({CallTree::NoNode, 0, Function});
  EXPECT_TRUE(Tree.isCut());
  EXPECT_LT(Tree.size(), Many);
  const uint32_t Last = Tree.numberOf({CallTree::NoNode, 0, Many - 1});
  EXPECT_LT(Last, Tree.size());
}
