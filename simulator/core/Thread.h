//===- Thread.h - State of one simulated thread -----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_THREAD_H
#define TP_SIMULATOR_CORE_THREAD_H

#include "simulator/isa/Instructions.h"
#include "simulator/stats/Statistics.h"

#include <array>
#include <cstdint>

namespace tp {

class ThreadRequests;

/// When a register's value is ready and who makes it, in one word whose order
/// is the order in time: the cycle relative to the engine's epoch, whether it
/// comes from global memory, the opcode of the producer.
using ReadyWord = uint32_t;

namespace ready {

inline constexpr unsigned CycleShift = 9;
inline constexpr ReadyWord FromGlobalMemory = 1 << 8;
inline constexpr ReadyWord OpcodeMask = FromGlobalMemory - 1;
/// Relative cycles must stay below this.
inline constexpr uint64_t CycleLimit = (uint64_t(1) << (32 - CycleShift)) - 1;
/// The cycle of a result that is not known to be ready in any.
inline constexpr uint64_t PendingCycle = CycleLimit;

static_assert(NumOpcodes <= OpcodeMask);

/// The word for a result \p Latency cycles after issue; the cycle of issue is
/// added to it, shifted by CycleShift.
constexpr ReadyWord after(uint32_t Latency, Opcode Producer,
                          bool FromGlobal = false) {
  return Latency << CycleShift | (FromGlobal ? FromGlobalMemory : 0) |
         ReadyWord(Producer);
}

/// The word for a result whose cycle the memory system will tell.
constexpr ReadyWord pending(Opcode Producer) {
  return ReadyWord(PendingCycle << CycleShift) | FromGlobalMemory |
         ReadyWord(Producer);
}

constexpr uint64_t cycleOf(ReadyWord Word) { return Word >> CycleShift; }
constexpr bool isPending(ReadyWord Word) {
  return cycleOf(Word) == PendingCycle;
}
/// The word with another cycle.
constexpr ReadyWord withCycle(ReadyWord Word, uint64_t Cycle) {
  constexpr ReadyWord Rest = (1 << CycleShift) - 1;
  return ReadyWord(Cycle << CycleShift) | (Word & Rest);
}
constexpr Opcode producerOf(ReadyWord Word) {
  return Opcode(Word & OpcodeMask);
}

} // namespace ready

/// Lines of the text are counted from address 0. This is none.
inline constexpr uint32_t NoLine = ~uint32_t(0);

/// What a thread is doing at the end of a window.
enum class ThreadState : uint8_t { Running, AtBarrier, Halted, Trapped };

/// One TP and the thread on it.
struct Thread {
  std::array<uint32_t, NumRegisters> Registers{};
  std::array<ReadyWord, NumRegisters> Ready{};
  /// The decoded instruction to go on with (a Slot of the engine).
  const void *Resume = nullptr;
  /// Host address that simulated address 0 would have if all of the address
  /// space were as the local store is.
  uintptr_t LocalStoreBias = 0;
  /// Null on a chip without a memory system.
  ThreadRequests *Requests = nullptr;
  /// Cycles lost so far, also those that are still ahead of a sleeping thread.
  LossCounts Lost{};
  /// The cycle after the last instruction of a thread that is at a barrier or
  /// has halted; the cycle of the trap.
  uint64_t EndCycle = 0;
  uint32_t Number = 0;
  int32_t Status = 0;
  ThreadState State = ThreadState::Running;
  /// What the thread was last charged for, at which word of the text, and by
  /// which producer.
  Loss LastLoss = Loss::Data;
  Opcode LastProducer = Opcode(0);
  uint32_t LastWord = 0;
  /// The line of the text that the TP holds, or waits for, on a chip whose
  /// instruction caches can miss.
  uint32_t Line = NoLine;

  uint64_t totalLost() const {
    uint64_t Sum = 0;
    for (uint64_t Cycles : Lost)
      Sum += Cycles;
    return Sum;
  }
};

/// The next cycle of a thread that nothing but others can wake.
inline constexpr uint64_t NeverCycle = ~uint64_t(0);

} // namespace tp

#endif // TP_SIMULATOR_CORE_THREAD_H
