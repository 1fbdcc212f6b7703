//===- MemoryHarness.cpp - Requests to a memory system --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/memory/MemoryHarness.h"

#include "gtest/gtest.h"

#include <algorithm>

namespace tp::test {

uint32_t MemoryHarness::request(RequestKind Kind, uint64_t Cycle,
                                uint32_t Address, uint16_t Priority,
                                uint32_t Tm, uint16_t Bytes) {
  uint32_t Ticket = NextTicket++;
  add({Tm, {Cycle, Address, Ticket, Priority, Priority, Bytes, Kind}});
  return Ticket;
}

void MemoryHarness::askBefore(uint32_t Tm, uint64_t Limit) {
  std::erase_if(Pending[Tm], [&](const MemoryRequest &Request) {
    if (Request.Cycle >= Limit)
      return false;
    System->tm(Tm).request(Request);
    ++Asked;
    return true;
  });
}

void MemoryHarness::runWindow(uint64_t WindowEnd,
                              const std::vector<uint64_t> &Stops) {
  for (uint32_t Tm = 0; Tm != Pending.size(); ++Tm) {
    TmMemory &Memory = System->tm(Tm);
    std::vector<MemoryAnswer> Answers;
    for (uint64_t Stop : Stops) {
      askBefore(Tm, Stop);
      Memory.advance(Stop, Answers);
    }
    askBefore(Tm, WindowEnd);
    Memory.advance(WindowEnd, Answers);
    note(Answers);
  }
  // As the engine: nothing is done while nobody waits and nothing happens.
  bool IsIdle = Asked == Answered.size() && System->nextEvent() >= WindowEnd;
  for (unsigned Stage = 0; !IsIdle && Stage != System->stages(); ++Stage)
    for (unsigned Part = 0; Part != System->parts(Stage); ++Part)
      System->runPart(Stage, Part, WindowEnd);
  for (uint32_t Tm = 0; Tm != Pending.size(); ++Tm) {
    std::vector<MemoryAnswer> Answers;
    bool HasAnswers = System->tm(Tm).hasAnswers();
    System->tm(Tm).takeAnswers(Answers);
    EXPECT_EQ(HasAnswers, !Answers.empty());
    for (const MemoryAnswer &Answer : Answers)
      EXPECT_GE(Answer.ReadyCycle, WindowEnd);
    note(Answers);
  }
  End = WindowEnd;
}

uint64_t MemoryHarness::nextEvent() const {
  uint64_t Next = System->nextEvent();
  for (uint32_t Tm = 0; Tm != Pending.size(); ++Tm) {
    Next = std::min(Next, System->tm(Tm).nextEvent());
    for (const MemoryRequest &Request : Pending[Tm])
      Next = std::min(Next, Request.Cycle);
  }
  return Next;
}

void MemoryHarness::note(const std::vector<MemoryAnswer> &Answers) {
  for (const MemoryAnswer &Answer : Answers) {
    if (Answer.ReadyCycle == AnsweredLater)
      continue;
    bool IsFirst =
        Answered.insert({Answer.Ticket, {Answer.ReadyCycle, Answer.Level}})
            .second;
    EXPECT_TRUE(IsFirst) << "ticket " << Answer.Ticket << " answered twice";
  }
}

Outcome MemoryHarness::outcome(uint32_t Ticket) const {
  auto Found = Answered.find(Ticket);
  EXPECT_NE(Found, Answered.end()) << "ticket " << Ticket << " not answered";
  return Found == Answered.end() ? Outcome() : Found->second;
}

ChipConfig smallChip() {
  ChipConfig Chip;
  Chip.TmCount = 1;
  Chip.TpsPerTm = 16;
  Chip.ArbitrationWindow = 16;
  Chip.MemoryBytes = 1 << 20;
  Chip.MemoryLatency = 100;
  return Chip;
}

CacheConfig smallL1() {
  CacheConfig Cache;
  Cache.Bytes = 1024;
  Cache.LineBytes = 64;
  Cache.SectorBytes = 32;
  Cache.Ways = 2;
  Cache.Banks = 2;
  Cache.BankBytes = 4;
  Cache.Latency = 3;
  Cache.MissRegisters = 8;
  Cache.MergesPerMiss = 8;
  return Cache;
}

CacheConfig smallL2() {
  CacheConfig Cache = smallL1();
  Cache.Bytes = 4096;
  Cache.Ways = 4;
  Cache.BankBytes = 32;
  Cache.Latency = 20;
  return Cache;
}

} // namespace tp::test
