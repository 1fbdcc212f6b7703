//===- ModelMemory.cpp - The memory system in step with the model ---------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The memory system is the simulator's own, but it is asked cycle by cycle, in
// every cycle and every window, in the order of time.
//
//===----------------------------------------------------------------------===//

#include "test/unit/oracle/ScoreboardModel.h"

#include <algorithm>
#include <limits>

namespace tp::test {

static constexpr uint64_t NotKnown = std::numeric_limits<uint64_t>::max();

void ScoreboardModel::request(ModelThread &T, RequestKind Kind,
                              unsigned Destination,
                              const ModelEffects &Effects) {
  Ticket Asked;
  if (Kind == RequestKind::Store) {
    Asked.Entry = T.NextStore;
    T.StoreEntries[T.NextStore] = NotKnown;
    T.NextStore = (T.NextStore + 1) % T.StoreEntries.size();
  } else {
    Asked.Destination = Destination;
    Asked.Write = Writes;
  }
  MemoryRequest Request;
  Request.Cycle = Cycle;
  Request.Address = Effects.Access ? Effects.Access->Address : Effects.Address;
  Request.Bytes =
      uint16_t(Effects.Access ? Effects.Access->Bytes : Effects.Bytes);
  Request.Ticket = NextTicket;
  Request.Priority = uint16_t(priorityOf(T));
  Request.Tp = uint16_t(T.Number % Chip.TpsPerTm);
  Request.Kind = Kind;
  Tickets[NextTicket++] = Asked;
  Hierarchy->tm(T.Number / Chip.TpsPerTm).request(Request);
}

void ScoreboardModel::takeAnswer(uint32_t Tm, const MemoryAnswer &Answer) {
  if (Answer.ReadyCycle == AnsweredLater)
    return;
  Ticket Asked = Tickets.at(Answer.Ticket);
  Tickets.erase(Answer.Ticket);
  ModelThread &T = Threads[Tm * Chip.TpsPerTm + Answer.Tp];
  if (Asked.Write == 0) {
    T.StoreEntries[Asked.Entry] = Answer.ReadyCycle;
    T.LastStoreAnswer = std::max(T.LastStoreAnswer, Answer.ReadyCycle);
    return;
  }
  ModelRegister &R = T.Registers[Asked.Destination];
  if (R.Write != Asked.Write)
    return;
  R.IsPending = false;
  R.Ready = Answer.ReadyCycle;
  R.Level = Answer.Level;
}

void ScoreboardModel::takeSharedAnswers() {
  if (!Hierarchy)
    return;
  std::vector<MemoryAnswer> Answers;
  for (uint32_t Tm = 0; Tm != Chip.TmCount; ++Tm) {
    Answers.clear();
    Hierarchy->tm(Tm).takeAnswers(Answers);
    for (const MemoryAnswer &Answer : Answers)
      takeAnswer(Tm, Answer);
  }
}

void ScoreboardModel::advanceMemory() {
  if (!Hierarchy)
    return;
  std::vector<MemoryAnswer> Answers;
  for (uint32_t Tm = 0; Tm != Chip.TmCount; ++Tm) {
    Answers.clear();
    Hierarchy->tm(Tm).advance(Cycle + 1, Answers);
    for (const MemoryAnswer &Answer : Answers)
      takeAnswer(Tm, Answer);
  }
}

void ScoreboardModel::runSharedMemory() {
  if (!Hierarchy)
    return;
  for (unsigned Stage = 0; Stage != Hierarchy->stages(); ++Stage)
    for (unsigned Part = 0; Part != Hierarchy->parts(Stage); ++Part)
      Hierarchy->runPart(Stage, Part, WindowEnd);
}

bool ScoreboardModel::awaitsStoreBuffer(ModelThread &T) {
  if (T.AwaitsStores) {
    bool AllAnswered = std::ranges::all_of(
        T.StoreEntries, [&](uint64_t FreeFrom) { return FreeFrom <= Cycle; });
    T.AwaitsStores = !AllAnswered || T.LastStoreAnswer > Cycle;
    if (T.AwaitsStores)
      lose(T, Loss::Sync);
    return T.AwaitsStores;
  }
  if (!T.AwaitsEntry)
    return false;
  T.AwaitsEntry = T.StoreEntries[T.NextStore] > Cycle;
  if (T.AwaitsEntry)
    loseToResult(T, Loss::StoreBuffer, Text.instructions()[wordOf(T)].Op);
  return T.AwaitsEntry;
}

void ScoreboardModel::settleAll() {
  for (ModelThread &T : Threads) {
    if (T.Uncharged == 0)
      continue;
    const Instruction &I = Text.instructions()[wordOf(T)];
    const ModelRegister &Last = lastSource(T, I);
    if (Last.IsPending)
      loseToResult(T, Loss::Memory, Last.Producer, T.Uncharged);
    else
      settle(T, I);
  }
}

} // namespace tp::test
