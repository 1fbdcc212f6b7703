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

void ThreadRequests::recordOrigins() {
  Recorded.resize(1);
  Recorded.front().Stores.resize(Stores.size());
}

void ThreadRequests::keepOrigin(uint8_t Register, uint64_t Cycle) {
  const RegisterRequest &Request = Registers[Register];
  Origins &Kept = Recorded.front();
  Kept.Superseded.push_back(
      {uint32_t(Request.Number) << RegisterBits | Register,
       {Kept.Words[Register], Request.issuedBefore(Cycle)}});
}

ThreadRequests::Origin ThreadRequests::originOf(const MemoryAnswer &Answer) {
  Origins &Kept = Recorded.front();
  uint8_t Register = registerOf(Answer.Ticket);
  if (Register == NumRegisters)
    return Kept.Stores[Answer.Ticket >> RegisterBits];
  const RegisterRequest &Request = Registers[Register];
  if (Request.Number == Answer.Ticket >> RegisterBits)
    return {Kept.Words[Register], Request.issuedBefore(Answer.ReadyCycle)};
  auto Found =
      std::ranges::find(Kept.Superseded, Answer.Ticket, &TicketOrigin::Ticket);
  assert(Found != Kept.Superseded.end() && "an answer without a request");
  Origin Result = Found->From;
  Kept.Superseded.erase(Found);
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
  A(Recorded);
}

} // namespace tp
