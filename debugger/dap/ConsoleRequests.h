//===- ConsoleRequests.h - The debugger's commands in an editor -*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_CONSOLEREQUESTS_H
#define TP_DEBUGGER_DAP_CONSOLEREQUESTS_H

#include "debugger/cli/CommandLine.h"
#include "debugger/dap/ActiveRun.h"
#include "debugger/dap/Debuggee.h"
#include "debugger/dap/VariableRequests.h"

namespace tp::dap {

/// Answers evaluate and completions: what is typed into the console are
/// tpdbg's commands, everything else is an expression.
class ConsoleRequests {
public:
  ConsoleRequests(Debuggee &Target, ActiveRun &Run, VariableRequests &Values)
      : Target(Target), Run(Run), Values(Values) {}

  void addTo(Dispatcher &Requests);

  /// Begins with a program that has been launched.
  void connect();

private:
  Debuggee &Target;
  ActiveRun &Run;
  VariableRequests &Values;
  std::string Text;
  llvm::raw_string_ostream OS{Text};
  std::unique_ptr<CommandLine> Commands;

  Response evaluate(const EvaluateArguments &Arguments);
  Response completions(const CompletionsArguments &Arguments);
  Response execute(const EvaluateArguments &Arguments);
  void follow(const CommandResult &Result);
};

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_CONSOLEREQUESTS_H
