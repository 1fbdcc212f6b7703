//===- Breakpoints.h - Where and when to stop -------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_SESSION_BREAKPOINTS_H
#define TP_DEBUGGER_SESSION_BREAKPOINTS_H

#include "debugger/session/Locations.h"
#include "debugger/source/Expression.h"

#include "llvm/Support/Error.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// What is watched.
struct WatchTarget {
  uint32_t Address = 0;
  uint32_t Bytes = 0;
  /// Of the expression; null if a range of addresses is watched.
  const Type *Of = nullptr;
  /// Whose local store it is in; none: global memory.
  std::optional<uint32_t> Thread;
  /// While the frame with this canonical frame address runs, which returns to
  /// ScopeReturn; none: always.
  std::optional<uint32_t> ScopeCfa;
  uint32_t ScopeReturn = 0;
};

/// A place in the code or a piece of memory at which the program is to stop.
struct Breakpoint {
  /// From 1 on, never used again.
  unsigned Number = 0;
  /// As the user named it.
  std::string Text;
  bool Enabled = true;
  /// Deleted when it stops.
  bool Temporary = false;
  /// The instructions; empty for a watchpoint.
  std::vector<CodeLocation> Locations;
  /// The memory; none for a breakpoint.
  std::optional<WatchTarget> Watched;
  bool Reads = false;
  bool Writes = false;
  /// Only this thread.
  std::optional<uint32_t> Thread;
  /// Null: none.
  std::shared_ptr<const Expression> Condition;
  /// So many more hits do not stop.
  uint64_t Ignore = 0;
  uint64_t Hits = 0;
  /// If set, called at each hit that would stop, with the thread that did, the
  /// program being there: false lets it go on.
  std::function<bool(uint32_t Thread)> ShouldStop;
  /// What the command line executes after it has stopped.
  std::vector<std::string> Commands;

  bool isWatchpoint() const { return Watched.has_value(); }
};

/// The breakpoints and watchpoints of a session.
class BreakpointTable {
public:
  /// Gives it a number.
  Breakpoint &add(Breakpoint New);
  /// False if there is none.
  bool remove(unsigned Number);
  void clear() { All.clear(); }
  /// The program begins anew: no hits, and no watchpoints on variables of a
  /// function that ran.
  void forgetRun();
  Breakpoint *find(unsigned Number);
  std::vector<std::unique_ptr<Breakpoint>> &all() { return All; }
  llvm::ArrayRef<std::unique_ptr<Breakpoint>> all() const { return All; }

private:
  std::vector<std::unique_ptr<Breakpoint>> All;
  unsigned Last = 0;
};

} // namespace tp

#endif // TP_DEBUGGER_SESSION_BREAKPOINTS_H
