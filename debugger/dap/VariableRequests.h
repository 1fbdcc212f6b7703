//===- VariableRequests.h - Requests about values ---------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_VARIABLEREQUESTS_H
#define TP_DEBUGGER_DAP_VARIABLEREQUESTS_H

#include "debugger/dap/Debuggee.h"

namespace tp::dap {

/// Answers variables, setVariable, setExpression and evaluate, except for the
/// console's commands.
class VariableRequests {
public:
  explicit VariableRequests(Debuggee &Target) : Target(Target) {}

  void addTo(Dispatcher &Requests);

  /// The value of an expression for a hover, a watch or the clipboard.
  Response evaluate(const EvaluateArguments &Arguments);

private:
  Debuggee &Target;

  Response variables(const VariablesArguments &Arguments);
  Response setVariable(const SetVariableArguments &Arguments);
  Response setExpression(const SetExpressionArguments &Arguments);
  Response assign(FramePlace Place, llvm::StringRef Name,
                  llvm::StringRef NewValue);
};

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_VARIABLEREQUESTS_H
