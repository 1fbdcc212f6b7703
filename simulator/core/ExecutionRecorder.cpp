//===- ExecutionRecorder.cpp - Records a run for its profile --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/core/ExecutionRecorder.h"

#include <algorithm>

namespace tp {

RecordedCounts &RecordedCounts::operator+=(const RecordedCounts &Other) {
  for (size_t Node = 0; Node != Other.Nodes.size(); ++Node) {
    NodeCounts &Sum = of(uint32_t(Node));
    const NodeCounts &More = Other.Nodes[Node];
    Sum.Calls += More.Calls;
    Sum.Instructions += More.Instructions;
    for (unsigned Reason = 0; Reason != NumLosses; ++Reason)
      Sum.Lost[Reason] += More.Lost[Reason];
  }
  for (size_t Word = 0; Word != Served.size(); ++Word)
    for (unsigned Level = 0; Level != NumServedBy; ++Level) {
      Served[Word][Level].Accesses += Other.Served[Word][Level].Accesses;
      Served[Word][Level].Cycles += Other.Served[Word][Level].Cycles;
    }
  return *this;
}

void RecorderPart::issued(const Thread &T, const IssuedInstruction &Issued) {
  Transfer Kind = Owner.Transfers[Issued.Word];
  if (Kind == Transfer::None || !Issued.IsTaken)
    return;
  const FunctionMap &Functions = Owner.Functions;
  if (Kind == Transfer::Jump && Functions.functionOf(Issued.Word) ==
                                    Functions.functionOf(Issued.NextWord))
    return;
  ExecutionRecorder::ThreadCalls &Where = Owner.Threads[T.Number];
  RecordedCounts::NodeCounts &Sum = Counts.of(Where.Node);
  uint64_t Instructions = Issued.Cycle - T.totalLost();
  Sum.Instructions += Instructions - Where.Instructions;
  Where.Instructions = Instructions;
  for (unsigned Reason = 0; Reason != NumLosses; ++Reason)
    Sum.Lost[Reason] += T.Lost[Reason] - Where.Lost[Reason];
  Where.Lost = T.Lost;
  Sum.Lost[unsigned(Loss::Branch)] += Issued.BranchLoss;
  Where.Lost[unsigned(Loss::Branch)] += Issued.BranchLoss;
  Where.LastNode = Where.Node;
  if (Kind == Transfer::Call)
    Owner.call(Where, Issued, *this);
  else if (Kind == Transfer::Return)
    Owner.comeBack(Where, Issued.NextWord, *this);
  else
    Owner.jump(Where, Issued, *this);
}

void RecorderPart::served(const AnsweredRequest &Answer) {
  ServedAccesses &Sum = Counts.Served[Answer.Word][unsigned(Answer.Level)];
  ++Sum.Accesses;
  Sum.Cycles += Answer.Ready - Answer.Issued;
  if (!Owner.IsTraced.empty() && Owner.IsTraced[Answer.Thread] &&
      Answer.Issued < Owner.EndOfTraced && Answer.Ready > Owner.FirstTraced)
    Answers.push_back(Answer);
}

ExecutionRecorder::ExecutionRecorder(const ChipConfig &Chip,
                                     const Program &Text,
                                     std::vector<uint32_t> Entries)
    : Chip(Chip), Text(Text), Functions(Text, std::move(Entries)),
      Transfers(transfersOf(Text, Functions)) {}

void ExecutionRecorder::traceRequests(uint32_t Thread, uint64_t First,
                                      uint64_t End) {
  FirstTraced = First;
  EndOfTraced = End;
  IsTraced.resize(Chip.threadCount());
  IsTraced[Thread] = true;
}

std::vector<AnsweredRequest> ExecutionRecorder::tracedRequests() const {
  std::vector<AnsweredRequest> Result;
  for (const RecorderPart &Part : Parts)
    Result.insert(Result.end(), Part.Answers.begin(), Part.Answers.end());
  return Result;
}

void ExecutionRecorder::begin(const Thread &T, uint32_t Word) {
  if (Parts.empty())
    addPart();
  Threads.resize(std::max<size_t>(Threads.size(), T.Number + 1));
  ThreadCalls &Where = Threads[T.Number];
  uint32_t LastWord = uint32_t(Transfers.size()) - 1;
  enter(Where,
        {CallTree::NoNode, 0, Functions.functionOf(std::min(Word, LastWord))},
        Parts.front());
  Where.LastNode = Where.Node;
}

void ExecutionRecorder::enter(ThreadCalls &Where,
                              const CallTree::Node &Function,
                              RecorderPart &Part) {
  uint32_t Node = Tree.numberOf(Function);
  Where.Node = Node;
  if (Tree.node(Node).Function == Function.Function)
    ++Part.Counts.of(Node).Calls;
}

void ExecutionRecorder::call(ThreadCalls &Where,
                             const IssuedInstruction &Issued,
                             RecorderPart &Part) {
  Where.Stack.push_back({Issued.Word + 1, Where.Node});
  enter(Where, {Where.Node, Issued.Word, Functions.functionOf(Issued.NextWord)},
        Part);
}

void ExecutionRecorder::comeBack(ThreadCalls &Where, uint32_t Word,
                                 RecorderPart &Part) {
  while (!Where.Stack.empty()) {
    OpenCall Last = Where.Stack.back();
    Where.Stack.pop_back();
    if (Last.ReturnWord == Word) {
      Where.Node = Last.Caller;
      return;
    }
  }
  enter(Where, {CallTree::NoNode, 0, Functions.functionOf(Word)}, Part);
}

void ExecutionRecorder::jump(ThreadCalls &Where,
                             const IssuedInstruction &Issued,
                             RecorderPart &Part) {
  auto IsReturn = [&](const OpenCall &Call) {
    return Call.ReturnWord == Issued.NextWord;
  };
  uint32_t Function = Functions.functionOf(Issued.NextWord);
  if (Functions.entryOf(Function) != Issued.NextWord &&
      std::ranges::any_of(Where.Stack, IsReturn))
    return comeBack(Where, Issued.NextWord, Part);
  enter(Where, {Where.Node, Issued.Word, Function}, Part);
}

RecordedCounts ExecutionRecorder::total() const {
  RecordedCounts Sum(Transfers.size());
  for (const RecorderPart &Part : Parts)
    Sum += Part.Counts;
  return Sum;
}

void ExecutionRecorder::addOpenNodes(const Statistics &Now,
                                     RecordedCounts &Sum) const {
  for (size_t Thread = 0; Thread != Threads.size(); ++Thread) {
    const ThreadCalls &Where = Threads[Thread];
    const ThreadStatistics &Counts = Now.Threads[Thread];
    Sum.of(Where.Node).Instructions += Counts.Instructions - Where.Instructions;
    for (unsigned Reason = 0; Reason != NumLosses; ++Reason) {
      if (Loss(Reason) == Loss::Finished)
        continue;
      uint64_t Before = Where.Lost[Reason], After = Counts.Lost[Reason];
      // The branch to where the thread is now was cut by the run's end.
      uint32_t Node = After < Before ? Where.LastNode : Where.Node;
      Sum.of(Node).Lost[Reason] += After - Before;
    }
  }
}

void ExecutionRecorder::recordAccesses(const Statistics &Now,
                                       const RecordedCounts &Sum,
                                       ExecutionRecord &Result) const {
  for (size_t Word = 0; Word != Now.Pcs.size(); ++Word) {
    MemoryBehaviour &Memory = Result.Pcs.emplace_back();
    Memory.Global = Now.Pcs[Word].Global;
    Memory.Served = Sum.Served[Word];
    if (Chip.hasMemorySystem() || Memory.Global == 0)
      continue;
    // Nobody answers stores.
    if (latencyClassOf(Text.instructions()[Word].Op) != LatencyClass::Store)
      Memory.Served[unsigned(ServedBy::Memory)] = {
          Memory.Global, Memory.Global * Chip.MemoryLatency};
  }
}

void ExecutionRecorder::recordCalls(const RecordedCounts &Sum,
                                    ExecutionRecord &Result) const {
  // Numbers depend on which host thread came first; the order of chains does
  // not.
  std::vector<std::vector<uint32_t>> Called(Tree.size());
  std::vector<uint32_t> Next;
  for (uint32_t Node = 0; Node != Tree.size(); ++Node)
    (Tree.node(Node).Caller == CallTree::NoNode
         ? Next
         : Called[Tree.node(Node).Caller])
        .push_back(Node);
  auto Sort = [this](std::vector<uint32_t> &Nodes) {
    std::ranges::sort(Nodes, std::greater(), [this](uint32_t Node) {
      return std::pair(Tree.node(Node).Site, Tree.node(Node).Function);
    });
  };
  Sort(Next);
  std::vector<uint32_t> NewNumber(Tree.size());
  while (!Next.empty()) {
    uint32_t Number = Next.back();
    Next.pop_back();
    NewNumber[Number] = uint32_t(Result.Calls.size());
    const CallTree::Node &Node = Tree.node(Number);
    CalledFunction &Function = Result.Calls.emplace_back();
    Function.Entry = Functions.entryOf(Node.Function);
    if (Node.Caller != CallTree::NoNode)
      Function.Caller = NewNumber[Node.Caller];
    Function.CallSite = Node.Site;
    Function.Calls = Sum.Nodes[Number].Calls;
    Function.Instructions = Sum.Nodes[Number].Instructions;
    Function.Lost = Sum.Nodes[Number].Lost;
    Sort(Called[Number]);
    Next.insert(Next.end(), Called[Number].begin(), Called[Number].end());
  }
  Result.IsCallTreeCut = Tree.isCut();
}

ExecutionRecord ExecutionRecorder::record(const Statistics &Now) const {
  ExecutionRecord Result;
  RecordedCounts Sum = total();
  addOpenNodes(Now, Sum);
  Sum.Nodes.resize(Tree.size());
  recordAccesses(Now, Sum, Result);
  recordCalls(Sum, Result);
  return Result;
}

void ExecutionRecorder::serialize(Archive &A) {
  A(Tree);
  A(Threads);
  RecordedCounts Sum = total();
  A(Sum);
  if (!A.isRestoring())
    return;
  // Host threads that have been prepared keep their parts.
  for (RecorderPart &Part : Parts)
    Part.Counts = RecordedCounts(Transfers.size());
  if (Parts.empty())
    addPart();
  Parts.front().Counts = std::move(Sum);
}

} // namespace tp
