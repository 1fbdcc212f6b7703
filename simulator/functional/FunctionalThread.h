//===- FunctionalThread.h - A thread without its timing ---------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_FUNCTIONAL_FUNCTIONALTHREAD_H
#define TP_SIMULATOR_FUNCTIONAL_FUNCTIONALTHREAD_H

#include "simulator/core/AddressSpace.h"
#include "simulator/core/Engine.h"
#include "simulator/core/Thread.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace tp {

/// Called before an instruction with its address and the thread's registers.
using StepObserver = std::function<void(
    uint32_t Pc, const std::array<uint32_t, NumRegisters> &Registers)>;

/// One thread of the functional mode.
struct FunctionalThread {
  std::array<uint32_t, NumRegisters> Registers{};
  /// Number of the word of the text to go on with.
  uint32_t NextWord = 0;
  uint32_t Number = 0;
  /// As in Thread.
  uintptr_t LocalStoreBias = 0;
  /// Instructions issued up to the beginning of its turn, plus the turn's
  /// quantum: what remains of the quantum is taken off.
  uint64_t TurnEnd = 0;
  /// Cycles that `sleep` passed over.
  uint64_t Slept = 0;
  int32_t Status = 0;
  ThreadState State = ThreadState::Running;
  /// Waits at the marker at which the machine is to stop.
  bool AtMarker = false;
};

class ExecutionChecks;
class InstructionStops;

/// What all threads of the functional mode share.
struct FunctionalContextState {
  AddressSpace Space;
  const ChipConfig *Chip = nullptr;
  ProfileObserver *Observer = nullptr;
  /// Null: none are made.
  ExecutionChecks *Checks = nullptr;
  /// Null: turns end by themselves.
  InstructionStops *Stops = nullptr;
  OutputFunction Output;
  uint32_t StackLimit = 0;
  /// Threads stop behind this marker.
  std::optional<uint32_t> StopMarker;
  std::vector<uint64_t> Markers;
  uint32_t Arrived = 0;
  uint32_t Halted = 0;
  std::optional<Trap> FirstTrap;
  /// Instructions that all threads but the one whose turn it is have issued.
  uint64_t IssuedByOthers = 0;
};

} // namespace tp

#endif // TP_SIMULATOR_FUNCTIONAL_FUNCTIONALTHREAD_H
