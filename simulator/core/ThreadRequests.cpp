//===- ThreadRequests.cpp - A thread's accesses under way -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/core/ThreadRequests.h"

#include <algorithm>

namespace tp {

/// A ticket is a register and a number, NumRegisters and a place in the store
/// buffer, or LineMark and a line of the text.
static constexpr unsigned RegisterBits = 7;
static constexpr uint32_t RegisterMask = (1 << RegisterBits) - 1;
static constexpr uint32_t LineMark = NumRegisters + 1;
static_assert(LineMark <= RegisterMask);

uint8_t ThreadRequests::registerOf(uint32_t Ticket) {
  return uint8_t(Ticket & RegisterMask);
}

uint32_t ThreadRequests::ticketOfLine(uint32_t Line) {
  return Line << RegisterBits | LineMark;
}

uint32_t ThreadRequests::lineOf(uint32_t Ticket) {
  return (Ticket & RegisterMask) == LineMark ? Ticket >> RegisterBits : NoLine;
}

uint32_t ThreadRequests::addRegister(uint8_t Register, uint64_t Cycle,
                                     bool GoneOn) {
  uint32_t Ticket = NextTicket++ << RegisterBits | Register;
  Registers[Register] = {Cycle, Ticket, ServedBy::Memory, GoneOn};
  return Ticket;
}

uint32_t ThreadRequests::addStore() {
  uint32_t Ticket = NextStore << RegisterBits | NumRegisters;
  Stores[NextStore] = {NeverFree, false};
  ++Unanswered;
  if (++NextStore == Stores.size())
    NextStore = 0;
  return Ticket;
}

bool ThreadRequests::noteRegister(const MemoryAnswer &Answer) {
  RegisterRequest &Request = Registers[registerOf(Answer.Ticket)];
  if (Request.Ticket != Answer.Ticket)
    return false;
  if (Answer.ReadyCycle == AnsweredLater)
    Request.GoneOn = true;
  else
    Request.Level = Answer.Level;
  return true;
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

void ThreadRequests::serialize(Archive &A) {
  A(Registers);
  A(Stores);
  A(NextStore);
  A(NextTicket);
  A(Unanswered);
  A(StoresGoneOn);
  A(LastStoreAnswer);
  A(SuspendedAt);
  A(Waiting);
}

} // namespace tp
