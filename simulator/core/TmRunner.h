//===- TmRunner.h - What one host thread works on ---------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_TMRUNNER_H
#define TP_SIMULATOR_CORE_TMRUNNER_H

#include "runtime/include/tp/profile.h"
#include "simulator/chip/ChipConfig.h"
#include "simulator/core/WindowLog.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace tp {

/// What the instructions of all TMs share.
struct ChipContext {
  const ChipConfig *Chip = nullptr;
  uint8_t *Global = nullptr;
  /// Who wants the profile values, or none.
  ProfileObserver *Observer = nullptr;
  uint32_t TextBegin = 0;
  uint32_t TextWords = 0;
  uint32_t ReadOnlyBytes = 0;
  uint32_t GlobalBytes = 0;
  uint32_t LocalBegin = 0;
  uint32_t LocalBytes = 0;
  uint32_t StackLimit = 0;
  uint32_t MemoryLatency = 0;
  uint32_t BranchLatency = 1;
};

/// The part of a host thread's working state that does not depend on the width
/// of the resource word: where it is, its log, and what it counted.
struct TmRunnerState {
  ChipContext Chip;

  /// The current window in absolute cycles, and the cycle from which relative
  /// ones count.
  uint64_t WindowStart = 0;
  uint64_t Epoch = 0;
  /// Relative first cycle after the window.
  uint64_t End = 0;
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
  std::optional<PendingTrap> FirstTrap;

  /// Threads that arrived at the barrier, and that halted, in this window.
  uint32_t Arrived = 0;
  uint32_t Halted = 0;

  std::array<uint64_t, NumOpcodes> Executed{};
  std::array<uint64_t, NumOpcodes> DataStall{};
  std::array<uint64_t, NumOpcodes> UnitConflict{};
  std::vector<uint64_t> Markers;

  uint64_t windowStartRelative() const { return WindowStart - Epoch; }

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
};

} // namespace tp

#endif // TP_SIMULATOR_CORE_TMRUNNER_H
