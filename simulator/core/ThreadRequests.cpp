//===- ThreadRequests.cpp - A thread's accesses under way -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/core/ThreadRequests.h"

#include <algorithm>
#include <cassert>

namespace tp {

uint32_t ThreadRequests::addStore() {
  uint32_t Ticket = NextStore << RegisterBits | NumRegisters;
  Stores[NextStore] = {NeverFree, false};
  ++Unanswered;
  if (++NextStore == Stores.size())
    NextStore = 0;
  return Ticket;
}

void ThreadRequests::noteStore(const MemoryAnswer &Answer) {
  StoreEntry &Entry = Stores[Answer.Ticket >> RegisterBits];
  if (Answer.ReadyCycle == AnsweredLater) {
    Entry.GoneOn = true;
    ++StoresGoneOn;
    return;
  }
  --Unanswered;
  StoresGoneOn -= Entry.GoneOn;
  Entry.FreeFrom = Answer.ReadyCycle;
  LastStoreAnswer = std::max(LastStoreAnswer, Answer.ReadyCycle);
}

void ThreadRequests::addOrigin(uint32_t Ticket, Origin From) {
  Origins.push_back({Ticket, From});
}

ThreadRequests::Origin ThreadRequests::takeOrigin(uint32_t Ticket) {
  auto Found = std::ranges::find(Origins, Ticket, &TicketOrigin::Ticket);
  assert(Found != Origins.end() && "an answer without a request");
  Origin Result = Found->From;
  *Found = Origins.back();
  Origins.pop_back();
  return Result;
}

void ThreadRequests::serialize(Archive &A) {
  A(Registers);
  A(Stores);
  A(NextStore);
  A(NextNumber);
  A(Unanswered);
  A(StoresGoneOn);
  A(LastStoreAnswer);
  A(SuspendedAt);
  A(Waiting);
  A(Origins);
}

} // namespace tp
