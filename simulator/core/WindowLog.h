//===- WindowLog.h - What leaves the TMs in a window ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_WINDOWLOG_H
#define TP_SIMULATOR_CORE_WINDOWLOG_H

#include "simulator/core/Thread.h"
#include "simulator/core/Trap.h"
#include "simulator/isa/StreamAccess.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace tp {

/// The order in which accesses of a window take effect: (cycle, priority of the
/// TP in this window, TM). No two accesses have the same.
using OrderKey = uint64_t;

/// Most TPs of a TM, and most TMs, that a key can hold.
inline constexpr uint32_t OrderKeyLimit = 1 << 16;

constexpr OrderKey orderKey(uint64_t CycleInWindow, uint32_t Priority,
                            uint32_t Tm) {
  return CycleInWindow << 32 | uint64_t(Priority) << 16 | Tm;
}

constexpr uint16_t priorityOf(OrderKey Key) { return uint16_t(Key >> 16); }

using AtomicFunction = uint32_t (*)(uint32_t Old, uint32_t Operand,
                                    uint32_t Expected);
using StreamFunction = uint32_t (*)(StreamMemory &Memory, uint32_t Descriptor,
                                    uint32_t Value);

/// An access to global memory or a host call, to take effect at the end of the
/// window.
struct GlobalAccess {
  enum AccessKind : uint8_t { Store, Atomic, Stream, HostCall };

  OrderKey Key;
  Thread *Owner;
  union {
    AtomicFunction AtomicOperation;
    StreamFunction StreamOperation;
    uint32_t Service;
  };
  uint32_t Address;
  /// The stored value, the operand, or the third argument of a host call.
  uint32_t Value;
  /// Of an atomic, the expected value; of a host call, its first argument.
  uint32_t Extra;
  uint32_t Pc;
  /// The ready word of the destination; the result is written only if no later
  /// instruction has taken the register over.
  ReadyWord Ready;
  AccessKind Kind;
  /// Of a store.
  uint8_t Bytes;
  uint8_t Destination;
};

/// A trap and its place in the order of the window.
struct PendingTrap {
  OrderKey Key;
  Trap Info;
};

/// Keeps the earlier of two traps.
inline void keepFirst(std::optional<PendingTrap> &First,
                      const PendingTrap &Candidate) {
  if (!First || Candidate.Key < First->Key)
    First = Candidate;
}

} // namespace tp

#endif // TP_SIMULATOR_CORE_WINDOWLOG_H
