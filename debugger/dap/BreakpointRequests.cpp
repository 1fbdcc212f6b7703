//===- BreakpointRequests.cpp - Requests that set breakpoints -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/BreakpointRequests.h"

#include "debugger/dap/ClientSources.h"
#include "debugger/dap/HitCondition.h"
#include "debugger/dap/LogMessage.h"
#include "debugger/dap/MemoryReference.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/Path.h"

#include <set>

using namespace llvm;

namespace tp::dap {

void BreakpointRequests::addTo(Dispatcher &Requests) {
  using Self = BreakpointRequests;
  Requests.on("setBreakpoints", Stage::Launched, this, &Self::setLines);
  Requests.on("setFunctionBreakpoints", Stage::Launched, this,
              &Self::setFunctions);
  Requests.on("setInstructionBreakpoints", Stage::Launched, this,
              &Self::setInstructions);
  Requests.on("setDataBreakpoints", Stage::Launched, this, &Self::setData);
  Requests.on("setExceptionBreakpoints", Stage::Launched, this,
              &Self::setExceptions);
  Requests.on("breakpointLocations", Stage::Launched, this, &Self::locations);
  Requests.on("dataBreakpointInfo", Stage::Stopped, this, &Self::dataInfo);
}

Response
BreakpointRequests::setLines(const SetBreakpointsArguments &Arguments) {
  DebugInformation &Information = Target.Program->information();
  Expected<SourceFileId> File =
      ClientSources(Information.files()).find(Arguments.Source);
  std::string Problem = File ? "" : toString(File.takeError());
  std::string Set = "line:" + Arguments.Source.Path.value_or("");
  return replace(
      Set, "breakpoint", Arguments.Breakpoints,
      [&](const BreakpointArgument &Wish) -> Expected<tp::Breakpoint *> {
        if (!Problem.empty())
          return createStringError(Problem);
        uint32_t Line = Target.Client.line(Wish.Line);
        tp::Breakpoint New;
        for (const LineStop &Stop : Information.map().stopsAtLine(*File, Line))
          New.Locations.push_back({Stop.Address, Stop.Position, std::nullopt});
        if (New.Locations.empty())
          return createStringError("there is no code at line " + Twine(Line) +
                                   " or behind it");
        New.Text = Information.files().shortName({*File, Line, 0});
        return &Target.Program->breakpoints().add(std::move(New));
      });
}

Response
BreakpointRequests::setFunctions(const BreakpointListArguments &Arguments) {
  return replace("function", "function breakpoint", Arguments.Breakpoints,
                 [&](const BreakpointArgument &Wish) {
                   return Target.Program->addBreakpoint(Wish.Name, {});
                 });
}

Response
BreakpointRequests::setInstructions(const BreakpointListArguments &Arguments) {
  const Segment &Text = Target.Program->program().text();
  return replace(
      "instruction", "instruction breakpoint", Arguments.Breakpoints,
      [&](const BreakpointArgument &Wish) -> Expected<tp::Breakpoint *> {
        Expected<MemoryReference> Reference =
            parseMemoryReference(Wish.InstructionReference);
        if (!Reference)
          return Reference.takeError();
        Expected<uint32_t> Address =
            addressPlus(Reference->Address, Wish.Offset);
        if (!Address)
          return Address.takeError();
        if (*Address % 4 != 0 || *Address < Text.Address ||
            *Address >= Text.end())
          return createStringError("there is no instruction at " +
                                   addressText(*Address));
        return Target.Program->addBreakpoint("*" + addressText(*Address), {});
      });
}

Response BreakpointRequests::setData(const BreakpointListArguments &Arguments) {
  return replace("data", "data breakpoint", Arguments.Breakpoints,
                 [&](const BreakpointArgument &Wish) { return addData(Wish); });
}

/// Traps always stop the program: there is nothing to choose.
Response
BreakpointRequests::setExceptions(const SetExceptionBreakpointsArguments &) {
  return json::Object();
}

Expected<tp::Breakpoint *>
BreakpointRequests::addData(const BreakpointArgument &Wish) {
  size_t Index;
  if (StringRef(Wish.DataId).getAsInteger(10, Index) ||
      Index >= Candidates.size())
    return createStringError("there is no data '" + Wish.DataId +
                             "' to watch; ask for it again");
  const WatchCandidate &Data = Candidates[Index];
  bool Reads = StringRef(Wish.AccessType).starts_with("read");
  bool Writes = Wish.AccessType != "read";
  Session &Program = *Target.Program;
  if (Data.Expression.empty())
    return Program.addWatchpoint(Data.Address, Data.Bytes, Data.Thread, Reads,
                                 Writes);
  return Program.addWatchpoint(Data.Expression, Data.Thread, Data.Frame, Reads,
                               Writes, /*IsLocation=*/false);
}

/// Whether the client wants the same breakpoint as before.
static bool isSame(const BreakpointArgument &A, const BreakpointArgument &B) {
  auto Fields = [](const BreakpointArgument &Of) {
    return std::tie(Of.Line, Of.Name, Of.InstructionReference, Of.Offset,
                    Of.DataId, Of.AccessType, Of.Condition, Of.HitCondition,
                    Of.LogMessage);
  };
  return Fields(A) == Fields(B);
}

json::Object BreakpointRequests::replace(const std::string &Set,
                                         StringLiteral Word,
                                         ArrayRef<BreakpointArgument> Wishes,
                                         AddFunction Add) {
  std::vector<Kept> Before = std::move(Sets[Set]);
  std::vector<Kept> Now;
  json::Array Answers;
  for (const BreakpointArgument &Wish : Wishes) {
    auto Known = find_if(Before, [&](const Kept &Each) {
      return Target.Program->breakpoints().find(Each.Number) &&
             isSame(Each.Wish, Wish);
    });
    if (Known == Before.end()) {
      Now.push_back(make(Wish, Word, Add));
    } else {
      Now.push_back(std::move(*Known));
      Before.erase(Known);
    }
    Answers.push_back(json::Object(Now.back().Answer));
  }
  for (const Kept &Old : Before) {
    Target.Program->breakpoints().remove(Old.Number);
    Target.Words.erase(Old.Number);
  }
  Sets[Set] = std::move(Now);
  return json::Object{{"breakpoints", std::move(Answers)}};
}

BreakpointRequests::Kept
BreakpointRequests::make(const BreakpointArgument &Wish, StringLiteral Word,
                         AddFunction Add) {
  Kept Result;
  Result.Wish = Wish;
  Expected<tp::Breakpoint *> Made =
      Target.Configuration.NoDebug
          ? createStringError("the program runs without debugging")
          : Add(Wish);
  llvm::Error Problem = Made ? refine(**Made, Wish) : Made.takeError();
  if (!Problem) {
    Result.Number = (*Made)->Number;
    Result.Answer = describe(**Made);
    Target.Words.emplace(Result.Number, Word);
    return Result;
  }
  if (Made)
    Target.Program->breakpoints().remove((*Made)->Number);
  Result.Answer =
      json::Object{{"verified", false},
                   {"reason", "failed"},
                   {"message", json::fixUTF8(toString(std::move(Problem)))}};
  return Result;
}

/// Gives a new breakpoint its condition, count and message.
llvm::Error BreakpointRequests::refine(tp::Breakpoint &New,
                                       const BreakpointArgument &Wish) {
  Session &Program = *Target.Program;
  if (!Wish.Condition.empty())
    if (llvm::Error Problem = Program.setCondition(New, Wish.Condition))
      return Problem;
  HitCondition Stops;
  if (!Wish.HitCondition.empty()) {
    Expected<HitCondition> Parsed = HitCondition::parse(Wish.HitCondition);
    if (!Parsed)
      return Parsed.takeError();
    Stops = *Parsed;
  }
  std::shared_ptr<LogMessage> Message;
  if (!Wish.LogMessage.empty()) {
    Expected<LogMessage> Parsed =
        LogMessage::parse(Wish.LogMessage, Program.information());
    if (!Parsed)
      return Parsed.takeError();
    Message = std::make_shared<LogMessage>(std::move(*Parsed));
  }
  if (Wish.HitCondition.empty() && !Message)
    return llvm::Error::success();
  New.ShouldStop = [this, Stops, Message,
                    Hits = uint64_t(0)](uint32_t Thread) mutable {
    if (Target.Towards == Direction::Backward)
      return !Message;
    if (!Stops.accepts(++Hits))
      return false;
    if (!Message)
      return true;
    Backtrace Stack = Target.Program->backtrace(Thread, 1);
    Target.Out.output("console",
                      Message->render(Stack.Frames.front().Context) + "\n");
    return false;
  };
  return llvm::Error::success();
}

json::Object BreakpointRequests::describe(const tp::Breakpoint &Made) {
  json::Object Answer{{"id", Made.Number}, {"verified", true}};
  if (Made.Locations.empty())
    return Answer;
  const CodeLocation &First = Made.Locations.front();
  Answer["instructionReference"] = addressText(First.Address);
  if (!First.Position.isKnown())
    return Answer;
  Answer["line"] = Target.Client.lineForClient(First.Position.Line);
  ClientSources Sources(Target.Program->information().files());
  Answer["source"] = Sources.describe(First.Position.File);
  return Answer;
}

Response
BreakpointRequests::locations(const BreakpointLocationsArguments &Arguments) {
  DebugInformation &Information = Target.Program->information();
  Expected<SourceFileId> File =
      ClientSources(Information.files()).find(Arguments.Source);
  if (!File)
    return File.takeError();
  uint32_t Begin = Target.Client.line(Arguments.Line);
  uint32_t End = Target.Client.line(Arguments.EndLine.value_or(Arguments.Line));
  std::set<uint32_t> Lines;
  for (const LineRange &Range : Information.map().lines())
    if (Range.IsStatement && Range.Position.File == *File &&
        Range.Position.Line >= Begin && Range.Position.Line <= End)
      Lines.insert(Range.Position.Line);
  json::Array Places;
  for (uint32_t Line : Lines)
    Places.push_back(json::Object{{"line", Target.Client.lineForClient(Line)}});
  return json::Object{{"breakpoints", std::move(Places)}};
}

/// The answer to dataBreakpointInfo for what cannot be watched.
static json::Object notWatchable(llvm::Error Problem) {
  return json::Object{
      {"dataId", nullptr},
      {"description", json::fixUTF8(toString(std::move(Problem)))}};
}

Response BreakpointRequests::candidate(WatchCandidate New,
                                       StringRef Description) {
  Candidates.push_back(std::move(New));
  return json::Object{
      {"dataId", utostr(Candidates.size() - 1)},
      {"description", json::fixUTF8(Description)},
      {"accessTypes", json::Array{"read", "write", "readWrite"}}};
}

Response
BreakpointRequests::dataInfo(const DataBreakpointInfoArguments &Arguments) {
  Expected<FramePlace> Place = Target.place(Arguments.FrameId);
  if (!Place)
    return Place.takeError();
  WatchCandidate New;
  New.Thread = Place->Thread;
  New.Bytes = uint32_t(Arguments.Bytes.value_or(4));
  if (Arguments.AsAddress) {
    Expected<MemoryReference> Reference = parseMemoryReference(Arguments.Name);
    if (!Reference)
      return notWatchable(Reference.takeError());
    New.Address = Reference->Address;
    New.Thread = Reference->Thread.value_or(New.Thread);
    return candidate(std::move(New), addressText(Reference->Address));
  }
  New.Expression = Arguments.Name;
  if (Arguments.VariablesReference) {
    Expected<VariableRow> Row =
        Target.rowOf(*Arguments.VariablesReference, Arguments.Name);
    if (!Row)
      return Row.takeError();
    New.Expression = Row->Expression;
  }
  Expected<std::shared_ptr<const SourceScope>> Scope = Target.scope(*Place);
  if (!Scope)
    return Scope.takeError();
  New.Frame = (*Scope)->Frame;
  Expected<tp::Value> Of =
      evaluateIn(**Scope, New.Expression, Effects::Forbidden);
  if (!Of)
    return notWatchable(Of.takeError());
  if (!Of->address())
    return notWatchable(createStringError(
        "'" + New.Expression + "' is not in memory; it cannot be watched"));
  std::string Description = New.Expression;
  return candidate(std::move(New), Description);
}

} // namespace tp::dap
