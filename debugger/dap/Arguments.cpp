//===- Arguments.cpp - Arguments of the protocol's requests ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/Arguments.h"

using namespace llvm;

namespace tp::dap {

bool fromJSON(const json::Value &, NoArguments &, json::Path) { return true; }

/// Whether numbers are wanted in hexadecimal.
static bool mapFormat(const json::Value &Value, bool &Hex, json::Path Path) {
  const json::Value *Format = Value.getAsObject()->get("format");
  if (!Format)
    return true;
  json::ObjectMapper Mapper(*Format, Path.field("format"));
  return Mapper && Mapper.mapOptional("hex", Hex);
}

bool fromJSON(const json::Value &Value, SetBreakpointsArguments &Result,
              json::Path Path) {
  json::ObjectMapper Mapper(Value, Path);
  if (!Mapper || !Mapper.map("source", Result.Source) ||
      !Mapper.mapOptional("breakpoints", Result.Breakpoints))
    return false;
  if (Value.getAsObject()->get("breakpoints"))
    return true;
  std::vector<int64_t> Lines;
  if (!Mapper.mapOptional("lines", Lines))
    return false;
  for (int64_t Line : Lines)
    Result.Breakpoints.emplace_back().Line = Line;
  return true;
}

bool fromJSON(const json::Value &Value, InitializeArguments &Result,
              json::Path Path) {
  json::ObjectMapper Mapper(Value, Path);
  return Mapper && Mapper.mapOptional("linesStartAt1", Result.LinesStartAt1) &&
         Mapper.mapOptional("columnsStartAt1", Result.ColumnsStartAt1) &&
         Mapper.mapOptional("supportsMemoryEvent",
                            Result.SupportsMemoryEvent) &&
         Mapper.mapOptional("supportsInvalidatedEvent",
                            Result.SupportsInvalidatedEvent) &&
         Mapper.mapOptional("supportsProgressReporting",
                            Result.SupportsProgressReporting);
}

bool fromJSON(const json::Value &Value, SourceArgument &Result,
              json::Path Path) {
  json::ObjectMapper Mapper(Value, Path);
  return Mapper && Mapper.map("path", Result.Path) &&
         Mapper.mapOptional("sourceReference", Result.SourceReference);
}

bool fromJSON(const json::Value &Value, BreakpointArgument &Result,
              json::Path Path) {
  json::ObjectMapper Mapper(Value, Path);
  return Mapper && Mapper.mapOptional("line", Result.Line) &&
         Mapper.mapOptional("name", Result.Name) &&
         Mapper.mapOptional("instructionReference",
                            Result.InstructionReference) &&
         Mapper.mapOptional("offset", Result.Offset) &&
         Mapper.mapOptional("dataId", Result.DataId) &&
         Mapper.mapOptional("accessType", Result.AccessType) &&
         Mapper.mapOptional("condition", Result.Condition) &&
         Mapper.mapOptional("hitCondition", Result.HitCondition) &&
         Mapper.mapOptional("logMessage", Result.LogMessage);
}

bool fromJSON(const json::Value &Value, BreakpointListArguments &Result,
              json::Path Path) {
  json::ObjectMapper Mapper(Value, Path);
  return Mapper && Mapper.map("breakpoints", Result.Breakpoints);
}

bool fromJSON(const json::Value &Value,
              SetExceptionBreakpointsArguments &Result, json::Path Path) {
  json::ObjectMapper Mapper(Value, Path);
  return Mapper && Mapper.map("filters", Result.Filters);
}

bool fromJSON(const json::Value &Value, BreakpointLocationsArguments &Result,
              json::Path Path) {
  json::ObjectMapper Mapper(Value, Path);
  return Mapper && Mapper.map("source", Result.Source) &&
         Mapper.map("line", Result.Line) &&
         Mapper.map("endLine", Result.EndLine);
}

bool fromJSON(const json::Value &Value, DataBreakpointInfoArguments &Result,
              json::Path Path) {
  json::ObjectMapper Mapper(Value, Path);
  return Mapper &&
         Mapper.map("variablesReference", Result.VariablesReference) &&
         Mapper.map("frameId", Result.FrameId) &&
         Mapper.map("name", Result.Name) && Mapper.map("bytes", Result.Bytes) &&
         Mapper.mapOptional("asAddress", Result.AsAddress);
}

bool fromJSON(const json::Value &Value, ThreadArguments &Result,
              json::Path Path) {
  json::ObjectMapper Mapper(Value, Path);
  return Mapper && Mapper.map("threadId", Result.ThreadId) &&
         Mapper.mapOptional("granularity", Result.Granularity);
}

bool fromJSON(const json::Value &Value, StackTraceArguments &Result,
              json::Path Path) {
  json::ObjectMapper Mapper(Value, Path);
  return Mapper && Mapper.map("threadId", Result.ThreadId) &&
         Mapper.mapOptional("startFrame", Result.StartFrame) &&
         Mapper.mapOptional("levels", Result.Levels);
}

bool fromJSON(const json::Value &Value, ScopesArguments &Result,
              json::Path Path) {
  json::ObjectMapper Mapper(Value, Path);
  return Mapper && Mapper.map("frameId", Result.FrameId);
}

bool fromJSON(const json::Value &Value, SetVariableArguments &Result,
              json::Path Path) {
  json::ObjectMapper Mapper(Value, Path);
  return Mapper &&
         Mapper.map("variablesReference", Result.VariablesReference) &&
         Mapper.map("name", Result.Name) && Mapper.map("value", Result.Value);
}

bool fromJSON(const json::Value &Value, SetExpressionArguments &Result,
              json::Path Path) {
  json::ObjectMapper Mapper(Value, Path);
  return Mapper && Mapper.map("expression", Result.Expression) &&
         Mapper.map("value", Result.Value) &&
         Mapper.map("frameId", Result.FrameId);
}

bool fromJSON(const json::Value &Value, SourceRequestArguments &Result,
              json::Path Path) {
  json::ObjectMapper Mapper(Value, Path);
  return Mapper && Mapper.mapOptional("source", Result.Source) &&
         Mapper.map("sourceReference", Result.SourceReference);
}

bool fromJSON(const json::Value &Value, GotoTargetsArguments &Result,
              json::Path Path) {
  json::ObjectMapper Mapper(Value, Path);
  return Mapper && Mapper.map("source", Result.Source) &&
         Mapper.map("line", Result.Line);
}

bool fromJSON(const json::Value &Value, GotoArguments &Result,
              json::Path Path) {
  json::ObjectMapper Mapper(Value, Path);
  return Mapper && Mapper.map("threadId", Result.ThreadId) &&
         Mapper.map("targetId", Result.TargetId);
}

bool fromJSON(const json::Value &Value, CompletionsArguments &Result,
              json::Path Path) {
  json::ObjectMapper Mapper(Value, Path);
  return Mapper && Mapper.map("text", Result.Text) &&
         Mapper.map("column", Result.Column);
}

bool fromJSON(const json::Value &Value, DisassembleArguments &Result,
              json::Path Path) {
  json::ObjectMapper Mapper(Value, Path);
  return Mapper && Mapper.map("memoryReference", Result.MemoryReference) &&
         Mapper.mapOptional("offset", Result.Offset) &&
         Mapper.mapOptional("instructionOffset", Result.InstructionOffset) &&
         Mapper.map("instructionCount", Result.InstructionCount);
}

bool fromJSON(const json::Value &Value, ReadMemoryArguments &Result,
              json::Path Path) {
  json::ObjectMapper Mapper(Value, Path);
  return Mapper && Mapper.map("memoryReference", Result.MemoryReference) &&
         Mapper.mapOptional("offset", Result.Offset) &&
         Mapper.map("count", Result.Count);
}

bool fromJSON(const json::Value &Value, WriteMemoryArguments &Result,
              json::Path Path) {
  json::ObjectMapper Mapper(Value, Path);
  return Mapper && Mapper.map("memoryReference", Result.MemoryReference) &&
         Mapper.mapOptional("offset", Result.Offset) &&
         Mapper.mapOptional("allowPartial", Result.AllowPartial) &&
         Mapper.map("data", Result.Data);
}

bool fromJSON(const json::Value &Value, VariablesArguments &Result,
              json::Path Path) {
  json::ObjectMapper Mapper(Value, Path);
  return Mapper &&
         Mapper.map("variablesReference", Result.VariablesReference) &&
         Mapper.mapOptional("filter", Result.Filter) &&
         Mapper.mapOptional("start", Result.Start) &&
         Mapper.mapOptional("count", Result.Count) &&
         mapFormat(Value, Result.Hex, Path);
}

bool fromJSON(const json::Value &Value, EvaluateArguments &Result,
              json::Path Path) {
  json::ObjectMapper Mapper(Value, Path);
  return Mapper && Mapper.map("expression", Result.Expression) &&
         Mapper.map("frameId", Result.FrameId) &&
         Mapper.mapOptional("context", Result.Context) &&
         mapFormat(Value, Result.Hex, Path);
}

} // namespace tp::dap
