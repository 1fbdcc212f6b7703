//===- BreakpointRequests.h - Requests that set breakpoints -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_BREAKPOINTREQUESTS_H
#define TP_DEBUGGER_DAP_BREAKPOINTREQUESTS_H

#include "debugger/dap/Debuggee.h"

namespace tp::dap {

/// Answers the requests for breakpoints on lines, functions, instructions and
/// data. Each replaces those of its kind (of its file, for lines); one that was
/// there before stays, with its count of hits.
class BreakpointRequests {
public:
  explicit BreakpointRequests(Debuggee &Target) : Target(Target) {}

  void addTo(Dispatcher &Requests);

private:
  /// A breakpoint that the client has set.
  struct Kept {
    BreakpointArgument Wish;
    unsigned Number = 0;
    llvm::json::Object Answer;
  };
  using AddFunction = llvm::function_ref<llvm::Expected<tp::Breakpoint *>(
      const BreakpointArgument &)>;

  /// Data that the client may watch.
  struct WatchCandidate {
    /// An expression in the frame, or a range of memory.
    std::string Expression;
    FrameContext Frame;
    uint32_t Thread = 0;
    uint32_t Address = 0;
    uint32_t Bytes = 0;
  };

  Debuggee &Target;
  std::map<std::string, std::vector<Kept>> Sets;
  std::vector<WatchCandidate> Candidates;

  Response setLines(const SetBreakpointsArguments &Arguments);
  Response setFunctions(const BreakpointListArguments &Arguments);
  Response setInstructions(const BreakpointListArguments &Arguments);
  Response setData(const BreakpointListArguments &Arguments);
  Response setExceptions(const SetExceptionBreakpointsArguments &Arguments);
  Response locations(const BreakpointLocationsArguments &Arguments);
  Response dataInfo(const DataBreakpointInfoArguments &Arguments);

  llvm::json::Object replace(const std::string &Set, llvm::StringLiteral Word,
                             llvm::ArrayRef<BreakpointArgument> Wishes,
                             AddFunction Add);
  Kept make(const BreakpointArgument &Wish, llvm::StringLiteral Word,
            AddFunction Add);
  llvm::Error refine(tp::Breakpoint &New, const BreakpointArgument &Wish);
  llvm::json::Object describe(const tp::Breakpoint &Made);
  llvm::Expected<tp::Breakpoint *> addData(const BreakpointArgument &Wish);
  Response candidate(WatchCandidate New, llvm::StringRef Description);
};

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_BREAKPOINTREQUESTS_H
