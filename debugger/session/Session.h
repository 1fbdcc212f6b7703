//===- Session.h - A program being debugged ---------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Prints nothing and knows no protocol.
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_SESSION_SESSION_H
#define TP_DEBUGGER_SESSION_SESSION_H

#include "debugger/session/Breakpoints.h"
#include "debugger/session/Stop.h"
#include "debugger/session/ThreadName.h"
#include "debugger/source/DebugInformation.h"
#include "debugger/source/ValuePrinter.h"
#include "simulator/chip/ChipConfig.h"
#include "simulator/replay/Replay.h"
#include "simulator/tools/Options.h"
#include "simulator/tools/RunSetup.h"

#include "llvm/Support/Error.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

namespace tp {

/// What to debug.
struct SessionOptions {
  /// Program, chip, scene, limits, as for tpsim.
  Options Run;
  /// For what is needed to go back in time.
  uint64_t CheckpointBytes = uint64_t(512) << 20;
};

/// Reads tpsim's options and tpdbg's own that concern the session
/// (`--checkpoint-memory`); the error names what a debugger cannot do.
llvm::Expected<SessionOptions>
parseSessionOptions(llvm::ArrayRef<const char *> Arguments);

/// A step of one thread.
struct StepRequest {
  enum StepUnit { Line, Instruction };
  uint32_t Thread = 0;
  StepUnit Unit = Line;
  /// `next`: calls are done in one go.
  bool OverCalls = false;
  Direction Towards = Direction::Forward;
};

/// A program on its simulated chip, stopped at a moment, with breakpoints.
class Session {
public:
  using OutputCallback =
      std::function<void(bool IsStandardError, llvm::StringRef Text)>;

  /// Loads chip, scene and program; the program is before its first
  /// instruction. Chips by name are below \p ChipFolder.
  static llvm::Expected<std::unique_ptr<Session>>
  create(const SessionOptions &Request, llvm::StringRef ChipFolder);
  ~Session();

  /// Who gets the program's output; without one it is dropped.
  void setOutput(OutputCallback Callback) { Output = std::move(Callback); }
  /// Called about ten times a second while the program runs.
  void setProgress(ProgressFunction Callback) {
    Machine->setProgress(Progress = std::move(Callback));
  }
  /// Stops the program soon; from any thread or signal handler.
  void interrupt() { StopRequested = true; }

  const SessionOptions &options() const { return Request; }
  const ChipConfig &chip() const { return Chip; }
  bool isFunctional() const { return Request.Run.Functional; }
  const ElfProgram &program() const { return *Elf; }
  DebugInformation &information() { return *Information; }
  const ValuePrinter &printer() const { return *Printer; }
  Replay &replay() { return *Machine; }
  const Replay &replay() const { return *Machine; }
  BreakpointTable &breakpoints() { return Table; }
  ValueHistory &history() { return Values; }

  /// The program from its start again, as it was loaded: changes are gone.
  llvm::Error restart();
  /// Whether anything has been executed.
  bool isStarted() const;

  /// Adds a breakpoint at what \p Text means (see findLocations()).
  llvm::Expected<Breakpoint *> addBreakpoint(llvm::StringRef Text,
                                             const LocationDefaults &Defaults);
  /// Adds a watchpoint on what the expression \p Text names in \p Frame.
  /// Unless \p IsLocation it ends with the frame whose variables it needs.
  llvm::Expected<Breakpoint *> addWatchpoint(llvm::StringRef Text,
                                             uint32_t Thread,
                                             const FrameContext &Frame,
                                             bool Reads, bool Writes,
                                             bool IsLocation);
  /// Adds a watchpoint on memory; in a local store that of \p Thread.
  llvm::Expected<Breakpoint *> addWatchpoint(uint32_t Address, uint32_t Bytes,
                                             uint32_t Thread, bool Reads,
                                             bool Writes);
  /// Gives a breakpoint a condition, or takes it away if \p Text is empty.
  llvm::Error setCondition(Breakpoint &Of, llvm::StringRef Text);

  /// Runs until something stops it.
  SessionStop resume(Direction Towards);
  /// Steps a thread; the others run along.
  SessionStop step(const StepRequest &Step);
  /// Runs until \p Of (of backtrace()) has returned; backwards until before its
  /// call.
  llvm::Expected<SessionStop> finish(uint32_t Thread, const Frame &Of,
                                     Direction Towards);
  /// Runs until the thread is at one of the locations or \p Of has returned.
  SessionStop advance(uint32_t Thread, const Frame &Of,
                      llvm::ArrayRef<CodeLocation> Locations);
  /// `until` without a location: the next line that is not before this one.
  SessionStop until(uint32_t Thread);
  /// Goes to the beginning of a cycle (functional mode: before that
  /// instruction of the run).
  SessionStop goTo(uint64_t Time);

  /// To the thread's next instruction, without regard to breakpoints.
  SessionStop moveByOne(uint32_t Thread);
  /// Who wrote last to some bytes; see Replay.
  LastWrite lastWrite(uint32_t Thread, uint32_t Address, uint32_t Bytes);

  /// How a thread sees memory and registers. Lives as long as the session.
  const MachineAccess &machine(uint32_t Thread);
  /// The innermost function's state, not yet by inlined function.
  FrameContext context(uint32_t Thread);
  Backtrace backtrace(uint32_t Thread, size_t Limit = size_t(-1));
  /// Whether an address is in the local stores.
  bool isLocal(uint32_t Address) const;

private:
  friend class Stepper;
  Session();

  /// Runs until one of \p Own (then it is a Step), a breakpoint or the end.
  SessionStop run(Direction Towards, std::vector<InstructionEvents> Own);

  llvm::Error start();
  Events wantedEvents(Direction Towards);
  unsigned frameOf(const CodeLocation &At) const;
  bool countsHit(Breakpoint &At, uint32_t Thread, SessionStop &Result);
  std::optional<SessionStop> interpret(const ReplayStop &At, bool IsOwn);
  void interpretInstruction(const ReplayStop &At, SessionStop &Result);
  void interpretAccess(const ReplayStop &At, SessionStop &Result);
  ProbeTest testOf(const Breakpoint &Of);
  bool isWanted(const InstructionEvents &Of, const ReplayStop &At);

  SessionOptions Request;
  ChipConfig Chip;
  /// Where debug information comes from; it stays when the run is restarted.
  std::unique_ptr<ElfProgram> Elf;
  std::unique_ptr<RunSetup> Loaded;
  std::unique_ptr<DebugInformation> Information;
  std::unique_ptr<ValuePrinter> Printer;
  std::unique_ptr<Replay> Machine;
  BreakpointTable Table;
  ValueHistory Values;
  OutputCallback Output;
  ProgressFunction Progress;
  std::atomic<bool> StopRequested = false;
  std::vector<std::unique_ptr<MachineAccess>> Access;
  /// Watchpoints, by the index of their access events.
  std::vector<unsigned> Watching;
  /// Watchpoints that end with a frame, and its return.
  std::vector<std::pair<unsigned, InstructionEvents>> Ending;
  /// Conditions may be asked for by several threads of the host.
  std::mutex Evaluating;
};

} // namespace tp

#endif // TP_DEBUGGER_SESSION_SESSION_H
