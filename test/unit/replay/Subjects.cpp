//===- Subjects.cpp - Random programs to go back and forth in -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/replay/Subjects.h"

#include "gtest/gtest.h"

#include <numeric>
#include <utility>

namespace tp::test {

//===----------------------------------------------------------------------===//
// With timing
//===----------------------------------------------------------------------===//

static State run(const CycleSubject &S, uint64_t Cycles, RunResult &Result,
                 uint64_t &End) {
  Memory Global(S.Chip.MemoryBytes);
  S.Source.initialize(Global);
  Engine Machine(S.Chip, S.Text, Global, makeMemorySystem(S.Chip));
  RunLimits Limits;
  Limits.MaxCycles = Cycles;
  if (Cycles != 0)
    Result = Machine.run(Limits);
  End = Result.End == RunResult::Trapped ? Result.TrapInfo->Cycle
                                         : Machine.cycles();
  return stateOf(Machine, S.Chip, S.Text, Global);
}

CycleSubject::CycleSubject(uint64_t Seed)
    : Subject(Seed, Seed % 2 ? randomMemoryChip : randomChip, 3000) {
  AtEnd = run(*this, Most, Result, End);
}

State CycleSubject::stateAt(uint64_t Time) const {
  RunResult Ignored;
  uint64_t IgnoredEnd;
  return run(*this, Time, Ignored, IgnoredEnd);
}

std::unique_ptr<Replay> CycleSubject::makeReplay(Memory &Global,
                                                 ReplayOptions Request,
                                                 std::string &Error) const {
  return makeCycleReplay(Chip, Text, Global, std::move(Request), Error);
}

//===----------------------------------------------------------------------===//
// Without timing
//===----------------------------------------------------------------------===//

static State run(const FunctionalSubject &S, uint64_t Before,
                 RunResult &Result) {
  Memory Global(S.Chip.MemoryBytes);
  S.Source.initialize(Global);
  FunctionalMachine Machine(S.Chip, S.Text, Global);
  FunctionalLimits Limits;
  Limits.PauseBefore = Before;
  Result = Machine.run(Limits);
  return stateOf(Machine, S.Chip, Global);
}

/// So many that turns end by themselves.
static constexpr uint64_t MostInstructions = 100000;

FunctionalSubject::FunctionalSubject(uint64_t Seed)
    : Subject(Seed, randomChip, MostInstructions) {
  AtEnd = run(*this, Most, Result);
  End = std::reduce(AtEnd.Issued.begin(), AtEnd.Issued.end());
}

State FunctionalSubject::stateAt(uint64_t Time) const {
  RunResult Ignored;
  return run(*this, Time, Ignored);
}

std::unique_ptr<Replay>
FunctionalSubject::makeReplay(Memory &Global, ReplayOptions Request,
                              std::string &Error) const {
  return makeFunctionalReplay(Chip, Text, Global, std::move(Request), Error);
}

//===----------------------------------------------------------------------===//
// Replays
//===----------------------------------------------------------------------===//

Replayed::Replayed(Subject &S) : S(S), Global(S.Chip.MemoryBytes) {
  S.Source.initialize(Global);
  ReplayOptions Request;
  Request.MaxCycles = S.Most;
  Request.CheckpointCycles = S.Random.between(1, uint32_t(S.Most / 15));
  Request.HostThreads = S.Random.between(1, 2);
  // Some runs must do with few.
  if (S.Random.oneIn(3))
    Request.CheckpointBytes = S.Random.between(1, 4) << 16;
  Request.Output = [this](int, std::string_view Bytes) { Output += Bytes; };
  std::string Error;
  Run = S.makeReplay(Global, std::move(Request), Error);
  EXPECT_EQ(Error, "");
}

std::vector<ReplayStop> Replayed::all(const Events &Wanted) {
  std::vector<ReplayStop> Stops;
  Run->goTo({});
  while (true) {
    ReplayStop Stop = Run->forward(Wanted);
    EXPECT_NE(Stop.Kind, ReplayStop::Interrupted);
    if (Stop.Kind != ReplayStop::Instruction && Stop.Kind != ReplayStop::Access)
      return Stops;
    Stops.push_back(std::move(Stop));
  }
}

} // namespace tp::test
