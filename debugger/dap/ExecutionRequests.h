//===- ExecutionRequests.h - Requests that move the program -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_EXECUTIONREQUESTS_H
#define TP_DEBUGGER_DAP_EXECUTIONREQUESTS_H

#include "debugger/dap/ActiveRun.h"
#include "debugger/dap/Debuggee.h"

namespace tp::dap {

/// Answers continue, the steps, pause, goto and restart.
class ExecutionRequests {
public:
  /// \p HandleWaiting answers the requests that have come meanwhile.
  ExecutionRequests(Debuggee &Target, ActiveRun &Run,
                    std::function<void()> HandleWaiting)
      : Target(Target), Run(Run), HandleWaiting(std::move(HandleWaiting)) {}

  void addTo(Dispatcher &Requests);

  /// The first run of a program that has been launched.
  void start();

private:
  Debuggee &Target;
  ActiveRun &Run;
  std::function<void()> HandleWaiting;
  bool PauseWanted = false;
  unsigned Moves = 0;
  std::vector<uint32_t> GotoAddresses;

  Response continueForward(const ThreadArguments &Arguments);
  Response continueBackward(const ThreadArguments &Arguments);
  Response next(const ThreadArguments &Arguments);
  Response stepIn(const ThreadArguments &Arguments);
  Response stepOut(const ThreadArguments &Arguments);
  Response stepBack(const ThreadArguments &Arguments);
  Response pause(const ThreadArguments &Arguments);
  Response gotoTargets(const GotoTargetsArguments &Arguments);
  Response goTo(const GotoArguments &Arguments);
  Response restart(const NoArguments &);

  Response step(const ThreadArguments &Arguments, bool OverCalls,
                Direction Towards);
  bool isAtEnd() const;
  void resume(Direction Towards);
  void move(ActiveRun::Interest By, const std::function<SessionStop()> &Action);
};

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_EXECUTIONREQUESTS_H
