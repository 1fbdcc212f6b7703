//===- ThreadViews.cpp - What threads and the chip do ---------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/cli/Views.h"
#include "simulator/stats/RunSummary.h"

#include "llvm/ADT/StringExtras.h"

#include <map>

using namespace llvm;

namespace tp {

/// `at main () at main.cpp:3`, for threads in one line of one function.
static std::string placeOf(Shell &S, const ReplayThread &State) {
  if (State.State == ThreadState::Halted)
    return "halted with status " + itostr(State.Status);
  std::string Text = "at ";
  std::vector<InlinedCall> Calls = S.map().callsAt(State.Pc);
  if (Calls.empty())
    return Text + S.map().describeAddress(State.Pc);
  Text += S.map().function(Calls.front().Function).QualifiedName;
  if (Calls.front().Position.isKnown())
    return Text + " " + S.info().files().shortName(Calls.front().Position);
  return Text + " " + S.map().describeAddress(State.Pc);
}

void printThreads(Shell &S) {
  std::map<std::string, std::vector<uint32_t>> Groups;
  std::vector<const std::string *> Order;
  for (uint32_t T = 0; T != S.Program.replay().threadCount(); ++T) {
    auto [Group, IsNew] =
        Groups.try_emplace(placeOf(S, S.Program.replay().thread(T)));
    Group->second.push_back(T);
    if (IsNew)
      Order.push_back(&Group->first);
  }
  for (const std::string *Place : Order) {
    const std::vector<uint32_t> &Threads = Groups[*Place];
    bool IsSelected = is_contained(Threads, S.Thread);
    if (Threads.size() == S.Program.replay().threadCount() &&
        Threads.size() > 1)
      S.OS << (IsSelected ? "* " : "  ") << "all " << Threads.size()
           << " threads " << *Place << '\n';
    else
      S.OS << (IsSelected ? "* " : "  ")
           << (Threads.size() == 1 ? "thread " : "threads ")
           << threadList(Threads) << ' ' << *Place << '\n';
  }
}

static void printRequest(Shell &S, const RequestUnderWay &Request) {
  S.OS << "  " << registerName(Request.Register) << " from "
       << mnemonic(Request.Producer);
  if (Request.FromGlobalMemory)
    S.OS << (Request.IsBeyondL1 ? ", in global memory behind the L1"
                                : ", in global memory");
  if (Request.ReadyCycle)
    S.OS << ", ready in cycle " << *Request.ReadyCycle;
  S.OS << '\n';
}

void printTiming(Shell &S) {
  Moment Now = S.Program.replay().now();
  ReplayThread State = S.Program.replay().thread(S.Thread);
  S.OS << (S.Program.isFunctional() ? "Instruction " : "Cycle ") << Now.Time
       << ", " << S.threadName(S.Thread) << ": " << State.Instructions
       << " instructions issued";
  if (State.State == ThreadState::Halted) {
    S.OS << ", halted with status " << State.Status << ".\n";
    return;
  }
  S.OS << ".\n";
  if (!State.Timing) {
    S.OS << "Without timing (--functional) there are no stalls.\n";
    return;
  }
  const ThreadTiming &Timing = *State.Timing;
  if (!Timing.Reason)
    S.OS << "Its next instruction can be issued.\n";
  else {
    S.OS << "It is stalled: " << lossName(*Timing.Reason);
    if (isWaitForResult(*Timing.Reason))
      S.OS << " (waits for the result of " << mnemonic(Timing.Producer) << ')';
    S.OS << ".\n";
  }
  if (Timing.UnderWay.empty() && Timing.UnansweredStores == 0)
    S.OS << "Nothing is in flight.\n";
  else
    S.OS << "In flight:\n";
  for (const RequestUnderWay &Request : Timing.UnderWay)
    printRequest(S, Request);
  if (Timing.UnansweredStores != 0)
    S.OS << "  stores without answer: " << Timing.UnansweredStores << '\n';
  S.OS << "Cycles lost so far:";
  ListSeparator Separator;
  bool HasLost = false;
  for (unsigned I = 0; I != NumLosses; ++I)
    if (Timing.Lost[I] != 0) {
      S.OS << Separator << ' ' << lossName(Loss(I)) << ' ' << Timing.Lost[I];
      HasLost = true;
    }
  S.OS << (HasLost ? "\n" : " none\n");
}

void printChip(Shell &S) {
  std::map<std::string, std::vector<uint32_t>> Groups;
  for (uint32_t T = 0; T != S.Program.replay().threadCount(); ++T) {
    ReplayThread State = S.Program.replay().thread(T);
    std::string Doing = "can issue";
    if (State.State == ThreadState::Halted)
      Doing = "halted";
    else if (State.Timing && State.Timing->Reason)
      Doing = lossName(*State.Timing->Reason);
    Groups[Doing].push_back(T);
  }
  for (const auto &[Doing, Threads] : Groups)
    S.OS << right_justify(utostr(Threads.size()), 6) << "  "
         << left_justify(Doing, 24) << " threads " << threadList(Threads)
         << '\n';
}

} // namespace tp
