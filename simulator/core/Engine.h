//===- Engine.h - The cycle model of a chip ---------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// docs/cycle-model.md states the rules that the engine follows.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_ENGINE_H
#define TP_SIMULATOR_CORE_ENGINE_H

#include "runtime/include/tp/profile.h"
#include "simulator/chip/ChipConfig.h"
#include "simulator/core/ArchitecturalState.h"
#include "simulator/core/Memory.h"
#include "simulator/core/Program.h"
#include "simulator/core/Trap.h"
#include "simulator/memory/MemorySystem.h"
#include "simulator/stats/Statistics.h"

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tp {

/// How far a run is.
struct Progress {
  uint64_t Cycles = 0;
  /// Thread-instructions issued.
  uint64_t Instructions = 0;
  uint32_t HaltedThreads = 0;
};

/// How a run ended. After the first three run() does nothing more, until an
/// earlier state is restored.
struct RunResult {
  enum EndKind {
    /// All threads halted.
    Halted,
    /// A thread trapped; see TrapInfo.
    Trapped,
    /// MaxCycles cycles were simulated.
    CycleLimit,
    /// The stop flag was set.
    Stopped,
    /// PauseCycle or one of PauseMarkers was reached.
    Paused,
  };
  EndKind End = Halted;
  /// The first non-zero status in thread order, or 0; 1 after a trap.
  int ExitStatus = 0;
  std::optional<Trap> TrapInfo;
};

/// Receives what the program writes: the file descriptor (1 or 2) and bytes.
using OutputFunction = std::function<void(int Fd, std::string_view Bytes)>;
using ProgressFunction = std::function<void(const Progress &)>;

/// How long to run. What is not set limits nothing.
struct RunLimits {
  /// Ends the run after this many cycles since its start; 0: no limit. Where
  /// the limit is inside of an arbitration window, a state that is saved there
  /// and restored goes on, but not as without the limit: what left the TMs has
  /// taken effect earlier.
  uint64_t MaxCycles = 0;
  /// Pauses at the first window boundary that is not before this cycle; 0: no
  /// pause.
  uint64_t PauseCycle = 0;
  /// Pauses at the end of a window in which a thread passed one of these
  /// profile markers.
  std::vector<uint32_t> PauseMarkers;
  /// Stops at the end of a window when this has become true.
  const std::atomic<bool> *Stop = nullptr;
  /// Called about ten times a second.
  ProgressFunction Report;
};

class CodeGenerator;
class CommitObserver;
class ExecutionRecorder;
class EngineImplementation;
class IssueObserver;

/// Where a thread is between two runs.
struct ThreadPlace {
  /// The word of the text to go on with.
  uint32_t Word = 0;
  /// The first cycle in which it may issue it; NeverCycle if that is not known
  /// yet.
  uint64_t Cycle = 0;
};

/// Simulates a program on a chip, cycle by cycle. Cycles, memory, output and
/// statistics depend on nothing but chip, program and memory contents.
class Engine {
public:
  /// Program and memory must outlive the engine. \p Hierarchy is what
  /// makeMemorySystem() gives for the chip.
  Engine(const ChipConfig &Chip, const Program &Text, Memory &Global,
         std::unique_ptr<MemorySystem> Hierarchy = nullptr);
  ~Engine();

  /// Why this chip cannot be simulated (a latency or count beyond what the
  /// engine can represent, no room on the host); empty if it can. Check it
  /// before run().
  const std::string &error() const { return Error; }

  /// Threads of the host to use; 1 at first. They change nothing but speed.
  void setHostThreads(unsigned Count);
  /// Who receives the values of `profv`: those of one thread in its order,
  /// those of different threads possibly at once, and also of instructions that
  /// the cycle limit cuts off. It must outlive the run. Without it they are
  /// dropped.
  void setObserver(ProfileObserver *Observer);
  /// Where host calls write; without it output is dropped.
  void setOutput(OutputFunction Function);
  /// Who compiles hot code, before the first run(). Without one the reference
  /// engine does everything; it changes nothing but speed.
  void setCodeGenerator(std::unique_ptr<CodeGenerator> Generator);

  /// Who records what a profile needs, before a code generator is set and
  /// before the first run(). It must outlive the runs.
  void setRecorder(ExecutionRecorder &Recorder);

  /// Who sees the instructions of the \p Words that are set, of all words of
  /// the text, from the next run() on; null: nobody. Not with a code generator.
  void setIssueObserver(IssueObserver *Observer,
                        const std::vector<bool> &Words);
  /// Who sees writes to global memory; null: nobody.
  void setCommitObserver(CommitObserver *Observer);

  /// Where the threads, by their number, begin; instead of at the program's
  /// entry with registers and local stores of zeros. Before the first run().
  void setInitialState(std::span<const ArchitecturalState> States);

  /// Runs until all threads have halted, one trapped, or a limit is reached.
  /// After a pause or stop the next call goes on from there: pauses change no
  /// result.
  RunResult run(const RunLimits &Limits = {});

  /// Cycles simulated so far.
  uint64_t cycles() const;
  Progress progress() const;
  /// How often threads have passed a profile marker.
  uint64_t passes(uint32_t Marker) const;
  /// The counts up to the end of the last run().
  Statistics statistics() const;

  /// Saves or restores everything but global memory and what the setters set,
  /// between two runs; to restore, chip and program must be those of the saved
  /// engine. The number of host threads may be another.
  void serialize(Archive &A);

  /// A register of a thread, 0..31 integer, 32..63 float.
  uint32_t registerOf(uint32_t Thread, unsigned Register) const;
  /// A thread between two runs.
  const Thread &thread(uint32_t Number) const;
  ThreadPlace placeOf(uint32_t Number) const;
  /// The cycle from which the threads' ready words count.
  uint64_t epoch() const;
  /// Change it. A register is ready at once; r0 stays 0.
  void setRegister(uint32_t Number, unsigned Register, uint32_t Value);
  void setNextWord(uint32_t Number, uint32_t Word);
  /// Status that a thread halted with.
  int32_t statusOf(uint32_t Thread) const;

private:
  std::unique_ptr<EngineImplementation> Implementation;
  std::string Error;
};

} // namespace tp

#endif // TP_SIMULATOR_CORE_ENGINE_H
