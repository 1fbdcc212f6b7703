//===- Server.cpp - The debug adapter -------------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/Server.h"

#include "debugger/dap/BreakpointRequests.h"
#include "debugger/dap/Connections.h"
#include "debugger/dap/ConsoleRequests.h"
#include "debugger/dap/ExecutionRequests.h"
#include "debugger/dap/LifeCycleRequests.h"
#include "debugger/dap/Mailbox.h"
#include "debugger/dap/MemoryRequests.h"
#include "debugger/dap/StackRequests.h"
#include "debugger/dap/VariableRequests.h"

using namespace llvm;

namespace tp::dap {
namespace {

/// One client's session.
class Adapter {
public:
  Adapter(int Input, raw_ostream &OS, StringRef ChipFolder)
      : Out(OS), Target(Out), Breakpoints(Target), Stacks(Target),
        Values(Target), Memory(Target),
        Execution(Target, Run, [this] { handleWaiting(); }),
        Console(Target, Run, Values),
        LifeCycle(Target, Execution, Console, ChipFolder),
        Box(Input, Out, [this](const Request *Next) { Run.arrived(Next); }) {
    Breakpoints.addTo(Requests);
    Stacks.addTo(Requests);
    Values.addTo(Requests);
    Memory.addTo(Requests);
    Execution.addTo(Requests);
    Console.addTo(Requests);
    LifeCycle.addTo(Requests);
    // A request may have come just before the run that it is to stop.
    Target.OnProgress = [this](const Progress &Now) {
      Box.announceWaiting();
      Target.Running.update(Now);
    };
  }

  /// Until the client goes.
  void run() {
    while (!Target.IsEnded) {
      std::optional<Request> Next = Box.take();
      if (!Next)
        return;
      handle(*Next);
    }
  }

private:
  Channel Out;
  Debuggee Target;
  ActiveRun Run;
  BreakpointRequests Breakpoints;
  StackRequests Stacks;
  VariableRequests Values;
  MemoryRequests Memory;
  ExecutionRequests Execution;
  ConsoleRequests Console;
  LifeCycleRequests LifeCycle;
  Dispatcher Requests;
  Mailbox Box;

  void handle(const Request &Wish) {
    Requests.handle(Wish, Target.stage(), Out,
                    [this] { return Box.currentCancelled(); });
    Target.runLater();
  }

  /// What has come while the program ran.
  void handleWaiting() {
    while (!Target.IsEnded && Box.waiting()) {
      std::optional<Request> Next = Box.take();
      if (!Next)
        Target.IsEnded = true;
      else
        handle(*Next);
    }
  }
};

} // namespace

llvm::Error serve(std::optional<uint16_t> Port, StringRef ChipFolder) {
  Conversation Talk = [ChipFolder](int Input, raw_ostream &Output) {
    Adapter(Input, Output, ChipFolder).run();
  };
  return Port ? talkOnPort(*Port, Talk, errs()) : talkOnStandardStreams(Talk);
}

} // namespace tp::dap
