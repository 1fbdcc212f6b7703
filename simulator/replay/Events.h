//===- Events.h - What stops a replay ---------------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_REPLAY_EVENTS_H
#define TP_SIMULATOR_REPLAY_EVENTS_H

#include "simulator/core/Thread.h"
#include "simulator/core/Trap.h"
#include "simulator/replay/Moment.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace tp {

/// A thread that is about to issue an instruction, while the machine runs.
struct Probe {
  uint32_t Thread = 0;
  uint32_t Pc = 0;
  Moment At;
  /// 0..31 integer, 32..63 float.
  const std::array<uint32_t, NumRegisters> &Registers;
  /// Memory as the thread would load it here: its own stores and, of the
  /// others, those of earlier arbitration windows. False for what is no memory.
  const std::function<bool(uint32_t Address, std::span<uint8_t> Bytes)> &Read;
};

/// Decides whether an event counts. It may depend on nothing but the probe: it
/// is asked again when the run is repeated.
using ProbeTest = std::function<bool(const Probe &)>;

/// Instructions to stop before.
struct InstructionEvents {
  /// Their addresses; empty: all.
  std::vector<uint32_t> Pcs;
  /// Only of this thread.
  std::optional<uint32_t> Thread;
  /// Null: each counts.
  ProbeTest Wanted;
};

/// Accesses to the bytes [Address, Address + Bytes) to stop at: forward behind
/// the access, backward before it.
struct AccessEvents {
  uint32_t Address = 0;
  uint32_t Bytes = 0;
  bool Reads = false;
  bool Writes = true;
  /// Leaves out writes after which the bytes are as before.
  bool OnlyChanges = false;
  /// Only of this thread. Required if the bytes are in the local store, whose
  /// it then is.
  std::optional<uint32_t> Thread;
  ProbeTest Wanted;
};

/// The first event that happens ends a run.
struct Events {
  std::vector<InstructionEvents> Instructions;
  std::vector<AccessEvents> Accesses;
};

/// Where and why a replay stands.
struct ReplayStop {
  enum StopKind {
    /// An instruction event: Thread is about to issue Pc.
    Instruction,
    /// An access event: the instruction at Pc of Thread.
    Access,
    /// All threads have halted; ExitStatus.
    Halted,
    /// A thread is about to trap; TrapInfo.
    Trapped,
    /// The beginning of the run.
    Beginning,
    /// The stop flag was set.
    Interrupted,
    /// The limit of cycles is reached.
    CycleLimit,
  };
  StopKind Kind = Beginning;
  Moment At;
  uint32_t Thread = 0;
  uint32_t Pc = 0;
  /// Which of Events::Instructions or Events::Accesses it was.
  size_t Event = 0;
  /// Of an access: what the instruction accessed, whether it wrote, and the
  /// event's bytes before and after it. If another thread traps in the same
  /// cycle the machine stands before the access, and New is empty.
  uint32_t AccessAddress = 0;
  uint32_t AccessBytes = 0;
  bool IsWrite = false;
  std::vector<uint8_t> Old;
  std::vector<uint8_t> New;
  std::optional<Trap> TrapInfo;
  int ExitStatus = 0;
};

} // namespace tp

#endif // TP_SIMULATOR_REPLAY_EVENTS_H
