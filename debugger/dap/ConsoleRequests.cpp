//===- ConsoleRequests.cpp - The debugger's commands in an editor ---------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/ConsoleRequests.h"

#include "llvm/ADT/StringExtras.h"

using namespace llvm;

namespace tp::dap {

void ConsoleRequests::addTo(Dispatcher &Requests) {
  using Self = ConsoleRequests;
  Requests.on("evaluate", Stage::Stopped, this, &Self::evaluate);
  Requests.on("completions", Stage::Stopped, this, &Self::completions);
}

void ConsoleRequests::connect() {
  Commands = std::make_unique<CommandLine>(*Target.Program, OS);
}

Response ConsoleRequests::evaluate(const EvaluateArguments &Arguments) {
  if (Arguments.Context == "repl")
    return execute(Arguments);
  return Values.evaluate(Arguments);
}

Response ConsoleRequests::execute(const EvaluateArguments &Arguments) {
  Expected<FramePlace> Place = Target.place(Arguments.FrameId);
  if (!Place)
    return Place.takeError();
  if (Arguments.FrameId || Target.LastStop)
    Commands->select(Place->Thread, Place->Level);
  Text.clear();
  Target.Towards = Direction::Forward;
  Run.begin(*Target.Program, ActiveRun::Interest::Ending);
  CommandResult Result = Commands->execute(Arguments.Expression);
  Run.end();
  Target.afterResponse([this, Result] { follow(Result); });
  if (Result.Failed)
    return createStringError(StringRef(Text).rtrim());
  return json::Object{{"result", json::fixUTF8(Text)},
                      {"variablesReference", 0}};
}

/// Tells the client what a command has changed.
void ConsoleRequests::follow(const CommandResult &Result) {
  if (Result.Quit)
    Target.end(*Result.Quit);
  else if (Result.Stop)
    Target.report(*Result.Stop);
  else if (Result.HasChanged)
    Target.changed();
}

Response ConsoleRequests::completions(const CompletionsArguments &Arguments) {
  size_t Cursor = Target.Client.column(Arguments.Column);
  Cursor = std::min(Cursor == 0 ? 0 : Cursor - 1, Arguments.Text.size());
  size_t Begin = Cursor;
  while (Begin > 0 && !isSpace(Arguments.Text[Begin - 1]))
    --Begin;
  json::Array Targets;
  for (const std::string &Word : Commands->completions(Arguments.Text, Cursor))
    Targets.push_back(json::Object{{"label", json::fixUTF8(Word)},
                                   {"start", int64_t(Begin)},
                                   {"length", int64_t(Cursor - Begin)}});
  return json::Object{{"targets", std::move(Targets)}};
}

} // namespace tp::dap
