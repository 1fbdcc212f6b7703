//===- FunctionalMachine.h - A chip without its timing ----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// docs/long-runs.md says what the functional mode promises.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_FUNCTIONAL_FUNCTIONALMACHINE_H
#define TP_SIMULATOR_FUNCTIONAL_FUNCTIONALMACHINE_H

#include "simulator/core/ArchitecturalState.h"
#include "simulator/core/Engine.h"
#include "simulator/functional/FunctionalThread.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tp {

class ExecutionChecks;
class FunctionalCodeGenerator;
class InstructionObserver;

/// How long to run. What is not set limits nothing.
struct FunctionalLimits {
  /// Each thread stops behind this profile marker; the run pauses when no
  /// thread can go on.
  std::optional<uint32_t> StopMarker;
  /// Pauses before the first instruction that takes time once all threads
  /// together have executed so many.
  std::optional<uint64_t> PauseBefore;
  /// Stops between two turns when this has become true.
  const std::atomic<bool> *Stop = nullptr;
  /// Called about ten times a second.
  ProgressFunction Report;
};

/// Executes a program on a chip without timing: threads in turn for a quantum
/// of instructions each, on one thread of the host. What it does depends on
/// nothing but chip, program and memory contents.
class FunctionalMachine {
public:
  /// Program and memory must outlive the machine.
  FunctionalMachine(const ChipConfig &Chip, const Program &Text,
                    Memory &Global);
  ~FunctionalMachine();

  /// Why this chip cannot be simulated; empty if it can. Check it before run().
  const std::string &error() const { return Error; }

  /// As for Engine.
  void setObserver(ProfileObserver *Observer);
  void setOutput(OutputFunction Function);
  /// Generates code for what is hot, which changes no result: without one all
  /// is interpreted. Before the first run().
  void setCodeGenerator(std::unique_ptr<FunctionalCodeGenerator> Generator);

  /// Makes \p Checks, which must outlive the machine, at each instruction.
  /// Before the first run(), and instead of a code generator or an observer of
  /// steps.
  void setChecks(ExecutionChecks &Checks);

  /// \p Function sees each instruction of a thread. Before the first run(), and
  /// instead of a code generator.
  void setStepObserver(uint32_t Thread, StepObserver Function);

  /// Runs until all threads have halted, one trapped, or a limit is reached
  /// (Paused: the marker, a number of instructions, or the observer). A trap's
  /// cycle is the number of instructions that the thread had issued.
  RunResult run(const FunctionalLimits &Limits = {});

  /// Instructions by opcode, by word of the text and by thread, and markers: no
  /// cycles and no losses.
  Statistics statistics() const;

  /// Shows instructions of these words of the text to \p Observer, which must
  /// outlive the runs, until it is called again; null: none. Instead of a code
  /// generator or an observer of steps.
  void setInstructionObserver(InstructionObserver *Observer,
                              const std::vector<bool> &Words);
  /// Instructions that all threads have executed.
  uint64_t executed() const;

  /// The state between two runs, but global memory. What is restored has not
  /// trapped.
  void serialize(Archive &A);

  /// A thread between two runs; its TurnEnd are the instructions that it has
  /// issued.
  const FunctionalThread &thread(uint32_t Number) const;
  void setRegister(uint32_t Number, unsigned Register, uint32_t Value);
  void setNextWord(uint32_t Number, uint32_t Word);

  /// As for Engine.
  uint32_t registerOf(uint32_t Thread, unsigned Register) const;
  /// The threads as they are between two runs, by their number. Valid as long
  /// as the machine.
  std::vector<ArchitecturalState> threads() const;

private:
  class Implementation;

  std::unique_ptr<Implementation> Machine;
  std::string Error;
};

} // namespace tp

#endif // TP_SIMULATOR_FUNCTIONAL_FUNCTIONALMACHINE_H
