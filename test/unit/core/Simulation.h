//===- Simulation.h - A small chip that runs a test program -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_TEST_UNIT_CORE_SIMULATION_H
#define TP_TEST_UNIT_CORE_SIMULATION_H

#include "simulator/core/Engine.h"
#include "simulator/core/ExecutionRecorder.h"
#include "test/unit/core/Assembly.h"

#include <memory>
#include <string>

namespace tp {
class CodeGenerator;
} // namespace tp

namespace tp::test {

/// Free global memory for the programs' data.
inline constexpr uint32_t DataBegin = 0x80000;
inline constexpr uint32_t LocalStoreBytes = 1024;
inline constexpr uint32_t LocalBegin = 0 - LocalStoreBytes;

/// A chip on which nothing ever conflicts: units and icache ports for all TPs.
/// Windows of 16 cycles, memory latency 20, the latencies of the .td.
ChipConfig quietChip(uint32_t TmCount, uint32_t TpsPerTm);

/// One run of one program.
class Simulation {
public:
  /// Makes the code generator of the simulations to come; null at first: they
  /// run on the reference engine.
  static std::unique_ptr<CodeGenerator> (*DefaultGenerator)();

  Simulation(const ChipConfig &Chip, const Assembly &Source,
             unsigned HostThreads = 1,
             std::unique_ptr<MemorySystem> Hierarchy = nullptr);

  /// Before the run.
  void setObserver(ProfileObserver &Observer) {
    Simulated.setObserver(&Observer);
  }
  /// Before the run.
  void record();
  /// What was recorded up to the end of the last run.
  ExecutionRecord recorded() const { return Recorder->record(Counts); }
  void setHostThreads(unsigned Count) { Simulated.setHostThreads(Count); }
  RunResult run(uint64_t MaxCycles = 1000000);
  /// Runs, expects that all threads halt, and gives the cycles.
  uint64_t cycles();

  RunResult run(const RunLimits &Limits);

  /// At the end of the last run.
  const Statistics &statistics() const { return Counts; }
  uint64_t lost(uint32_t Thread, Loss Reason) const {
    return statistics().Threads[Thread].Lost[unsigned(Reason)];
  }
  uint32_t registerOf(uint32_t Thread, unsigned Register) const {
    return Simulated.registerOf(Thread, Register);
  }
  uint32_t word(uint32_t Address) const;
  void setWord(uint32_t Address, uint32_t Value);
  const std::string &output() const { return Output; }
  Memory &memory() { return Global; }

private:
  /// The issues and losses of each thread are the cycles of the chip, and the
  /// sums by opcode are those by thread.
  void expectConsistentStatistics() const;

  ChipConfig Chip;
  Memory Global;
  Program Text;
  std::unique_ptr<ExecutionRecorder> Recorder;
  Engine Simulated;
  /// Who compiles from the first run on.
  std::unique_ptr<CodeGenerator> (*NewGenerator)() = DefaultGenerator;
  std::string Output;
  Statistics Counts;
};

} // namespace tp::test

#endif // TP_TEST_UNIT_CORE_SIMULATION_H
