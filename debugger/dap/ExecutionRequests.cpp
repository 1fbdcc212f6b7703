//===- ExecutionRequests.cpp - Requests that move the program -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/ExecutionRequests.h"

#include "debugger/dap/ClientSources.h"
#include "debugger/dap/MemoryReference.h"

using namespace llvm;

namespace tp::dap {

void ExecutionRequests::addTo(Dispatcher &Requests) {
  using Self = ExecutionRequests;
  Requests.on("continue", Stage::Stopped, this, &Self::continueForward);
  Requests.on("reverseContinue", Stage::Stopped, this, &Self::continueBackward);
  Requests.on("next", Stage::Stopped, this, &Self::next);
  Requests.on("stepIn", Stage::Stopped, this, &Self::stepIn);
  Requests.on("stepOut", Stage::Stopped, this, &Self::stepOut);
  Requests.on("stepBack", Stage::Stopped, this, &Self::stepBack);
  Requests.on("pause", Stage::Launched, this, &Self::pause);
  Requests.on("gotoTargets", Stage::Stopped, this, &Self::gotoTargets);
  Requests.on("goto", Stage::Stopped, this, &Self::goTo);
  Requests.on("restart", Stage::Launched, this, &Self::restart);
}

void ExecutionRequests::start() {
  if (!Target.Configuration.StopOnEntry) {
    resume(Direction::Forward);
    return;
  }
  SessionStop Entry;
  Entry.Kind = SessionStop::Beginning;
  Entry.Pc = Target.Program->context(0).Pc;
  Target.report(Entry);
}

bool ExecutionRequests::isAtEnd() const {
  return Target.LastStop && (Target.LastStop->Kind == SessionStop::Exited ||
                             Target.LastStop->Kind == SessionStop::Trapped);
}

Response ExecutionRequests::continueForward(const ThreadArguments &) {
  Target.afterResponse([this] {
    if (!isAtEnd()) {
      resume(Direction::Forward);
      return;
    }
    bool HasTrapped = Target.LastStop->Kind == SessionStop::Trapped;
    Target.end(HasTrapped ? 1 : Target.LastStop->ExitStatus);
  });
  return json::Object{{"allThreadsContinued", true}};
}

Response ExecutionRequests::continueBackward(const ThreadArguments &) {
  Target.afterResponse([this] { resume(Direction::Backward); });
  return json::Object();
}

Response ExecutionRequests::next(const ThreadArguments &Arguments) {
  return step(Arguments, /*OverCalls=*/true, Direction::Forward);
}

Response ExecutionRequests::stepIn(const ThreadArguments &Arguments) {
  return step(Arguments, /*OverCalls=*/false, Direction::Forward);
}

Response ExecutionRequests::stepBack(const ThreadArguments &Arguments) {
  return step(Arguments, /*OverCalls=*/true, Direction::Backward);
}

Response ExecutionRequests::step(const ThreadArguments &Arguments,
                                 bool OverCalls, Direction Towards) {
  Expected<uint32_t> Thread = Target.thread(Arguments.ThreadId);
  if (!Thread)
    return Thread.takeError();
  StepRequest Step;
  Step.Thread = *Thread;
  Step.OverCalls = OverCalls;
  Step.Towards = Towards;
  if (Arguments.Granularity == "instruction")
    Step.Unit = StepRequest::Instruction;
  Target.afterResponse([this, Step] {
    move(ActiveRun::Interest::Ending, [this, Step] {
      Target.Towards = Step.Towards;
      return Target.Program->step(Step);
    });
  });
  return json::Object();
}

Response ExecutionRequests::stepOut(const ThreadArguments &Arguments) {
  Expected<uint32_t> Thread = Target.thread(Arguments.ThreadId);
  if (!Thread)
    return Thread.takeError();
  const Backtrace &Stack = Target.backtrace(*Thread);
  if (Stack.Frames.size() < 2)
    return createStringError("the thread is in its outermost function");
  Target.afterResponse([this, Thread = *Thread, Of = Stack.Frames.front()] {
    move(ActiveRun::Interest::Ending, [&] {
      Target.Towards = Direction::Forward;
      Expected<SessionStop> Stop =
          Target.Program->finish(Thread, Of, Direction::Forward);
      if (Stop)
        return std::move(*Stop);
      SessionStop Unmoved;
      Unmoved.Thread = Thread;
      Unmoved.Message = toString(Stop.takeError());
      return Unmoved;
    });
  });
  return json::Object();
}

Response ExecutionRequests::pause(const ThreadArguments &) {
  PauseWanted = true;
  return json::Object();
}

/// Runs until something stops the program; requests that come meanwhile are
/// answered in between.
void ExecutionRequests::resume(Direction Towards) {
  move(ActiveRun::Interest::Any, [this, Towards] {
    Target.Towards = Towards;
    return Target.Program->resume(Towards);
  });
}

void ExecutionRequests::move(ActiveRun::Interest By,
                             const std::function<SessionStop()> &Action) {
  unsigned ThisMove = ++Moves;
  Target.moved();
  Target.IsRunning = true;
  PauseWanted = false;
  SessionStop Stop;
  bool IsShown = Target.Client.SupportsProgressReporting;
  do {
    Run.begin(*Target.Program, By);
    Target.Running.begin("Running", IsShown);
    Stop = Action();
    Target.Running.end();
    Run.end();
    if (Stop.Kind != SessionStop::Interrupted)
      break;
    HandleWaiting();
    // The program may have been ended or started again meanwhile.
    if (!Target.Program || Target.IsEnded || Moves != ThisMove)
      return;
  } while (By == ActiveRun::Interest::Any && !PauseWanted);
  Target.report(Stop);
}

Response ExecutionRequests::gotoTargets(const GotoTargetsArguments &Arguments) {
  DebugInformation &Information = Target.Program->information();
  Expected<SourceFileId> File =
      ClientSources(Information.files()).find(Arguments.Source);
  if (!File)
    return File.takeError();
  uint32_t Line = Target.Client.line(Arguments.Line);
  json::Array Targets;
  for (const LineStop &Stop : Information.map().stopsAtLine(*File, Line)) {
    GotoAddresses.push_back(Stop.Address);
    Targets.push_back(json::Object{
        {"id", int64_t(GotoAddresses.size())},
        {"label", Information.map().describeAddress(Stop.Address)},
        {"line", Target.Client.lineForClient(Stop.Position.Line)},
        {"instructionPointerReference", addressText(Stop.Address)}});
  }
  return json::Object{{"targets", std::move(Targets)}};
}

Response ExecutionRequests::goTo(const GotoArguments &Arguments) {
  Expected<uint32_t> Thread = Target.thread(Arguments.ThreadId);
  if (!Thread)
    return Thread.takeError();
  if (Arguments.TargetId < 1 ||
      Arguments.TargetId > int64_t(GotoAddresses.size()))
    return createStringError("there is no goto target " +
                             Twine(Arguments.TargetId));
  uint32_t Pc = GotoAddresses[Arguments.TargetId - 1];
  if (!Target.Program->machine(*Thread).WritePc(Pc))
    return createStringError("the pc of thread " + Twine(Arguments.ThreadId) +
                             " cannot be changed here");
  Target.afterResponse([this, Thread = *Thread] {
    Target.moved();
    Target.LastStop.reset();
    Target.Out.event("stopped", json::Object{{"reason", "goto"},
                                             {"threadId", threadId(Thread)},
                                             {"allThreadsStopped", true}});
  });
  return json::Object();
}

Response ExecutionRequests::restart(const NoArguments &) {
  if (llvm::Error Problem = Target.Program->restart())
    return std::move(Problem);
  Target.LastStop.reset();
  Target.afterResponse([this] { start(); });
  return json::Object();
}

} // namespace tp::dap
