//===- ScriptedMemory.cpp - A memory system that does as told -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/core/ScriptedMemory.h"

#include "gtest/gtest.h"

#include <algorithm>

namespace tp::test {

namespace {

class ScriptedTm final : public TmMemory {
public:
  explicit ScriptedTm(uint32_t L1Latency) : L1Latency(L1Latency) {}

  void request(const MemoryRequest &Request) override {
    EXPECT_GE(Request.Cycle, Decided);
    Waiting.push_back(Request);
  }

  void advance(uint64_t Cycle, std::vector<MemoryAnswer> &Answers) override {
    std::sort(Waiting.begin(), Waiting.end(), comesBefore);
    auto Next = Waiting.begin();
    for (; Next != Waiting.end(); ++Next) {
      if (Next->Kind == RequestKind::Fetch && Next->Cycle < Cycle) {
        Late.push_back(
            {Next->Cycle + 30, Next->Ticket, Next->Tp, ServedBy::L2});
        continue;
      }
      uint64_t Start = std::max(Next->Cycle, FreeFrom);
      if (Start >= Cycle)
        break;
      if (L1Latency != 0)
        FreeFrom = Start + 1;
      serve(*Next, Start, Answers);
    }
    Waiting.erase(Waiting.begin(), Next);
    Decided = Cycle;
  }

  void takeAnswers(std::vector<MemoryAnswer> &Answers) override {
    Answers.insert(Answers.end(), Late.begin(), Late.end());
    Late.clear();
  }
  bool hasAnswers() const override { return !Late.empty(); }

  uint64_t nextEvent() const override {
    uint64_t Next = ~uint64_t(0);
    for (const MemoryRequest &Request : Waiting)
      Next = std::min(Next, std::max(Request.Cycle, FreeFrom));
    return Next;
  }

private:
  static bool comesBefore(const MemoryRequest &A, const MemoryRequest &B) {
    return std::pair(A.Cycle, A.Priority) < std::pair(B.Cycle, B.Priority);
  }

  void serve(const MemoryRequest &Request, uint64_t Start,
             std::vector<MemoryAnswer> &Answers) {
    uint32_t Block = (Request.Address - DataBegin) / 256;
    if (Block == 0 && L1Latency != 0 && Request.Kind != RequestKind::Atomic)
      return Answers.push_back(
          {Start + L1Latency, Request.Ticket, Request.Tp, ServedBy::L1});
    if (Request.Kind != RequestKind::Atomic)
      Answers.push_back(
          {AnsweredLater, Request.Ticket, Request.Tp, ServedBy::L1});
    ServedBy Level = Block < 5    ? ServedBy::L2
                     : Block < 10 ? ServedBy::Memory
                                  : ServedBy::DramRowConflict;
    Late.push_back({Start + 10 * Block, Request.Ticket, Request.Tp, Level});
  }

  uint32_t L1Latency;
  uint64_t Decided = 0;
  uint64_t FreeFrom = 0;
  std::vector<MemoryRequest> Waiting;
  std::vector<MemoryAnswer> Late;
};

class ScriptedSystem final : public MemorySystem {
public:
  explicit ScriptedSystem(const ChipConfig &Chip)
      : Tms(Chip.TmCount, ScriptedTm(Chip.L1 ? Chip.L1->Latency : 0)) {}

  TmMemory &tm(uint32_t Tm) override { return Tms[Tm]; }
  unsigned stages() const override { return 0; }
  unsigned parts(unsigned) const override { return 0; }
  void runPart(unsigned, unsigned, uint64_t) override {}
  uint64_t nextEvent() const override { return ~uint64_t(0); }
  MemoryStatistics statistics(uint64_t) const override { return {}; }
  void serialize(Archive &) override {}

private:
  std::vector<ScriptedTm> Tms;
};

} // namespace

ChipConfig ScriptedMemory::chip(uint32_t TmCount, uint32_t TpsPerTm,
                                uint32_t L1Latency) {
  ChipConfig Chip = quietChip(TmCount, TpsPerTm);
  Chip.L2.emplace();
  Chip.StoreBufferEntries = 2;
  if (L1Latency != 0)
    Chip.L1.emplace().Latency = L1Latency;
  return Chip;
}

std::unique_ptr<MemorySystem> ScriptedMemory::make(const ChipConfig &Chip) {
  return std::make_unique<ScriptedSystem>(Chip);
}

} // namespace tp::test
