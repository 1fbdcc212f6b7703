//===- RunProgress.h - Tells a client how far a run is ----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_RUNPROGRESS_H
#define TP_DEBUGGER_DAP_RUNPROGRESS_H

#include "debugger/dap/Channel.h"
#include "simulator/core/Engine.h"

#include <chrono>
#include <string>

namespace tp::dap {

/// Progress events of a run that takes longer than a second, to a client that
/// knows them.
class RunProgress {
public:
  explicit RunProgress(Channel &Out) : Out(Out) {}

  /// \p IsWanted: the client shows progress.
  void begin(llvm::StringRef Title, bool IsWanted);
  void update(const Progress &Now);
  void end();

private:
  using Clock = std::chrono::steady_clock;

  Channel &Out;
  std::string Title;
  bool IsWanted = false;
  bool IsShown = false;
  /// Of the last event.
  Clock::time_point Told;
  unsigned Number = 0;

  llvm::json::Object body() const;
};

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_RUNPROGRESS_H
