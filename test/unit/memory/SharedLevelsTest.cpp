//===- SharedLevelsTest.cpp - Crossbar and L2, by hand --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/chip/MinimumRoundTrip.h"
#include "test/unit/memory/MemoryHarness.h"

#include "gtest/gtest.h"

using namespace tp;
using namespace tp::test;

static constexpr uint32_t A = 0x10000;

/// Five cycles each way; requests of 8 bytes go in one cycle, data back at 16
/// bytes a cycle.
static CrossbarConfig smallCrossbar() {
  CrossbarConfig Crossbar;
  Crossbar.Latency = 5;
  Crossbar.RequestBytesPerCycle = 8;
  Crossbar.AnswerBytesPerCycle = 16;
  Crossbar.HeaderBytes = 8;
  return Crossbar;
}

/// L1 3 and L2 20 cycles, crossbar, memory 100, four TMs, two for each L2.
static ChipConfig fullChip() {
  ChipConfig Chip = smallChip();
  Chip.TmCount = 4;
  Chip.L1 = smallL1();
  Chip.Crossbar = smallCrossbar();
  Chip.L2 = smallL2();
  Chip.TmsPerL2 = 2;
  return Chip;
}

namespace {

// A load of four bytes: there in 10 + 5, memory until 115, back in 120.
TEST(CrossbarTest, AloneInFrontOfMemory) {
  ChipConfig Chip = smallChip();
  Chip.Crossbar = smallCrossbar();
  EXPECT_EQ(minimumRoundTrip(Chip), 110u);
  MemoryHarness M(Chip);
  uint32_t Load = M.load(10, A);
  M.run(200);
  EXPECT_EQ(M.ready(Load), 120u);
  EXPECT_EQ(M.statistics().Crossbar->Requests, 1u);
  EXPECT_EQ(M.statistics().Crossbar->RequestBytes, 8u);
  EXPECT_EQ(M.statistics().Crossbar->AnswerBytes, 4u);
}

// Stores have 8 + 4 bytes, two cycles at the port: the first is there in
// 10 + 1 + 5 and acknowledged in 16 + 100 + 5. The second begins two cycles
// later, the load behind them four.
TEST(CrossbarTest, RequestsQueue) {
  ChipConfig Chip = smallChip();
  Chip.Crossbar = smallCrossbar();
  MemoryHarness M(Chip);
  uint32_t First = M.store(10, A, 0);
  uint32_t Second = M.store(10, A + 64, 1);
  uint32_t Load = M.load(11, A + 128, 0);
  M.run(200);
  EXPECT_EQ(M.ready(First), 121u);
  EXPECT_EQ(M.ready(Second), 123u);
  EXPECT_EQ(M.ready(Load), 14u + 5 + 100 + 5);
  EXPECT_EQ(M.statistics().Crossbar->RequestWaitCycles, 2u + 3);
  EXPECT_EQ(M.statistics().Crossbar->AnswerBytes, 4u);
}

// Two L1 misses of one cycle in different banks: departure in 13, and for the
// second in 14; at memory in 18 and 19, answered in 118 and 119. A sector has
// two cycles at the port: the first is back in 118 + 1 + 5, the second, which
// begins in 120, in 126.
TEST(CrossbarTest, AnswersQueue) {
  ChipConfig Chip = smallChip();
  Chip.L1 = smallL1();
  Chip.Crossbar = smallCrossbar();
  EXPECT_EQ(minimumRoundTrip(Chip), 113u);
  MemoryHarness M(Chip);
  uint32_t First = M.load(10, A, 0);
  uint32_t Second = M.load(10, A + 68, 1);
  M.run(200);
  EXPECT_EQ(M.ready(First), 124u);
  EXPECT_EQ(M.ready(Second), 126u);
  EXPECT_EQ(M.statistics().Crossbar->RequestWaitCycles, 1u);
  EXPECT_EQ(M.statistics().Crossbar->AnswerWaitCycles, 1u);
}

// A request longer than a flit: three cycles for 24 bytes of header.
TEST(CrossbarTest, LongHeader) {
  ChipConfig Chip = smallChip();
  Chip.Crossbar = smallCrossbar();
  Chip.Crossbar->HeaderBytes = 24;
  EXPECT_EQ(minimumRoundTrip(Chip), 2u + 5 + 100 + 5);
  MemoryHarness M(Chip);
  uint32_t Load = M.load(10, A);
  M.run(200);
  EXPECT_EQ(M.ready(Load), 10u + 112);
}

// L2 alone: 20 cycles for a hit, 20 + 100 for a miss.
TEST(L2Test, AloneInFrontOfMemory) {
  ChipConfig Chip = smallChip();
  Chip.L2 = smallL2();
  EXPECT_EQ(minimumRoundTrip(Chip), 20u);
  MemoryHarness M(Chip);
  uint32_t Miss = M.load(10, A);
  uint32_t Merged = M.load(20, A + 4);
  uint32_t Hit = M.load(200, A + 8);
  M.run(300);
  EXPECT_EQ(M.ready(Miss), 130u);
  EXPECT_EQ(M.level(Miss), ServedBy::Memory);
  EXPECT_EQ(M.ready(Merged), 130u);
  EXPECT_EQ(M.ready(Hit), 220u);
  EXPECT_EQ(M.level(Hit), ServedBy::L2);
}

// All levels: departure 13, at the L2 in 18, memory asked in 38, its answer in
// 138, two cycles at the port: back in 138 + 1 + 5. TM 1 has the same L2: from
// issue to the L2 eight cycles, 20 there, six back. TM 2 has another one.
TEST(L2Test, IsSharedByItsTms) {
  MemoryHarness M(fullChip());
  EXPECT_EQ(minimumRoundTrip(fullChip()), 3u + 5 + 20 + 5);
  uint32_t Miss = M.load(10, A, 0, 0);
  uint32_t Hit = M.load(200, A, 0, 1);
  uint32_t Other = M.load(200, A, 0, 2);
  M.run(500);
  EXPECT_EQ(M.ready(Miss), 144u);
  EXPECT_EQ(M.level(Miss), ServedBy::Memory);
  EXPECT_EQ(M.ready(Hit), 200u + 8 + 20 + 6);
  EXPECT_EQ(M.level(Hit), ServedBy::L2);
  EXPECT_EQ(M.ready(Other), 200u + 8 + 120 + 6);
  EXPECT_EQ(M.statistics().L2->Loads, 3u);
  EXPECT_EQ(M.statistics().L2->Hits, 1u);
  EXPECT_EQ(M.statistics().L2->Misses, 2u);
}

// Sectors A and A + 64 are in L2 bank 0, A + 32 is in bank 1. TM 0's atomic has
// 12 bytes, two cycles at its port, and is at the L2 in 300 + 3 + 1 + 5, TM 1's
// loads in 308 and 309. Of the two of cycle 309 the lower TM's goes first.
TEST(L2Test, BankConflict) {
  MemoryHarness M(fullChip());
  M.load(0, A);
  M.load(0, A + 36, 1);
  M.load(0, A + 64, 2);
  uint32_t Second = M.load(300, A + 64, 0, 1);
  uint32_t Third = M.load(301, A, 0, 1);
  M.request(RequestKind::Atomic, 300, A, 0, 0);
  M.run(500);
  EXPECT_EQ(M.ready(Second), 308u + 20 + 6);
  EXPECT_EQ(M.ready(Third), 310u + 20 + 6);
  EXPECT_EQ(M.statistics().L2->BankConflicts, 1u);
}

// At the L2 in 18 resp. 209: a miss, then a hit, of which four bytes come back
// in one cycle at the port.
TEST(L2Test, Atomics) {
  MemoryHarness M(fullChip());
  uint32_t Miss = M.request(RequestKind::Atomic, 9, A);
  uint32_t Hit = M.request(RequestKind::Atomic, 200, A);
  M.run(500);
  EXPECT_EQ(M.ready(Miss), 18u + 120 + 5);
  EXPECT_EQ(M.level(Miss), ServedBy::Memory);
  EXPECT_EQ(M.ready(Hit), 209u + 20 + 5);
  EXPECT_EQ(M.level(Hit), ServedBy::L2);
  CacheStatistics Counts = *M.statistics().L2;
  EXPECT_EQ(Counts.Atomics, 2u);
  EXPECT_EQ(Counts.Hits, 1u);
  EXPECT_EQ(Counts.Misses, 1u);
  EXPECT_EQ(Counts.BytesWritten, 8u);
}

// A write-back L2 keeps the store: there in 10 + 3 + 1 + 5, a miss, and 100
// later the answer, which has no bytes. The next store hits.
TEST(L2Test, StoresToWriteBack) {
  ChipConfig Chip = fullChip();
  Chip.L2->Writes = WritePolicy::Back;
  MemoryHarness M(Chip);
  uint32_t Miss = M.store(10, A);
  uint32_t Hit = M.store(200, A);
  M.run(500);
  EXPECT_EQ(M.ready(Miss), 19u + 120 + 5);
  EXPECT_EQ(M.ready(Hit), 209u + 20 + 5);
  EXPECT_EQ(M.statistics().L2->StoreHits, 1u);
  EXPECT_EQ(M.statistics().L2->BytesRead, 32u);
  EXPECT_EQ(M.statistics().L2->BytesWritten, 0u);
}

// A write-through L2 passes it on, hit or miss.
TEST(L2Test, StoresToWriteThrough) {
  MemoryHarness M(fullChip());
  uint32_t Store = M.store(10, A);
  M.run(300);
  EXPECT_EQ(M.ready(Store), 19u + 20 + 100 + 5);
  EXPECT_EQ(M.statistics().L2->BytesRead, 0u);
  EXPECT_EQ(M.statistics().L2->BytesWritten, 4u);
}

// What a write-back L1 evicts fills a whole sector of the L2: nothing is
// fetched for it. It is not in the L2 before, because what came for the L1's
// store was evicted by four other lines of the set.
TEST(L2Test, WholeSectorsAreNotFetched) {
  ChipConfig Chip = fullChip();
  Chip.L1->Writes = WritePolicy::Back;
  Chip.L2->Writes = WritePolicy::Back;
  MemoryHarness M(Chip);
  M.store(0, A);
  for (uint32_t I = 1; I <= 4; ++I)
    M.load(I * 200, A + I * 1024, 0, 1);
  M.load(1000, A + 512);
  M.load(1200, A + 1536);
  M.run(1500);
  CacheStatistics Counts = *M.statistics().L2;
  EXPECT_EQ(Counts.Stores, 1u);
  EXPECT_EQ(Counts.StoreHits, 0u);
  EXPECT_EQ(Counts.Loads, 7u);
  EXPECT_EQ(Counts.BytesRead, 7u * 32);
  EXPECT_EQ(Counts.WritebackBytes, 0u);
}

// The L1's sector of 64 bytes is two of the L2, in two banks: both answers
// depart in 138; the second waits two cycles for the port.
TEST(L2Test, LargerSectorsInTheL1) {
  ChipConfig Chip = fullChip();
  Chip.L1->SectorBytes = 64;
  MemoryHarness M(Chip);
  uint32_t Load = M.load(10, A);
  uint32_t Hit = M.load(200, A + 60);
  M.run(300);
  EXPECT_EQ(M.ready(Load), 146u);
  EXPECT_EQ(M.ready(Hit), 203u);
  EXPECT_EQ(M.statistics().L2->Loads, 2u);
  EXPECT_EQ(M.statistics().SentByTms, 2u);
}

// A line of instructions: 64 bytes, both sectors.
TEST(L2Test, Fetch) {
  MemoryHarness M(fullChip());
  uint32_t Fetch = M.request(RequestKind::Fetch, 10, A, 0, 0, 64);
  M.run(300);
  EXPECT_EQ(M.ready(Fetch), 146u);
  EXPECT_EQ(M.statistics().L2->Fetches, 2u);
}

} // namespace

/// GDDR-like times at the chip's clock: a read of an open row takes
/// 10 + 4 + 6 cycles, of a closed bank 12 more.
static DramConfig smallDram() {
  DramConfig Dram;
  Dram.ClockKHz = 1000000;
  Dram.Channels = 2;
  Dram.BankGroups = 1;
  Dram.BanksPerGroup = 2;
  Dram.BurstBytes = 32;
  Dram.BurstTicks = 4;
  Dram.ClTicks = 10;
  Dram.CwlTicks = 4;
  Dram.RcdReadTicks = Dram.RcdWriteTicks = 12;
  Dram.RpTicks = 12;
  Dram.RasTicks = 28;
  Dram.CcdShortTicks = Dram.CcdLongTicks = 4;
  Dram.ControllerCycles = 6;
  return Dram;
}

static ChipConfig withDram(ChipConfig Chip) {
  Chip.Dram = smallDram();
  return Chip;
}

namespace {

TEST(DramPathTest, AloneIsAskedByTheTms) {
  MemoryHarness M(withDram(smallChip()));
  EXPECT_EQ(minimumRoundTrip(withDram(smallChip())), 20u);
  uint32_t Load = M.load(100, A);
  uint32_t RowHit = M.load(300, A + 64);
  uint32_t Store = M.store(500, A);
  M.run(1000);
  EXPECT_EQ(M.ready(Load), 132u);
  EXPECT_EQ(M.level(Load), ServedBy::DramRowMiss);
  EXPECT_EQ(M.ready(RowHit), 320u);
  EXPECT_EQ(M.level(RowHit), ServedBy::DramRowHit);
  // A write is answered as long after its place in the queue as the fastest
  // read.
  EXPECT_EQ(M.ready(Store), 520u);
  EXPECT_EQ(M.level(Store), ServedBy::DramQueue);
}

// What is said of each read is what the channel counts.
TEST(DramPathTest, LevelsAreThoseOfTheChannel) {
  MemoryHarness M(withDram(smallChip()));
  std::map<ServedBy, uint64_t> Levels;
  std::vector<uint32_t> Loads;
  for (uint32_t I = 0; I != 60; ++I)
    Loads.push_back(M.load(100 + I * 20, A + I * I % 7 * 0x10000 + I % 3 * 64));
  M.run(4000);
  for (uint32_t Load : Loads)
    ++Levels[M.level(Load)];
  DramChannelStatistics Sum;
  for (const DramChannelStatistics &Channel : M.statistics().DramChannels) {
    Sum.RowHits += Channel.RowHits;
    Sum.RowMisses += Channel.RowMisses;
    Sum.RowConflicts += Channel.RowConflicts;
  }
  EXPECT_EQ(Levels[ServedBy::DramRowHit], Sum.RowHits);
  EXPECT_EQ(Levels[ServedBy::DramRowMiss], Sum.RowMisses);
  EXPECT_EQ(Levels[ServedBy::DramRowConflict], Sum.RowConflicts);
  EXPECT_GT(Sum.RowHits, 0u);
  EXPECT_GT(Sum.RowMisses, 0u);
  EXPECT_GT(Sum.RowConflicts, 0u);
}

TEST(DramPathTest, AtomicsReadAndWrite) {
  MemoryHarness M(withDram(smallChip()));
  uint32_t Atomic = M.request(RequestKind::Atomic, 100, A);
  M.run(1000);
  EXPECT_EQ(M.ready(Atomic), 132u);
  uint64_t Reads = 0, Writes = 0;
  for (const DramChannelStatistics &Channel : M.statistics().DramChannels) {
    Reads += Channel.Reads;
    Writes += Channel.Writes;
  }
  EXPECT_EQ(Reads, 1u);
  EXPECT_EQ(Writes, 1u);
  EXPECT_EQ(M.statistics().SentByTms, 2u);
}

// Time passes in the channels also while nobody asks them.
TEST(DramPathTest, TicksGoOnWhileIdle) {
  MemoryHarness M(withDram(smallChip()));
  M.load(100, A);
  M.run(1600);
  for (const DramChannelStatistics &Channel : M.statistics().DramChannels)
    EXPECT_EQ(Channel.Ticks, 1600u);
}

// As IsSharedByItsTms, with 32 cycles in memory in place of 100.
TEST(DramPathTest, BehindAllLevels) {
  ChipConfig Chip = withDram(fullChip());
  EXPECT_EQ(minimumRoundTrip(Chip), 33u);
  MemoryHarness M(Chip);
  uint32_t Miss = M.load(10, A);
  uint32_t Hit = M.load(200, A, 0, 1);
  M.run(500);
  EXPECT_EQ(M.ready(Miss), 38u + 32 + 6);
  EXPECT_EQ(M.level(Miss), ServedBy::DramRowMiss);
  EXPECT_EQ(M.ready(Hit), 234u);
}

// A sector of two bursts, one in each channel; it is there with the last.
TEST(DramPathTest, SectorsOfSeveralBursts) {
  ChipConfig Chip = withDram(smallChip());
  Chip.L2 = smallL2();
  Chip.L2->SectorBytes = 64;
  MemoryHarness M(Chip);
  uint32_t Load = M.load(10, A);
  M.run(500);
  EXPECT_EQ(M.ready(Load), 30u + 32);
  EXPECT_EQ(M.level(Load), ServedBy::DramRowMiss);
  EXPECT_EQ(M.statistics().SentByL2s, 2u);
  EXPECT_EQ(M.statistics().DramChannels[0].Reads, 1u);
  EXPECT_EQ(M.statistics().DramChannels[1].Reads, 1u);
}

// Every combination of levels: a load's way is the sum of theirs, and no
// window longer than the shortest round trip is needed.
TEST(CombinationsTest, EveryLevelMayBeAbsent) {
  for (unsigned Levels = 1; Levels != 16; ++Levels) {
    SCOPED_TRACE(Levels);
    ChipConfig Chip = smallChip();
    uint64_t Expected = 10;
    if (Levels & 1) {
      Chip.L1 = smallL1();
      Expected += 3;
    }
    if (Levels & 2) {
      Chip.Crossbar = smallCrossbar();
      // An L1's sector has two cycles at the port back.
      Expected += 5 + 5 + (Levels & 1 ? 1 : 0);
    }
    if (Levels & 4) {
      Chip.L2 = smallL2();
      Expected += 20;
    }
    if (Levels & 8)
      Chip.Dram = smallDram();
    Expected += Levels & 8 ? 32 : 100;
    Chip.ArbitrationWindow = uint32_t(minimumRoundTrip(Chip));
    MemoryHarness M(Chip);
    uint32_t Load = M.load(10, A);
    M.run(400);
    EXPECT_EQ(M.ready(Load), Expected);
  }
  EXPECT_EQ(makeMemorySystem(smallChip()), nullptr);
}

} // namespace
