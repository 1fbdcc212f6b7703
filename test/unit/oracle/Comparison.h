//===- Comparison.h - A program on an engine and in the model ---*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_TEST_UNIT_ORACLE_COMPARISON_H
#define TP_TEST_UNIT_ORACLE_COMPARISON_H

#include "simulator/core/Engine.h"
#include "test/unit/oracle/RandomProgram.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace tp::test {

/// All that a run leaves behind.
struct RunRecord {
  RunResult Result;
  Statistics Counts;
  /// Of each thread.
  std::vector<std::array<uint32_t, 64>> Registers;
  std::vector<std::vector<std::pair<uint32_t, uint32_t>>> ProfileValues;
  std::vector<uint8_t> Memory;
  std::string Output;
};

/// How to run an engine for at most so many cycles.
using EngineRun = std::function<RunResult(Engine &, uint64_t MaxCycles)>;

RunRecord runModel(const ChipConfig &Chip, const RandomProgram &Source,
                   uint64_t MaxCycles);
RunRecord runEngine(const ChipConfig &Chip, const RandomProgram &Source,
                    uint64_t MaxCycles, const EngineRun &Run);

/// What differs, one a line: "thread 1 register 7: model 3, engine 4".
std::string differences(const RunRecord &Model, const RunRecord &Simulated);

} // namespace tp::test

#endif // TP_TEST_UNIT_ORACLE_COMPARISON_H
