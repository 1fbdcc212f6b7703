//===- Debuggee.h - What all requests are about -----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_DEBUGGEE_H
#define TP_DEBUGGER_DAP_DEBUGGEE_H

#include "debugger/dap/Channel.h"
#include "debugger/dap/Dispatcher.h"
#include "debugger/dap/LaunchRequest.h"
#include "debugger/dap/ProgramVariables.h"
#include "debugger/dap/RunProgress.h"
#include "debugger/dap/StopReason.h"
#include "debugger/dap/VariableStore.h"
#include "debugger/session/Session.h"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace tp::dap {

/// A thread's number for the client, which takes 0 for none.
inline int64_t threadId(uint32_t Thread) { return int64_t(Thread) + 1; }

/// The program that is debugged and what the client knows of it: what those
/// that answer requests share.
class Debuggee {
public:
  explicit Debuggee(Channel &Out) : Out(Out) {}

  Channel &Out;
  InitializeArguments Client;
  LaunchRequest Configuration;
  /// Null before the launch and after the end.
  std::unique_ptr<Session> Program;
  bool WasLaunched = false;
  VariableStore Store;
  /// Of the breakpoints that the client has set.
  BreakpointWords Words;
  /// How the program has come where it stands.
  std::optional<SessionStop> LastStop;
  bool IsRunning = false;
  /// Of the last run: log points and counts of hits are for runs forward.
  Direction Towards = Direction::Forward;
  /// Called now and then while the program runs.
  ProgressFunction OnProgress;
  RunProgress Running{Out};
  /// The client has gone, or is to go.
  bool IsEnded = false;

  Stage stage() const;

  /// Does \p Action when the current request has been answered.
  void afterResponse(std::function<void()> Action) {
    Later.push_back(std::move(Action));
  }
  /// Does what afterResponse() has collected.
  void runLater();

  /// The thread of a client's number.
  llvm::Expected<uint32_t> thread(int64_t Id) const;
  /// A thread's stack, kept as long as the program stands.
  const Backtrace &backtrace(uint32_t Thread);
  /// The frame of a client's number. Without one that of the last stop's
  /// thread.
  llvm::Expected<FramePlace> place(std::optional<int64_t> FrameId);
  /// Where names are looked up in a frame.
  llvm::Expected<std::shared_ptr<const SourceScope>> scope(FramePlace Place);

  /// An address as the client keeps it.
  std::string memoryReference(uint32_t Address, uint32_t Thread) const;
  /// A row as the protocol has it: what evaluate answers has `result` where
  /// variables have `value`.
  llvm::json::Object describe(const VariableRow &Row, FramePlace Place,
                              llvm::StringLiteral ValueName);
  /// The row of a list by its name.
  llvm::Expected<VariableRow> rowOf(int64_t List, llvm::StringRef Name) const;

  /// What the client has numbered means nothing any more.
  void moved();
  /// Values may be others, though the program stands.
  void changed();
  /// Sends that the program stands, why and where. An end of the run ends the
  /// session unless it is to stand there.
  void report(const SessionStop &Stop);
  /// Sends that the run is over.
  void end(int ExitStatus);

private:
  std::vector<std::function<void()>> Later;
  std::map<uint32_t, Backtrace> Stacks;
};

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_DEBUGGEE_H
