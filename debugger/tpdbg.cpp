//===- tpdbg.cpp - The debugger's command ---------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/cli/CommandLine.h"
#include "debugger/cli/DebuggerOptions.h"
#include "debugger/cli/Script.h"
#include "debugger/dap/Server.h"
#include "simulator/tools/ChipSelection.h"

#include "llvm/Support/WithColor.h"

#include <csignal>

using namespace llvm;

/// Whom Ctrl-C stops.
static tp::Session *Interrupted = nullptr;

static void printOutput(bool IsStandardError, StringRef Text) {
  raw_ostream &OS = IsStandardError ? errs() : outs();
  OS << Text;
  OS.flush();
}

/// Executes the commands of the command line; the exit status if it is known
/// then.
static std::optional<int> runStartup(tp::CommandLine &Commands,
                                     const tp::DebuggerOptions &Request) {
  bool HasFailed = false;
  for (const tp::StartupCommand &Startup : Request.Commands) {
    std::optional<int> Quit;
    if (Startup.IsFile) {
      Expected<std::optional<int>> Result =
          tp::runScript(Commands, Startup.Text, outs());
      if (Result)
        Quit = *Result;
      else {
        outs() << toString(Result.takeError()) << '\n';
        HasFailed = true;
      }
    } else {
      tp::CommandResult Result = Commands.execute(Startup.Text);
      Quit = Result.Quit;
      HasFailed |= Result.Failed;
    }
    if (Quit)
      return Quit;
  }
  if (!Request.Batch)
    return std::nullopt;
  if (Commands.dropUnfinished()) {
    outs() << "\"end\" of commands is missing\n";
    HasFailed = true;
  }
  return HasFailed ? 1 : 0;
}

static Expected<int> run(int Argc, char **Argv) {
  Expected<tp::DebuggerOptions> Request =
      tp::parseDebuggerOptions(ArrayRef(Argv, Argc).drop_front());
  if (!Request)
    return Request.takeError();
  if (Request->Help) {
    tp::printDebuggerHelp(outs());
    return 0;
  }
  if (Request->Version) {
    outs() << "tpdbg " TP_VERSION "\n";
    return 0;
  }
  std::string ChipFolder = tp::chipFolder(Argv[0]);
  if (Request->ServesEditor) {
    if (Error E = tp::dap::serve(Request->Port, ChipFolder))
      return std::move(E);
    return 0;
  }
  Expected<std::unique_ptr<tp::Session>> Session =
      tp::Session::create(Request->Session, ChipFolder);
  if (!Session)
    return Session.takeError();
  (*Session)->setOutput(printOutput);
  for (const std::string &Warning : (*Session)->information().warnings())
    WithColor::warning(errs(), "tpdbg") << Warning << '\n';
  Interrupted = Session->get();
  std::signal(SIGINT, [](int) { Interrupted->interrupt(); });
  tp::CommandLine Commands(**Session, outs());
  if (std::optional<int> Status = runStartup(Commands, *Request))
    return *Status;
  return tp::runInteractively(Commands, outs());
}

int main(int Argc, char **Argv) {
  Expected<int> Status = run(Argc, Argv);
  if (Status)
    return *Status;
  handleAllErrors(Status.takeError(), [](const ErrorInfoBase &Problem) {
    WithColor::error(errs(), "tpdbg") << Problem.message() << '\n';
  });
  return 1;
}
