//===- GeneratedCodeTest.cpp - Generated code against the naive model -----===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/jit/Jit.h"
#include "test/unit/oracle/Campaign.h"

#include "gtest/gtest.h"

using namespace tp;
using namespace tp::test;

namespace {

/// With all code generated before the first cycle.
RunResult runGenerated(Engine &Simulated, uint64_t MaxCycles) {
  JitOptions Options;
  Options.EverythingAtOnce = true;
  Simulated.setCodeGenerator(llvm::cantFail(makeJit(Options)));
  RunLimits Limits;
  Limits.MaxCycles = MaxCycles;
  return Simulated.run(Limits);
}

TEST(GeneratedCode, StraightLinePrograms) {
  checkPrograms(ProgramShape::StraightLine, randomChip, 30, runGenerated);
}

TEST(GeneratedCode, ProgramsWithBranchesAndLoops) {
  checkPrograms(ProgramShape::Branching, randomChip, 30, runGenerated);
}

TEST(GeneratedCode, ProgramsWithMemorySystem) {
  checkPrograms(ProgramShape::Branching, randomMemoryChip, 15, runGenerated);
}

} // namespace
