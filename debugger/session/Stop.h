//===- Stop.h - Why a program stopped ---------------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_SESSION_STOP_H
#define TP_DEBUGGER_SESSION_STOP_H

#include "debugger/source/Value.h"
#include "simulator/core/Trap.h"
#include "simulator/replay/Replay.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// Which way in time.
enum class Direction { Forward, Backward };

/// Why the program is no longer running.
struct SessionStop {
  enum StopKind {
    /// One or more breakpoints; see Numbers.
    Breakpoint,
    /// A watchpoint; see Numbers and Access.
    Watchpoint,
    /// The variables of watched expressions went out of scope; these
    /// watchpoints are the first of Numbers, and deleted.
    ScopeEnded,
    /// A step, finish, until or advance is done.
    Step,
    /// All threads have halted.
    Exited,
    Trapped,
    /// Backwards: there is nothing before.
    Beginning,
    Interrupted,
    /// --max-cycles is reached.
    CycleLimit,
    /// The condition of a breakpoint cannot be evaluated; see Numbers and
    /// Message.
    ConditionFailed,
  };
  StopKind Kind = Step;
  /// Whom it concerns.
  uint32_t Thread = 0;
  uint32_t Pc = 0;
  /// The frame of Thread's stack that the user wants to see: that of the
  /// function whose breakpoint it is, not of one inlined at its beginning.
  unsigned Frame = 0;
  /// Breakpoints and watchpoints that stopped here.
  std::vector<unsigned> Numbers;
  /// Numbers of those that are deleted: temporary ones, and watchpoints whose
  /// scope has ended.
  std::vector<unsigned> Deleted;
  /// The commands of those that stopped here.
  std::vector<std::string> Commands;

  /// Of a watchpoint: the access, by which instruction, and the bytes that are
  /// watched before and after it.
  uint32_t AccessPc = 0;
  bool IsWrite = false;
  std::vector<uint8_t> Old;
  std::vector<uint8_t> New;
  /// What the watched bytes are, if an expression is watched.
  const Type *WatchedType = nullptr;

  std::optional<Trap> TrapInfo;
  int ExitStatus = 0;
  /// What the function that was finished returned.
  std::optional<Value> Returned;
  std::string Message;
};

} // namespace tp

#endif // TP_DEBUGGER_SESSION_STOP_H
