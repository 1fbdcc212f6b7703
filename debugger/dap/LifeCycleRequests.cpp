//===- LifeCycleRequests.cpp - From initialize to disconnect --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/LifeCycleRequests.h"

#include "llvm/Support/FileSystem.h"

using namespace llvm;

namespace tp::dap {

void LifeCycleRequests::addTo(Dispatcher &Requests) {
  using Self = LifeCycleRequests;
  Requests.on("initialize", Stage::Connected, this, &Self::initialize);
  Requests.onRaw("launch", Stage::Connected,
                 [this](const json::Value &Given) { return launch(Given); });
  Requests.on("attach", Stage::Connected, this, &Self::attach);
  Requests.on("configurationDone", Stage::Stopped, this,
              &Self::configurationDone);
  Requests.on("terminate", Stage::Connected, this, &Self::terminate);
  Requests.on("disconnect", Stage::Connected, this, &Self::disconnect);
  Requests.on("cancel", Stage::Connected, this, &Self::cancel);
}

Response LifeCycleRequests::initialize(const InitializeArguments &Arguments) {
  Target.Client = Arguments;
  json::Object Capabilities;
  for (StringRef Name : {"supportsConfigurationDoneRequest",
                         "supportsFunctionBreakpoints",
                         "supportsConditionalBreakpoints",
                         "supportsHitConditionalBreakpoints",
                         "supportsLogPoints",
                         "supportsInstructionBreakpoints",
                         "supportsDataBreakpoints",
                         "supportsDataBreakpointBytes",
                         "supportsBreakpointLocationsRequest",
                         "supportsStepBack",
                         "supportsSteppingGranularity",
                         "supportsGotoTargetsRequest",
                         "supportsRestartRequest",
                         "supportsExceptionInfoRequest",
                         "supportsEvaluateForHovers",
                         "supportsSetVariable",
                         "supportsSetExpression",
                         "supportsValueFormattingOptions",
                         "supportsClipboardContext",
                         "supportsCompletionsRequest",
                         "supportsDelayedStackTraceLoading",
                         "supportsLoadedSourcesRequest",
                         "supportsModulesRequest",
                         "supportsReadMemoryRequest",
                         "supportsWriteMemoryRequest",
                         "supportsDisassembleRequest",
                         "supportsTerminateRequest",
                         "supportsCancelRequest"})
    Capabilities[Name] = true;
  return std::move(Capabilities);
}

Response LifeCycleRequests::attach(const NoArguments &) {
  return createStringError("a simulation begins with its program and cannot "
                           "be attached to; launch it");
}

Response LifeCycleRequests::launch(const json::Value &Arguments) {
  if (Target.WasLaunched)
    return createStringError("a session debugs one program; this one has had "
                             "its launch");
  Expected<LaunchRequest> Wish = readLaunch(Arguments);
  if (!Wish)
    return Wish.takeError();
  if (llvm::Error Problem = load(*Wish))
    return std::move(Problem);
  Target.Configuration = *Wish;
  Target.WasLaunched = true;
  Console.connect();
  Target.afterResponse([this] {
    tellWarnings();
    Target.Out.event("initialized", json::Object());
  });
  return json::Object();
}

llvm::Error LifeCycleRequests::load(const LaunchRequest &Wish) {
  if (!Wish.Folder.empty())
    if (std::error_code Problem = sys::fs::set_current_path(Wish.Folder))
      return createStringError("launch configuration: 'cwd': '" + Wish.Folder +
                               "': " + Problem.message());
  std::vector<const char *> Arguments;
  for (const std::string &Argument : Wish.CommandLine)
    Arguments.push_back(Argument.c_str());
  Expected<SessionOptions> Options = parseSessionOptions(Arguments);
  if (!Options)
    return Options.takeError();
  Expected<std::unique_ptr<Session>> Loaded =
      Session::create(*Options, ChipFolder);
  if (!Loaded)
    return Loaded.takeError();
  Target.Program = std::move(*Loaded);
  Target.Program->setOutput([this](bool IsStandardError, StringRef Text) {
    Target.Out.output(IsStandardError ? "stderr" : "stdout", Text);
  });
  Target.Program->setProgress(Target.OnProgress);
  for (const auto &[From, To] : Wish.SourceMap)
    Target.Program->information().files().substitute(From, To);
  return llvm::Error::success();
}

void LifeCycleRequests::tellWarnings() {
  DebugInformation &Information = Target.Program->information();
  for (const std::string &Warning : Information.warnings())
    Target.Out.output("important", Warning + "\n");
  if (!Information.map().hasLines())
    Target.Out.output("important", "The program has no debug information; "
                                   "compile it with -g to see its source.\n");
}

Response LifeCycleRequests::configurationDone(const NoArguments &) {
  Target.afterResponse([this] { Execution.start(); });
  return json::Object();
}

Response LifeCycleRequests::terminate(const NoArguments &) {
  Target.afterResponse([this] {
    if (Target.Program)
      Target.end(0);
  });
  return json::Object();
}

Response LifeCycleRequests::disconnect(const NoArguments &) {
  Target.IsEnded = true;
  return json::Object();
}

/// The reading thread has already done it.
Response LifeCycleRequests::cancel(const NoArguments &) {
  return json::Object();
}

} // namespace tp::dap
