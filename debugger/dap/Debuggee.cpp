//===- Debuggee.cpp - What all requests are about -------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/Debuggee.h"

#include "debugger/dap/MemoryReference.h"

using namespace llvm;

namespace tp::dap {

Stage Debuggee::stage() const {
  if (!Program)
    return Stage::Connected;
  return IsRunning ? Stage::Launched : Stage::Stopped;
}

void Debuggee::runLater() {
  while (!Later.empty()) {
    std::vector<std::function<void()>> Actions = std::move(Later);
    Later.clear();
    for (const std::function<void()> &Action : Actions)
      Action();
  }
}

Expected<uint32_t> Debuggee::thread(int64_t Id) const {
  int64_t Count = Program->replay().threadCount();
  if (Id >= 1 && Id <= Count)
    return uint32_t(Id - 1);
  return createStringError("there is no thread " + Twine(Id) +
                           "; they go from 1 to " + Twine(Count));
}

const Backtrace &Debuggee::backtrace(uint32_t Thread) {
  auto Known = Stacks.find(Thread);
  if (Known == Stacks.end())
    Known = Stacks.emplace(Thread, Program->backtrace(Thread)).first;
  return Known->second;
}

Expected<FramePlace> Debuggee::place(std::optional<int64_t> FrameId) {
  if (FrameId)
    return Store.frame(*FrameId);
  return FramePlace{LastStop ? LastStop->Thread : 0, 0};
}

Expected<std::shared_ptr<const SourceScope>> Debuggee::scope(FramePlace Place) {
  const Backtrace &Stack = backtrace(Place.Thread);
  if (Place.Level >= Stack.Frames.size())
    return createStringError("thread " + Twine(threadId(Place.Thread)) +
                             " has no frame " + Twine(Place.Level));
  return std::make_shared<const SourceScope>(
      SourceScope{&Program->information(), Stack.Frames[Place.Level].Context});
}

std::string Debuggee::memoryReference(uint32_t Address, uint32_t Thread) const {
  MemoryReference Reference{Address, std::nullopt};
  if (Program->isLocal(Address))
    Reference.Thread = Thread;
  return Reference.text();
}

json::Object Debuggee::describe(const VariableRow &Row, FramePlace Place,
                                StringLiteral ValueName) {
  json::Object Result{{ValueName, json::fixUTF8(Row.Value)},
                      {"variablesReference", Store.list(Row.Parts, Place)}};
  if (!Row.Type.empty())
    Result["type"] = json::fixUTF8(Row.Type);
  if (Row.Parts)
    Result[Row.Parts->isIndexed() ? "indexedVariables" : "namedVariables"] =
        Row.Parts->count();
  if (Row.Address)
    Result["memoryReference"] = memoryReference(*Row.Address, Place.Thread);
  if (Row.IsReadOnly)
    Result["presentationHint"] =
        json::Object{{"attributes", json::Array{"readOnly"}}};
  return Result;
}

Expected<VariableRow> Debuggee::rowOf(int64_t List, StringRef Name) const {
  Expected<KeptList> Kept = Store.list(List);
  if (!Kept)
    return Kept.takeError();
  Expected<std::vector<VariableRow>> Rows = Kept->List->rows(0, UINT32_MAX, {});
  if (!Rows)
    return Rows.takeError();
  for (VariableRow &Row : *Rows)
    if (Row.Name == Name)
      return std::move(Row);
  return createStringError("there is no '" + Name + "' in the list");
}

void Debuggee::moved() {
  Store.clear();
  Stacks.clear();
}

void Debuggee::changed() {
  Stacks.clear();
  if (Client.SupportsInvalidatedEvent)
    Out.event("invalidated",
              json::Object{{"areas", json::Array{"stacks", "variables"}}});
}

void Debuggee::report(const SessionStop &Stop) {
  moved();
  IsRunning = false;
  LastStop = Stop;
  if (Stop.Kind == SessionStop::Exited && !Configuration.StopAtEnd) {
    end(Stop.ExitStatus);
    return;
  }
  if (Stop.Kind == SessionStop::Trapped && Configuration.NoDebug) {
    Out.output("important", Stop.TrapInfo->what() + "\n");
    end(1);
    return;
  }
  if (!Stop.Message.empty())
    Out.output("important", Stop.Message + "\n");
  Out.event("stopped", stoppedBody(Stop, *Program, Words));
}

void Debuggee::end(int ExitStatus) {
  moved();
  IsRunning = false;
  Out.event("exited", json::Object{{"exitCode", ExitStatus}});
  Out.event("terminated", json::Object());
  Program.reset();
  LastStop.reset();
}

} // namespace tp::dap
