//===- JitTestMain.cpp - Runs tests of the engine on generated code -------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/jit/Jit.h"
#include "test/unit/core/Simulation.h"

#include "gtest/gtest.h"

static std::unique_ptr<tp::CodeGenerator> compileEverything() {
  tp::JitOptions Options;
  Options.WindowsBetweenLooks = 1;
  Options.EverythingAtOnce = true;
  return llvm::cantFail(tp::makeJit(Options));
}

int main(int Argc, char **Argv) {
  testing::InitGoogleTest(&Argc, Argv);
  tp::test::Simulation::DefaultGenerator = compileEverything;
  return RUN_ALL_TESTS();
}
