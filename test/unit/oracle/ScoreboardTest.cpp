//===- ScoreboardTest.cpp - The engine against the naive model ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/oracle/Campaign.h"

#include "gtest/gtest.h"

using namespace tp;
using namespace tp::test;

namespace {

RunResult runAtOnce(Engine &Simulated, uint64_t MaxCycles) {
  RunLimits Limits;
  Limits.MaxCycles = MaxCycles;
  return Simulated.run(Limits);
}

/// With pauses at random cycles, and other numbers of host threads behind them.
RunResult runInParts(Engine &Simulated, uint64_t MaxCycles) {
  RandomSource Random(MaxCycles);
  RunLimits Limits;
  Limits.MaxCycles = MaxCycles;
  for (;;) {
    Limits.PauseCycle += Random.between(1, 300);
    Simulated.setHostThreads(Random.between(1, 3));
    RunResult Result = Simulated.run(Limits);
    if (Result.End != RunResult::Paused)
      return Result;
  }
}

TEST(Scoreboard, StraightLinePrograms) {
  checkPrograms(ProgramShape::StraightLine, randomChip, 10000, runAtOnce);
}

TEST(Scoreboard, ProgramsWithBranchesAndLoops) {
  checkPrograms(ProgramShape::Branching, randomChip, 3000, runAtOnce);
}

TEST(Scoreboard, StraightLineProgramsWithMemorySystem) {
  checkPrograms(ProgramShape::StraightLine, randomMemoryChip, 3000, runAtOnce);
}

TEST(Scoreboard, BranchesAndLoopsWithMemorySystem) {
  checkPrograms(ProgramShape::Branching, randomMemoryChip, 1000, runAtOnce);
}

TEST(Scoreboard, RunsInParts) {
  checkPrograms(ProgramShape::Branching, randomChip, 150, runInParts);
  checkPrograms(ProgramShape::Branching, randomMemoryChip, 150, runInParts);
}

} // namespace
