//===- RandomMemoryTest.cpp - The memory system against its rules ---------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Random chips and requests: all answers and counts as in NaiveMemory, however
// long the windows are, in whatever order requests are made and with a
// checkpoint in the middle.
//
//===----------------------------------------------------------------------===//

#include "simulator/chip/MinimumRoundTrip.h"
#include "test/unit/memory/NaiveMemory.h"

#include "gtest/gtest.h"

#include <algorithm>
#include <random>

using namespace tp;
using namespace tp::test;

namespace {

class Random {
public:
  explicit Random(unsigned Seed) : Bits(Seed) {}
  /// One of [0, Count).
  uint32_t below(uint32_t Count) { return uint32_t(Bits() % Count); }
  uint32_t between(uint32_t Least, uint32_t Most) {
    return Least + below(Most - Least + 1);
  }
  uint32_t powerOfTwo(uint32_t LeastLog, uint32_t MostLog) {
    return 1u << between(LeastLog, MostLog);
  }
  bool oneIn(uint32_t Count) { return below(Count) == 0; }

private:
  std::mt19937 Bits;
};

} // namespace

static CacheConfig randomCache(Random &R, uint32_t MostLatency) {
  CacheConfig Cache;
  Cache.LineBytes = R.powerOfTwo(5, 7);
  Cache.SectorBytes = std::min(Cache.LineBytes, R.powerOfTwo(4, 6));
  Cache.Ways = R.between(1, 4);
  Cache.Bytes = uint64_t(Cache.LineBytes) * Cache.Ways * R.powerOfTwo(0, 3);
  Cache.Banks = R.powerOfTwo(0, 3);
  Cache.BankBytes = R.powerOfTwo(2, 6);
  Cache.Latency = R.between(1, MostLatency);
  Cache.MissRegisters = R.between(1, 6);
  Cache.MergesPerMiss = R.between(1, 4);
  Cache.Writes = R.oneIn(2) ? WritePolicy::Through : WritePolicy::Back;
  return Cache;
}

static DramConfig randomDram(Random &R) {
  DramConfig Dram;
  Dram.ClockKHz = R.between(500000, 2000000);
  Dram.Channels = R.between(1, 3);
  Dram.BankGroups = 2;
  Dram.BanksPerGroup = 2;
  Dram.RowBytes = 256;
  Dram.BurstBytes = R.powerOfTwo(4, 6);
  Dram.BurstTicks = R.between(1, 4);
  Dram.ClTicks = R.between(4, 12);
  Dram.CwlTicks = R.between(1, 4);
  Dram.RcdReadTicks = Dram.RcdWriteTicks = R.between(3, 12);
  Dram.RpTicks = R.between(3, 12);
  Dram.RasTicks = R.between(12, 30);
  Dram.CcdShortTicks = Dram.CcdLongTicks = Dram.BurstTicks;
  Dram.ReadQueueEntries = Dram.WriteQueueEntries = R.between(4, 8);
  Dram.WriteHighMark = 4;
  Dram.WriteLowMark = 2;
  Dram.ControllerCycles = R.between(0, 9);
  return Dram;
}

static ChipConfig randomChip(Random &R) {
  ChipConfig Chip = smallChip();
  Chip.TmCount = R.between(1, 5);
  Chip.TpsPerTm = R.between(1, 6);
  Chip.MemoryLatency = R.between(5, 60);
  Chip.ClockGHz = R.oneIn(2) ? 1 : 1.3;
  do {
    Chip.L1.reset();
    Chip.Crossbar.reset();
    Chip.L2.reset();
    Chip.Dram.reset();
    if (R.oneIn(2))
      Chip.L1 = randomCache(R, 5);
    if (R.oneIn(2)) {
      Chip.Crossbar.emplace();
      Chip.Crossbar->Latency = R.between(1, 10);
      Chip.Crossbar->RequestBytesPerCycle = R.powerOfTwo(1, 4);
      Chip.Crossbar->AnswerBytesPerCycle = R.powerOfTwo(1, 6);
      Chip.Crossbar->HeaderBytes = R.between(1, 9);
    }
    if (R.oneIn(2)) {
      Chip.L2 = randomCache(R, 25);
      Chip.TmsPerL2 = R.between(1, Chip.TmCount);
    }
    if (R.oneIn(2))
      Chip.Dram = randomDram(R);
  } while (!Chip.hasMemorySystem());
  return Chip;
}

/// By TPs that issue at most one request in a cycle, in bursts with gaps.
static std::vector<TmRequest> randomRequests(Random &R, const ChipConfig &Chip,
                                             uint64_t Cycles) {
  std::vector<TmRequest> Requests;
  uint32_t Span = R.powerOfTwo(8, 13);
  uint32_t Density = R.between(1, 20);
  uint32_t Stores = R.between(2, 12);
  bool IsBusy = true;
  for (uint64_t Cycle = 0; Cycle != Cycles; ++Cycle) {
    if (R.oneIn(100))
      IsBusy = !IsBusy;
    for (uint32_t Tm = 0; IsBusy && Tm != Chip.TmCount; ++Tm)
      for (uint32_t Tp = 0; Tp != Chip.TpsPerTm; ++Tp) {
        if (!R.oneIn(Density + 3 * Chip.TpsPerTm))
          continue;
        auto Kind = RequestKind::Load;
        if (R.oneIn(Stores))
          Kind = RequestKind::Store;
        else if (R.oneIn(10))
          Kind = RequestKind::Atomic;
        else if (R.oneIn(10))
          Kind = RequestKind::Fetch;
        uint32_t Bytes = Kind == RequestKind::Fetch ? 64 : 4;
        uint32_t Address = 0x10000 + R.below(Span / Bytes) * Bytes;
        auto Ticket = uint32_t(Requests.size());
        auto Priority = uint16_t(Tp);
        Requests.push_back({Tm,
                            {Cycle, Address, Ticket, Priority, Priority,
                             uint16_t(Bytes), Kind}});
      }
  }
  return Requests;
}

static Outcomes naiveOutcomes(const ChipConfig &Chip,
                              const std::vector<TmRequest> &Requests,
                              MemoryStatistics &Counts) {
  NaiveMemory Naive(Chip);
  auto Next = Requests.begin();
  uint64_t Idle = 0;
  for (uint64_t Cycle = 0; Idle != 3000; ++Cycle) {
    std::vector<TmRequest> Issued;
    for (; Next != Requests.end() && Next->Request.Cycle == Cycle; ++Next)
      Issued.push_back(*Next);
    Naive.tick(std::move(Issued));
    Idle = Next == Requests.end() && Naive.Answered.size() == Requests.size()
               ? Idle + 1
               : 0;
    if (Cycle > 400000) {
      ADD_FAILURE() << "requests without answer";
      break;
    }
  }
  Counts = Naive.statistics();
  return Naive.Answered;
}

/// Runs until nothing is left to do.
static void runRandomWindows(Random &R, const ChipConfig &Chip,
                             MemoryHarness &M, size_t Requests) {
  auto Longest = uint32_t(minimumRoundTrip(Chip));
  bool Skips = R.oneIn(2);
  while (M.outcomes().size() != Requests || M.nextEvent() != ~uint64_t(0)) {
    uint64_t Begin = M.end();
    if (Skips && M.nextEvent() != ~uint64_t(0))
      Begin = std::max(Begin, M.nextEvent());
    uint64_t End = Begin + R.between(1, Longest);
    std::vector<uint64_t> Stops;
    for (uint64_t Stop = Begin; Stop < End; Stop += R.between(1, 8))
      Stops.push_back(Stop);
    M.runWindow(End, Stops);
    if (End > 400000) {
      ADD_FAILURE() << "requests without answer";
      return;
    }
  }
}

static void expectSame(const std::optional<CacheStatistics> &A,
                       const std::optional<CacheStatistics> &B) {
  ASSERT_EQ(A.has_value(), B.has_value());
  if (!A)
    return;
  EXPECT_EQ(A->Loads, B->Loads);
  EXPECT_EQ(A->Stores, B->Stores);
  EXPECT_EQ(A->Atomics, B->Atomics);
  EXPECT_EQ(A->Fetches, B->Fetches);
  EXPECT_EQ(A->Hits, B->Hits);
  EXPECT_EQ(A->Misses, B->Misses);
  EXPECT_EQ(A->SectorMisses, B->SectorMisses);
  EXPECT_EQ(A->Merged, B->Merged);
  EXPECT_EQ(A->StoreHits, B->StoreHits);
  EXPECT_EQ(A->BankConflicts, B->BankConflicts);
  EXPECT_EQ(A->BankConflictCycles, B->BankConflictCycles);
  EXPECT_EQ(A->MissRegisterWaitCycles, B->MissRegisterWaitCycles);
}

/// Fails the test with the earliest difference.
static void expectSame(const Outcomes &A, const Outcomes &Rules) {
  const Outcomes::value_type *First = nullptr;
  for (const Outcomes::value_type &Entry : Rules) {
    auto Found = A.find(Entry.first);
    bool IsSame = Found != A.end() && Found->second == Entry.second;
    if (!IsSame &&
        (!First || Entry.second.ReadyCycle < First->second.ReadyCycle))
      First = &Entry;
  }
  EXPECT_EQ(A.size(), Rules.size());
  if (First)
    ADD_FAILURE() << "ticket " << First->first << " is ready in "
                  << (A.count(First->first) ? A.at(First->first).ReadyCycle : 0)
                  << ", by the rules in " << First->second.ReadyCycle;
}

namespace {

class RandomMemoryTest : public testing::TestWithParam<unsigned> {};

TEST_P(RandomMemoryTest, LikeTheRules) {
  for (unsigned Seed = GetParam() * 50; Seed != GetParam() * 50 + 50; ++Seed) {
    SCOPED_TRACE("seed " + std::to_string(Seed));
    Random R(Seed);
    ChipConfig Chip = randomChip(R);
    uint64_t Cycles = 1000;
    std::vector<TmRequest> Requests = randomRequests(R, Chip, Cycles);
    MemoryStatistics Expected;
    Outcomes Naive = naiveOutcomes(Chip, Requests, Expected);

    MemoryHarness M(Chip);
    for (const TmRequest &Request : Requests)
      M.add(Request);
    runRandomWindows(R, Chip, M, Requests.size());
    MemoryStatistics Counts = M.statistics();
    expectSame(M.outcomes(), Naive);
    expectSame(Counts.L1, Expected.L1);
    expectSame(Counts.L2, Expected.L2);
    EXPECT_EQ(Counts.SentByTmsUnderWay, 0u);
    EXPECT_EQ(Counts.SentByL2sUnderWay, 0u);
    uint64_t Bursts = 0;
    for (size_t I = 0; I != Counts.DramChannels.size(); ++I) {
      const DramChannelStatistics &C = Counts.DramChannels[I];
      EXPECT_EQ(C.Reads, Expected.DramChannels[I].Reads);
      EXPECT_EQ(C.Writes, Expected.DramChannels[I].Writes);
      EXPECT_EQ(C.ReadLatencySum, Expected.DramChannels[I].ReadLatencySum);
      Bursts += C.Reads + C.Writes + C.ForwardedReads + C.MergedWrites;
    }
    if (Chip.Dram) {
      EXPECT_EQ(Bursts, Chip.L2 ? Counts.SentByL2s : Counts.SentByTms);
    }
    if (HasFailure())
      return;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomMemoryTest, testing::Range(0u, 8u));

TEST(MemoryCheckpointTest, ContinuesIdentically) {
  for (unsigned Seed = 1000; Seed != 1050; ++Seed) {
    SCOPED_TRACE("seed " + std::to_string(Seed));
    Random R(Seed);
    ChipConfig Chip = randomChip(R);
    Chip.ArbitrationWindow = uint32_t(minimumRoundTrip(Chip));
    std::vector<TmRequest> Requests = randomRequests(R, Chip, 1000);
    uint64_t Middle = 500 / Chip.ArbitrationWindow * Chip.ArbitrationWindow;
    MemoryHarness Whole(Chip), Begin(Chip), Rest(Chip);
    for (const TmRequest &Request : Requests) {
      Whole.add(Request);
      (Request.Request.Cycle < Middle ? Begin : Rest).add(Request);
    }
    Whole.run(20000);
    Begin.run(Middle);
    Rest.continueFrom(Begin);
    Rest.run(20000);
    Outcomes Parts = Begin.outcomes();
    Parts.insert(Rest.outcomes().begin(), Rest.outcomes().end());
    expectSame(Parts, Whole.outcomes());
    expectSame(Rest.statistics().L1, Whole.statistics().L1);
    expectSame(Rest.statistics().L2, Whole.statistics().L2);
    if (HasFailure())
      return;
  }
}

} // namespace
