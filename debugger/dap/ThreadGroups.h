//===- ThreadGroups.h - Threads by the place they are at --------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_THREADGROUPS_H
#define TP_DEBUGGER_DAP_THREADGROUPS_H

#include "debugger/session/Session.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tp::dap {

/// Threads whose innermost function and line are the same.
struct ThreadGroup {
  /// `work() at threads.cpp:17`.
  std::string Place;
  /// Ascending.
  std::vector<uint32_t> Threads;
};

/// All threads by their places, the groups by their first thread.
std::vector<ThreadGroup> groupThreads(Session &Program);

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_THREADGROUPS_H
