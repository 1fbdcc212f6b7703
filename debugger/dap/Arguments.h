//===- Arguments.h - Arguments of the protocol's requests -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Named as in the protocol's specification, which explains them; only what the
// adapter uses.
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_ARGUMENTS_H
#define TP_DEBUGGER_DAP_ARGUMENTS_H

#include "llvm/Support/Error.h"
#include "llvm/Support/JSON.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tp::dap {

struct NoArguments {};

struct InitializeArguments {
  bool LinesStartAt1 = true;
  bool ColumnsStartAt1 = true;
  bool SupportsMemoryEvent = false;
  bool SupportsInvalidatedEvent = false;
  bool SupportsProgressReporting = false;

  /// A line of the client's, counted from 1.
  uint32_t line(int64_t Clients) const {
    return uint32_t(std::max<int64_t>(Clients + !LinesStartAt1, 0));
  }
  /// Likewise a column.
  uint32_t column(int64_t Clients) const {
    return uint32_t(std::max<int64_t>(Clients + !ColumnsStartAt1, 0));
  }
  int64_t lineForClient(uint32_t Line) const {
    return int64_t(Line) - !LinesStartAt1;
  }
  int64_t columnForClient(uint32_t Column) const {
    return std::max<int64_t>(Column, 1) - !ColumnsStartAt1;
  }
};

struct SourceArgument {
  std::optional<std::string> Path;
  int64_t SourceReference = 0;
};

/// Of any kind of breakpoint; each kind uses some of them.
struct BreakpointArgument {
  int64_t Line = 0;
  std::string Name;
  std::string InstructionReference;
  int64_t Offset = 0;
  std::string DataId;
  std::string AccessType;
  std::string Condition;
  std::string HitCondition;
  std::string LogMessage;
};

struct SetBreakpointsArguments {
  SourceArgument Source;
  std::vector<BreakpointArgument> Breakpoints;
};

/// Of setFunctionBreakpoints, setInstructionBreakpoints and
/// setDataBreakpoints.
struct BreakpointListArguments {
  std::vector<BreakpointArgument> Breakpoints;
};

struct SetExceptionBreakpointsArguments {
  std::vector<std::string> Filters;
};

struct BreakpointLocationsArguments {
  SourceArgument Source;
  int64_t Line = 0;
  std::optional<int64_t> EndLine;
};

struct DataBreakpointInfoArguments {
  std::optional<int64_t> VariablesReference;
  std::optional<int64_t> FrameId;
  std::string Name;
  std::optional<int64_t> Bytes;
  bool AsAddress = false;
};

/// Of continue, the steps, pause and exceptionInfo.
struct ThreadArguments {
  int64_t ThreadId = 0;
  std::string Granularity = "statement";
};

struct StackTraceArguments {
  int64_t ThreadId = 0;
  int64_t StartFrame = 0;
  /// 0: all.
  int64_t Levels = 0;
};

struct ScopesArguments {
  int64_t FrameId = 0;
};

struct VariablesArguments {
  int64_t VariablesReference = 0;
  /// "indexed", "named" or empty for both.
  std::string Filter;
  int64_t Start = 0;
  /// 0: all.
  int64_t Count = 0;
  bool Hex = false;
};

struct SetVariableArguments {
  int64_t VariablesReference = 0;
  std::string Name;
  std::string Value;
};

struct EvaluateArguments {
  std::string Expression;
  std::optional<int64_t> FrameId;
  std::string Context;
  bool Hex = false;
};

struct SetExpressionArguments {
  std::string Expression;
  std::string Value;
  std::optional<int64_t> FrameId;
};

struct SourceRequestArguments {
  SourceArgument Source;
  int64_t SourceReference = 0;
};

struct GotoTargetsArguments {
  SourceArgument Source;
  int64_t Line = 0;
};

struct GotoArguments {
  int64_t ThreadId = 0;
  int64_t TargetId = 0;
};

struct CompletionsArguments {
  std::string Text;
  int64_t Column = 0;
};

struct DisassembleArguments {
  std::string MemoryReference;
  int64_t Offset = 0;
  int64_t InstructionOffset = 0;
  int64_t InstructionCount = 0;
};

struct ReadMemoryArguments {
  std::string MemoryReference;
  int64_t Offset = 0;
  int64_t Count = 0;
};

struct WriteMemoryArguments {
  std::string MemoryReference;
  int64_t Offset = 0;
  bool AllowPartial = false;
  std::string Data;
};

bool fromJSON(const llvm::json::Value &, NoArguments &, llvm::json::Path);
bool fromJSON(const llvm::json::Value &, InitializeArguments &,
              llvm::json::Path);
bool fromJSON(const llvm::json::Value &, SourceArgument &, llvm::json::Path);
bool fromJSON(const llvm::json::Value &, BreakpointArgument &,
              llvm::json::Path);
bool fromJSON(const llvm::json::Value &, SetBreakpointsArguments &,
              llvm::json::Path);
bool fromJSON(const llvm::json::Value &, BreakpointListArguments &,
              llvm::json::Path);
bool fromJSON(const llvm::json::Value &, SetExceptionBreakpointsArguments &,
              llvm::json::Path);
bool fromJSON(const llvm::json::Value &, BreakpointLocationsArguments &,
              llvm::json::Path);
bool fromJSON(const llvm::json::Value &, DataBreakpointInfoArguments &,
              llvm::json::Path);
bool fromJSON(const llvm::json::Value &, ThreadArguments &, llvm::json::Path);
bool fromJSON(const llvm::json::Value &, StackTraceArguments &,
              llvm::json::Path);
bool fromJSON(const llvm::json::Value &, ScopesArguments &, llvm::json::Path);
bool fromJSON(const llvm::json::Value &, VariablesArguments &,
              llvm::json::Path);
bool fromJSON(const llvm::json::Value &, SetVariableArguments &,
              llvm::json::Path);
bool fromJSON(const llvm::json::Value &, EvaluateArguments &, llvm::json::Path);
bool fromJSON(const llvm::json::Value &, SetExpressionArguments &,
              llvm::json::Path);
bool fromJSON(const llvm::json::Value &, SourceRequestArguments &,
              llvm::json::Path);
bool fromJSON(const llvm::json::Value &, GotoTargetsArguments &,
              llvm::json::Path);
bool fromJSON(const llvm::json::Value &, GotoArguments &, llvm::json::Path);
bool fromJSON(const llvm::json::Value &, CompletionsArguments &,
              llvm::json::Path);
bool fromJSON(const llvm::json::Value &, DisassembleArguments &,
              llvm::json::Path);
bool fromJSON(const llvm::json::Value &, ReadMemoryArguments &,
              llvm::json::Path);
bool fromJSON(const llvm::json::Value &, WriteMemoryArguments &,
              llvm::json::Path);

/// The arguments of a request. The error names the one that is wrong.
template <typename ArgumentsType>
llvm::Expected<ArgumentsType> readArguments(const llvm::json::Value &Value) {
  ArgumentsType Result;
  llvm::json::Path::Root Root("arguments");
  if (fromJSON(Value, Result, Root))
    return Result;
  return Root.getError();
}

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_ARGUMENTS_H
