//===- StackRequests.cpp - Requests about threads and frames --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/StackRequests.h"

#include "debugger/dap/ChipVariables.h"
#include "debugger/dap/ClientSources.h"
#include "debugger/dap/MemoryReference.h"
#include "debugger/dap/RegisterVariables.h"
#include "debugger/dap/ThreadGroups.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/Path.h"

using namespace llvm;

namespace tp::dap {

void StackRequests::addTo(Dispatcher &Requests) {
  using Self = StackRequests;
  Requests.on("threads", Stage::Launched, this, &Self::threads);
  Requests.on("stackTrace", Stage::Stopped, this, &Self::stackTrace);
  Requests.on("scopes", Stage::Stopped, this, &Self::scopes);
  Requests.on("exceptionInfo", Stage::Stopped, this, &Self::exceptionInfo);
  Requests.on("source", Stage::Launched, this, &Self::source);
  Requests.on("loadedSources", Stage::Launched, this, &Self::loadedSources);
  Requests.on("modules", Stage::Launched, this, &Self::modules);
}

Response StackRequests::threads(const NoArguments &) {
  uint32_t Count = Target.Program->replay().threadCount();
  if (Target.Configuration.GroupThreads.value_or(Count > MaxListedThreads))
    return json::Object{{"threads", groupedThreads()}};
  json::Array Threads;
  for (uint32_t Thread = 0; Thread < Count; ++Thread)
    Threads.push_back(
        json::Object{{"id", threadId(Thread)},
                     {"name", threadPlace(Thread, Target.Program->chip())}});
  return json::Object{{"threads", std::move(Threads)}};
}

/// A thread for each place: that of the last stop, or else the first.
json::Array StackRequests::groupedThreads() {
  json::Array Threads;
  for (const ThreadGroup &Group : groupThreads(*Target.Program)) {
    uint32_t Shown = Group.Threads.front();
    if (Target.LastStop && is_contained(Group.Threads, Target.LastStop->Thread))
      Shown = Target.LastStop->Thread;
    std::string Name = threadPlace(Shown, Target.Program->chip());
    if (Group.Threads.size() > 1)
      Name += " and " + utostr(Group.Threads.size() - 1) + " more";
    Threads.push_back(
        json::Object{{"id", threadId(Shown)},
                     {"name", json::fixUTF8(Name + ": " + Group.Place)}});
  }
  return Threads;
}

Response StackRequests::stackTrace(const StackTraceArguments &Arguments) {
  Expected<uint32_t> Thread = Target.thread(Arguments.ThreadId);
  if (!Thread)
    return Thread.takeError();
  const Backtrace &Stack = Target.backtrace(*Thread);
  size_t Total = Stack.Frames.size();
  size_t First = std::clamp<int64_t>(Arguments.StartFrame, 0, int64_t(Total));
  size_t Count = Total - First;
  if (Arguments.Levels > 0)
    Count = std::min<size_t>(Count, size_t(Arguments.Levels));
  json::Array Frames;
  for (size_t Level = First; Level < First + Count; ++Level)
    Frames.push_back(
        describeFrame(Stack.Frames[Level], {*Thread, uint32_t(Level)}));
  if (!Stack.Problem.empty() && First + Count == Total) {
    Frames.push_back(json::Object{
        {"id", Target.Store.frame({*Thread, uint32_t(Total)})},
        {"name", json::fixUTF8("[the stack cannot be followed further: " +
                               Stack.Problem + "]")},
        {"line", 0},
        {"column", 0},
        {"presentationHint", "label"}});
    ++Total;
  }
  return json::Object{{"stackFrames", std::move(Frames)},
                      {"totalFrames", int64_t(Total)}};
}

json::Object StackRequests::describeFrame(const Frame &Of, FramePlace Place) {
  DebugInformation &Information = Target.Program->information();
  const SourceMap &Map = Information.map();
  std::string Name = Of.Function ? Map.function(*Of.Function).Name
                                 : Map.describeAddress(Of.Context.Pc);
  if (Of.Inlined)
    Name += " [inlined]";
  json::Object Result{
      {"id", Target.Store.frame(Place)},
      {"name", json::fixUTF8(Name)},
      {"line", 0},
      {"column", 0},
      {"moduleId", 1},
      {"instructionPointerReference", addressText(Of.Context.Pc)}};
  if (!Of.Position.isKnown()) {
    Result["presentationHint"] = "subtle";
    return Result;
  }
  Result["line"] = Target.Client.lineForClient(Of.Position.Line);
  Result["column"] = Target.Client.columnForClient(Of.Position.Column);
  Result["source"] =
      ClientSources(Information.files()).describe(Of.Position.File);
  return Result;
}

/// The global variables that the program has kept.
static std::vector<VariableInfo> keptGlobals(const Variables &Names,
                                             const FrameContext &Frame) {
  std::vector<VariableInfo> Globals = Names.globals();
  erase_if(Globals, [&](const VariableInfo &Global) {
    Expected<tp::Value> Of = Names.value(Global, Frame);
    if (Of)
      return Of->isOptimizedOut();
    // The row shows the error.
    consumeError(Of.takeError());
    return false;
  });
  return Globals;
}

Response StackRequests::scopes(const ScopesArguments &Arguments) {
  Expected<FramePlace> Place = Target.Store.frame(Arguments.FrameId);
  if (!Place)
    return Place.takeError();
  Expected<std::shared_ptr<const SourceScope>> Scope = Target.scope(*Place);
  if (!Scope)
    return Scope.takeError();
  const Variables &Names = Target.Program->information().variables();
  const FrameContext &Frame = (*Scope)->Frame;
  json::Array Scopes;
  auto Add = [&](StringRef Name, StringRef Hint, bool IsExpensive,
                 std::shared_ptr<VariableList> List) {
    if (List->count() == 0)
      return;
    json::Object Each{{"name", Name},
                      {"namedVariables", List->count()},
                      {"expensive", IsExpensive}};
    if (!Hint.empty())
      Each["presentationHint"] = Hint;
    Each["variablesReference"] = Target.Store.list(std::move(List), *Place);
    Scopes.push_back(std::move(Each));
  };
  Add("Locals", "locals", false,
      std::make_shared<ScopeVariables>(*Scope, Names.locals(Frame)));
  Add("Arguments", "arguments", false,
      std::make_shared<ScopeVariables>(*Scope, Names.arguments(Frame)));
  Add("Globals", "globals", true,
      std::make_shared<ScopeVariables>(*Scope, keptGlobals(Names, Frame)));
  Add("Registers", "registers", true, registerVariables(Frame));
  Add("Chip", "", true, chipVariables(*Target.Program, Place->Thread));
  return json::Object{{"scopes", std::move(Scopes)}};
}

Response StackRequests::exceptionInfo(const ThreadArguments &Arguments) {
  Expected<uint32_t> Thread = Target.thread(Arguments.ThreadId);
  if (!Thread)
    return Thread.takeError();
  const std::optional<SessionStop> &Stop = Target.LastStop;
  if (!Stop || !Stop->TrapInfo || Stop->Thread != *Thread)
    return createStringError("the thread is not at a trap");
  return json::Object{
      {"exceptionId", "trap"},
      {"description", Stop->TrapInfo->what()},
      {"breakMode", "always"},
      {"details", json::Object{{"message", Stop->TrapInfo->what()},
                               {"typeName", "trap"}}}};
}

/// Clients open files by their paths; this serves those that cannot.
Response StackRequests::source(const SourceRequestArguments &Arguments) {
  SourceFiles &Files = Target.Program->information().files();
  Expected<SourceFileId> File = ClientSources(Files).find(Arguments.Source);
  if (!File)
    return File.takeError();
  Expected<ArrayRef<StringRef>> Lines = Files.text(*File);
  if (!Lines)
    return Lines.takeError();
  return json::Object{{"content", json::fixUTF8(join(*Lines, "\n"))}};
}

Response StackRequests::loadedSources(const NoArguments &) {
  SourceFiles &Files = Target.Program->information().files();
  json::Array Sources;
  for (SourceFileId File = 0; File < Files.size(); ++File)
    Sources.push_back(ClientSources(Files).describe(File));
  return json::Object{{"sources", std::move(Sources)}};
}

/// A program is linked into one file.
Response StackRequests::modules(const NoArguments &) {
  const ElfProgram &Program = Target.Program->program();
  bool HasLines = Target.Program->information().map().hasLines();
  json::Object Module{
      {"id", 1},
      {"name", json::fixUTF8(sys::path::filename(Program.path()))},
      {"path", json::fixUTF8(Program.path())},
      {"symbolStatus", HasLines ? "debug information" : "compiled without -g"},
      {"addressRange", addressText(Program.text().Address) + "-" +
                           addressText(uint32_t(Program.text().end()))}};
  return json::Object{{"modules", json::Array{std::move(Module)}},
                      {"totalModules", 1}};
}

} // namespace tp::dap
