//===- StackRequests.h - Requests about threads and frames ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_STACKREQUESTS_H
#define TP_DEBUGGER_DAP_STACKREQUESTS_H

#include "debugger/dap/Debuggee.h"

namespace tp::dap {

/// Without a wish of the user's, so many threads are listed one by one.
inline constexpr uint32_t MaxListedThreads = 64;

/// Answers threads, stackTrace, scopes, exceptionInfo, source, loadedSources
/// and modules.
class StackRequests {
public:
  explicit StackRequests(Debuggee &Target) : Target(Target) {}

  void addTo(Dispatcher &Requests);

private:
  Debuggee &Target;

  Response threads(const NoArguments &);
  Response stackTrace(const StackTraceArguments &Arguments);
  Response scopes(const ScopesArguments &Arguments);
  Response exceptionInfo(const ThreadArguments &Arguments);
  Response source(const SourceRequestArguments &Arguments);
  Response loadedSources(const NoArguments &);
  Response modules(const NoArguments &);

  llvm::json::Array groupedThreads();
  llvm::json::Object describeFrame(const Frame &Of, FramePlace Place);
};

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_STACKREQUESTS_H
