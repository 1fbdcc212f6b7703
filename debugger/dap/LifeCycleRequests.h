//===- LifeCycleRequests.h - From initialize to disconnect ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_LIFECYCLEREQUESTS_H
#define TP_DEBUGGER_DAP_LIFECYCLEREQUESTS_H

#include "debugger/dap/ConsoleRequests.h"
#include "debugger/dap/Debuggee.h"
#include "debugger/dap/ExecutionRequests.h"

namespace tp::dap {

/// Answers initialize, launch, attach, configurationDone, terminate,
/// disconnect and cancel.
class LifeCycleRequests {
public:
  LifeCycleRequests(Debuggee &Target, ExecutionRequests &Execution,
                    ConsoleRequests &Console, llvm::StringRef ChipFolder)
      : Target(Target), Execution(Execution), Console(Console),
        ChipFolder(ChipFolder) {}

  void addTo(Dispatcher &Requests);

private:
  Debuggee &Target;
  ExecutionRequests &Execution;
  ConsoleRequests &Console;
  std::string ChipFolder;

  Response initialize(const InitializeArguments &Arguments);
  Response launch(const llvm::json::Value &Arguments);
  Response attach(const NoArguments &);
  Response configurationDone(const NoArguments &);
  Response terminate(const NoArguments &);
  Response disconnect(const NoArguments &);
  Response cancel(const NoArguments &);

  llvm::Error load(const LaunchRequest &Wish);
  void tellWarnings();
};

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_LIFECYCLEREQUESTS_H
