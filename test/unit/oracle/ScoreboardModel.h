//===- ScoreboardModel.h - The cycle model, done naively --------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// docs/cycle-model.md word by word: every cycle, every TP in the order of
// priority. Nothing of the engine's is in it but the types of the results; of
// the instruction set it takes what an instruction computes (Bodies.h).
//
//===----------------------------------------------------------------------===//

#ifndef TP_TEST_UNIT_ORACLE_SCOREBOARDMODEL_H
#define TP_TEST_UNIT_ORACLE_SCOREBOARDMODEL_H

#include "simulator/core/Engine.h"
#include "simulator/isa/FloatRules.h"
#include "simulator/isa/StreamAccess.h"
#include "simulator/memory/MemorySystem.h"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tp::test {

/// An access to global memory or host call, to take effect at the end of its
/// window.
struct ModelAccess {
  enum AccessKind { Store, Atomic, Stream, HostCall };
  using AtomicFunction = uint32_t (*)(uint32_t, uint32_t, uint32_t);
  using StreamFunction = uint32_t (*)(StreamMemory &, uint32_t, uint32_t);

  AccessKind Kind = Store;
  uint32_t Address = 0;
  uint32_t Value = 0;
  /// Of an atomic the expected value, of a host call its first argument.
  uint32_t Extra = 0;
  uint32_t Service = 0;
  unsigned Bytes = 4;
  AtomicFunction OnWord = nullptr;
  StreamFunction OnStream = nullptr;

  // Where it comes from.
  Opcode Op = IllegalOpcode;
  uint32_t Thread = 0;
  uint32_t Pc = 0;
  uint64_t Cycle = 0;
  uint32_t Priority = 0;
  unsigned Destination = NoRegister;
  /// Which write of the destination its result is.
  uint64_t Write = 0;
};

/// What one instruction wants done.
struct ModelEffects {
  enum Continuation { Next, Barrier, Sync, Sleep, Halt };

  std::optional<TrapKind> TrapReason;
  uint32_t TrapAddress = 0;
  /// Of a taken branch.
  std::optional<uint32_t> Target;
  bool HasResult = false;
  uint32_t Result = 0;
  /// Of a load.
  uint32_t Address = 0;
  unsigned Bytes = 4;
  /// Cycles until the result, if its place says so and not its class.
  std::optional<uint32_t> Latency;
  bool FromGlobal = false;
  /// The own access of the window whose end has to be waited for.
  std::optional<Opcode> Blocker;
  std::optional<ModelAccess> Access;
  Continuation Then = Next;
  uint32_t Argument = 0;
};

struct ModelRegister {
  uint32_t Value = 0;
  /// First cycle in which it may be read, if that is known.
  uint64_t Ready = 0;
  bool IsPending = false;
  ServedBy Level = ServedBy::Memory;
  bool FromGlobal = false;
  /// Its value comes at the end of the window.
  bool Unknown = false;
  Opcode Producer = Opcode(0);
  uint64_t Write = 0;
};

struct ModelThread {
  enum ThreadState { Running, AtBarrier, Halted, Trapped };

  uint32_t Number = 0;
  ThreadState State = Running;
  uint32_t Pc = 0;
  std::array<ModelRegister, NumRegisters> Registers;
  std::vector<uint8_t> LocalStore;
  /// Of the store buffer, each the first cycle in which it is free; the next
  /// store takes entry NextStore.
  std::vector<uint64_t> StoreEntries;
  size_t NextStore = 0;
  uint64_t LastStoreAnswer = 0;
  /// Waits for its entry, for all entries.
  bool AwaitsEntry = false;
  bool AwaitsStores = false;
  /// Cycles that it has waited for a result of which nobody knows yet where it
  /// comes from.
  uint64_t Uncharged = 0;
  /// Until this cycle it waits, and for what (and whose result).
  uint64_t NextIssue = 0;
  Loss Waiting = Loss::Data;
  Opcode WaitingFor = Opcode(0);
  /// Number of the word of the text at which its losses are counted.
  uint32_t LosingWord = 0;
  int32_t Status = 0;
  ThreadStatistics Counts;
  /// In program order: marker and value.
  std::vector<std::pair<uint32_t, uint32_t>> ProfileValues;
};

template <Subnormals Mode> class ModelContext;

class ScoreboardModel {
public:
  /// Program and memory must outlive the model.
  ScoreboardModel(const ChipConfig &Chip, const Program &Text, Memory &Global);

  RunResult run(uint64_t MaxCycles);

  const Statistics &statistics() const { return Counts; }
  const ModelThread &thread(uint32_t Number) const { return Threads[Number]; }
  const std::string &output() const { return Output; }

private:
  template <Subnormals> friend class ModelContext;
  class Streams;

  /// Of a TM in the cycle at hand.
  struct Started {
    std::array<uint32_t, NumUnits> Units{};
    std::vector<uint32_t> Banks;
  };

  void simulateCycle();
  void simulateThread(ModelThread &T, Started &S);
  /// The instruction behind the messages at which the thread stands; null if
  /// it has to wait or traps.
  const Instruction *nextInstruction(ModelThread &T);
  /// Whether the word of the text comes after one that moves the stack
  /// pointer: there the stack's limit is checked.
  bool isBehindStackMove(uint32_t Word) const;
  /// All that the thread may pass, when it is at them in cycle \p At.
  void passMessages(ModelThread &T, uint64_t At);
  bool mayPass(const ModelThread &T, const Instruction &I, uint64_t At) const;
  /// True if the instruction's sources are ready; else charges the wait.
  bool areSourcesReady(ModelThread &T, const Instruction &I);
  /// The one that is ready last.
  const ModelRegister &lastSource(const ModelThread &T,
                                  const Instruction &I) const;
  /// Charges what has been left uncharged, now that it is known to whom.
  void settle(ModelThread &T, const Instruction &I);
  void loseTo(ModelThread &T, const ModelRegister &Source, uint64_t Cycles);
  /// The same of its bank's ports and its unit's slots.
  bool hasSlots(ModelThread &T, const Instruction &I, const Started &S);
  void takeSlots(const ModelThread &T, const Instruction &I, Started &S) const;
  uint32_t bankOf(const ModelThread &T) const;
  ModelEffects execute(ModelThread &T, const Instruction &I);
  void issue(ModelThread &T, const Instruction &I, const ModelEffects &Effects);
  void writeResult(ModelThread &T, const Instruction &I,
                   const ModelEffects &Effects);
  uint32_t wordOf(const ModelThread &T) const;
  void lose(ModelThread &T, Loss Reason, uint64_t Cycles = 1);
  void loseToResult(ModelThread &T, Loss Reason, Opcode Producer,
                    uint64_t Cycles = 1);
  void trap(ModelThread &T, uint32_t Pc, TrapKind Reason, uint32_t Address);

  /// Whether the thread waits for its store buffer; charges it.
  bool awaitsStoreBuffer(ModelThread &T);
  void request(ModelThread &T, RequestKind Kind, unsigned Destination,
               const ModelEffects &Effects);
  void takeAnswer(uint32_t Tm, const MemoryAnswer &Answer);
  /// What the memory system decides at the beginning of a window, behind the
  /// cycle at hand, and at the end of a window.
  void takeSharedAnswers();
  void advanceMemory();
  void runSharedMemory();
  /// Charges those who still wait when the run is cut.
  void settleAll();

  void endWindow();
  void commit(const ModelAccess &Access);
  std::optional<uint32_t> hostCall(const ModelAccess &Access, Trap &Bad);
  void releaseBarrier();
  /// Takes back what the threads lost after the last one's end.
  void cutToLastHalt();

  uint32_t priorityOf(const ModelThread &T) const;
  void keepFirstTrap(const Trap &Info, uint32_t Priority);

  // The address space.
  uint32_t localBegin() const { return 0 - Chip.LocalStoreBytes; }
  bool isLocal(uint32_t Address) const;
  bool isGlobal(uint32_t Address) const;
  bool isReadOnly(uint32_t Address) const;
  uint32_t loadWord(uint32_t Address) const;

  const ChipConfig Chip;
  const Program &Text;
  Memory &Global;
  std::vector<ModelThread> Threads;
  /// Of each word of the text the instructions before it that are fetched.
  std::vector<uint32_t> Fetches;

  /// Null if the chip has no memory system; then all latencies are known.
  std::unique_ptr<MemorySystem> Hierarchy;
  /// What a ticket is for: a register (and which write of it) or an entry of
  /// the store buffer.
  struct Ticket {
    unsigned Destination = NoRegister;
    uint64_t Write = 0;
    size_t Entry = 0;
  };
  std::map<uint32_t, Ticket> Tickets;
  uint32_t NextTicket = 0;

  uint64_t Cycle = 0;
  uint64_t WindowStart = 0;
  uint64_t WindowEnd = 0;
  /// In the order of (cycle, priority, TM).
  std::vector<ModelAccess> Accesses;
  uint64_t Writes = 0;
  std::optional<Trap> FirstTrap;
  uint32_t FirstTrapPriority = 0;
  Statistics Counts;
  std::string Output;
};

} // namespace tp::test

#endif // TP_TEST_UNIT_ORACLE_SCOREBOARDMODEL_H
