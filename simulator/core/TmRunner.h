//===- TmRunner.h - What one host thread works on ---------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_TMRUNNER_H
#define TP_SIMULATOR_CORE_TMRUNNER_H

#include "runtime/include/tp/profile.h"
#include "simulator/core/AddressSpace.h"
#include "simulator/core/EngineObservers.h"
#include "simulator/core/ExecutionRecorder.h"
#include "simulator/core/InstructionCache.h"
#include "simulator/core/ThreadRequests.h"
#include "simulator/core/WindowLog.h"
#include "simulator/memory/MemorySystem.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace tp {

/// What the instructions of all TMs share.
struct ChipContext : AddressSpace {
  const ChipConfig *Chip = nullptr;
  /// Who wants the profile values, or none.
  ProfileObserver *Observer = nullptr;
  uint32_t StackLimit = 0;
  uint32_t MemoryLatency = 0;
  uint32_t BranchLatency = 1;
};

/// How often an instruction of the text was executed, and accessed global
/// memory.
struct IssueCounts {
  uint64_t Executed = 0;
  uint64_t Global = 0;
};

/// The part of a host thread's working state that does not depend on the width
/// of the resource word: where it is, its log, and what it counted.
struct TmRunnerState {
  /// What one TP has done in the window at hand.
  struct OwnAccesses {
    std::vector<GlobalAccess> Log;
    uint64_t Words = 0;
  };

  ChipContext Chip;

  /// The current window in absolute cycles, and the cycle from which relative
  /// ones count.
  uint64_t WindowStart = 0;
  uint64_t Epoch = 0;
  /// Relative first cycle after the window, and the one that the running thread
  /// may not reach now; it is at most End.
  uint64_t End = 0;
  uint64_t Limit = 0;
  /// The running thread's next cycle, set (absolute) when it stops.
  uint64_t NextCycle = 0;

  /// Accesses of this window, of all TMs that this host thread runs.
  std::vector<GlobalAccess> Log;
  /// Where the running thread's accesses begin, and a Bloom filter of the words
  /// that they touch.
  size_t OwnLogBegin = 0;
  uint64_t OwnWords = 0;
  /// The running thread's priority and TM, as the low bits of its order keys.
  OrderKey OwnOrder = 0;
  /// Of the TM at hand; null on a chip without a memory system.
  TmMemory *Memory = nullptr;
  /// Of its TPs; used if they do not run one after the other.
  std::vector<OwnAccesses> OwnAccessesOf;
  std::vector<MemoryAnswer> Answers;
  /// Requests made in this turn, less those answered in it.
  int64_t Unanswered = 0;
  /// 0 without an L1.
  uint32_t L1Latency = 0;
  /// Of the TM at hand; null on a chip whose instruction caches never miss. And
  /// the line of each word of the text.
  InstructionCache *Icache = nullptr;
  const uint32_t *LineOf = nullptr;
  std::optional<PendingTrap> FirstTrap;

  /// What a recorder wants to know; null without one.
  RecorderPart *Record = nullptr;
  /// Who sees instructions before they are issued, or none.
  IssueObserver *Issues = nullptr;

  /// Threads that arrived at the barrier, and that halted, in this window.
  uint32_t Arrived = 0;
  uint32_t Halted = 0;

  /// What was issued, and thread-cycles lost, at each word of the text.
  std::vector<IssueCounts> IssuedAt;
  std::vector<LossCounts> LostAt;
  std::array<uint64_t, NumOpcodes> DataStall{};
  /// What generated code has counted since CodeGenerator::fold(), and where
  /// that begins.
  std::vector<uint64_t> CodeCounts;
  uint64_t *CodeCountsBegin = nullptr;
  std::vector<uint64_t> Markers;

  uint64_t windowStartRelative() const { return WindowStart - Epoch; }

  /// Charges a thread for cycles in which it does not issue, at a word of the
  /// text.
  void charge(Thread &T, uint32_t Word, Loss Reason, uint64_t Cycles) {
    T.Lost[unsigned(Reason)] += Cycles;
    T.LastLoss = Reason;
    T.LastWord = Word;
    LostAt[Word][unsigned(Reason)] += Cycles;
  }

  /// A new entry at the end of the log.
  GlobalAccess &appendToLog() {
    if (Log.size() == Log.capacity()) [[unlikely]]
      growLog();
    return Log.emplace_back();
  }
  void growLog();
  /// Makes a TP's accesses the log, and back.
  void swapLog(OwnAccesses &Own) {
    std::swap(Log, Own.Log);
    std::swap(OwnWords, Own.Words);
    OwnLogBegin = 0;
  }
  /// Moves a TP's accesses to the end of the log.
  void moveToLog(OwnAccesses &Own) {
    Log.insert(Log.end(), Own.Log.begin(), Own.Log.end());
    Own.Log.clear();
    Own.Words = 0;
  }
  void countMarker(uint32_t Number);
  /// Adds what was counted to the counts of \p Other, and begins anew.
  void moveCountersTo(TmRunnerState &Other);

  /// Asks the memory system for a load, or for an atomic or stream operation,
  /// of the instruction \p Word, whose result goes to a register of the running
  /// thread; gives its ready word.
  ReadyWord requestLoad(Thread &T, uint32_t Word, uint8_t Destination,
                        Opcode Op, uint64_t Cycle, uint32_t Address,
                        unsigned Bytes);
  ReadyWord requestAtomic(Thread &T, uint32_t Word, uint8_t Destination,
                          Opcode Op, uint64_t Cycle, uint32_t Address);
  /// Asks it for a store; false, and nothing done, if the store buffer is full.
  bool requestStore(Thread &T, uint32_t Word, uint64_t Cycle, uint32_t Address,
                    unsigned Bytes);
  /// Asks it for a line of the text that a TP missed.
  void requestLine(const InstructionCache::Miss &Missed);
  /// Lets the running thread, which is to go on in the cycle NextCycle, wait
  /// for all its stores.
  void awaitStores(Thread &T);

  static uint64_t wordBit(uint32_t Address) {
    return uint64_t(1) << (Address >> 2 & 63);
  }

  OrderKey keyAt(uint64_t Cycle) const {
    return (Cycle - windowStartRelative()) << 32 | OwnOrder;
  }

  /// Replaces the bytes of \p Value, loaded from global memory, that the
  /// running thread has itself stored in this window. If one of them was last
  /// touched by an atomic or a stream operation, whose result is not known yet,
  /// gives that access's producer instead.
  std::optional<Opcode> forwardOwn(uint32_t Address, unsigned Bytes,
                                   uint32_t &Value) const;

private:
  void ask(const MemoryRequest &Request) {
    ++Unanswered;
    Memory->request(Request);
  }
  /// Likewise, for the instruction \p Word of a thread.
  void ask(const MemoryRequest &Request, Thread &T, uint32_t Word) {
    if (Record) [[unlikely]]
      T.Requests->addOrigin(Request.Ticket, {Word, Request.Cycle});
    ask(Request);
  }
  MemoryRequest request(const Thread &T, RequestKind Kind, uint64_t Cycle,
                        uint32_t Address, unsigned Bytes,
                        uint32_t Ticket) const;
};

} // namespace tp

#endif // TP_SIMULATOR_CORE_TMRUNNER_H
