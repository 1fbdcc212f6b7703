//===- ChipVariables.cpp - What the chip does with a thread ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/ChipVariables.h"

#include "simulator/isa/Instructions.h"
#include "simulator/stats/RunSummary.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/ErrorHandling.h"

using namespace llvm;

namespace tp::dap {

static VariableRow row(std::string Name, std::string Value) {
  VariableRow Result;
  Result.Name = std::move(Name);
  Result.Value = std::move(Value);
  Result.IsReadOnly = true;
  return Result;
}

/// A row that unfolds into others.
static VariableRow list(std::string Name, std::string Value,
                        std::vector<VariableRow> Rows) {
  VariableRow Result = row(std::move(Name), std::move(Value));
  if (!Rows.empty())
    Result.Parts = std::make_shared<FixedList>(std::move(Rows));
  return Result;
}

static std::string stateText(const ReplayThread &Thread) {
  switch (Thread.State) {
  case ThreadState::Running:
    return "running";
  case ThreadState::AtBarrier:
    return "at a barrier";
  case ThreadState::Halted:
    return "halted with status " + itostr(Thread.Status);
  case ThreadState::Trapped:
    return "trapped";
  }
  llvm_unreachable("unknown state of a thread");
}

static std::string waitText(const ThreadTiming &Timing) {
  if (!Timing.Reason || *Timing.Reason == Loss::Finished)
    return "nothing";
  std::string Text = lossName(*Timing.Reason);
  if (isWaitForResult(*Timing.Reason))
    Text += " on " + std::string(mnemonic(Timing.Producer));
  return Text;
}

static VariableRow underWayRow(const RequestUnderWay &Request) {
  std::string Text(mnemonic(Request.Producer));
  if (Request.FromGlobalMemory)
    Text += Request.IsBeyondL1 ? ", beyond the L1" : ", global memory";
  if (Request.ReadyCycle)
    Text += ", ready in cycle " + utostr(*Request.ReadyCycle);
  return row(registerName(Request.Register), std::move(Text));
}

static void addTiming(std::vector<VariableRow> &Rows,
                      const ThreadTiming &Timing) {
  Rows.push_back(row("waits for", waitText(Timing)));
  std::vector<VariableRow> UnderWay;
  UnderWay.reserve(Timing.UnderWay.size());
  for (const RequestUnderWay &Request : Timing.UnderWay)
    UnderWay.push_back(underWayRow(Request));
  std::string Count = utostr(UnderWay.size());
  Rows.push_back(list("under way", std::move(Count), std::move(UnderWay)));
  Rows.push_back(row("unanswered stores", utostr(Timing.UnansweredStores)));
  std::vector<VariableRow> Lost;
  uint64_t Sum = 0;
  for (size_t Reason = 0; Reason < Timing.Lost.size(); ++Reason) {
    if (Timing.Lost[Reason] == 0)
      continue;
    Sum += Timing.Lost[Reason];
    Lost.push_back(row(lossName(Loss(Reason)), utostr(Timing.Lost[Reason])));
  }
  Rows.push_back(list("cycles lost", utostr(Sum), std::move(Lost)));
}

std::shared_ptr<VariableList> chipVariables(const Session &Program,
                                            uint32_t Thread) {
  ReplayThread State = Program.replay().thread(Thread);
  uint64_t Time = Program.replay().now().Time;
  std::vector<VariableRow> Rows;
  Rows.push_back(
      row(Program.isFunctional() ? "instruction of the run" : "cycle",
          utostr(Time)));
  Rows.push_back(row("thread", utostr(Thread) + ", TM.TP " +
                                   threadPlace(Thread, Program.chip())));
  Rows.push_back(row("state", stateText(State)));
  Rows.push_back(row("instructions issued", utostr(State.Instructions)));
  if (State.Timing)
    addTiming(Rows, *State.Timing);
  return std::make_shared<FixedList>(std::move(Rows));
}

} // namespace tp::dap
