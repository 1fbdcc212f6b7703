//===- L1Test.cpp - Timing of the L1, by hand -----------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// smallL1() in front of memory of 100 cycles: a hit in cycle c is ready in
// c + 3, a miss departs in c + 3 and its sector arrives in c + 103.
//
//===----------------------------------------------------------------------===//

#include "test/unit/memory/MemoryHarness.h"

#include "gtest/gtest.h"

using namespace tp;
using namespace tp::test;

static constexpr uint32_t A = 0x10000;
/// Other lines of A's set.
static constexpr uint32_t B = A + 512;
static constexpr uint32_t C = A + 1024;

static ChipConfig chipWithL1(CacheConfig L1 = smallL1()) {
  ChipConfig Chip = smallChip();
  Chip.L1 = L1;
  return Chip;
}

static CacheConfig writeBack() {
  CacheConfig L1 = smallL1();
  L1.Writes = WritePolicy::Back;
  return L1;
}

namespace {

TEST(L1Test, MissThenHit) {
  MemoryHarness M(chipWithL1());
  uint32_t Miss = M.load(10, A);
  uint32_t Hit = M.load(200, A + 28);
  M.run(400);
  EXPECT_EQ(M.ready(Miss), 113u);
  EXPECT_EQ(M.level(Miss), ServedBy::Memory);
  EXPECT_EQ(M.ready(Hit), 203u);
  EXPECT_EQ(M.level(Hit), ServedBy::L1);
  CacheStatistics Counts = *M.statistics().L1;
  EXPECT_EQ(Counts.Loads, 2u);
  EXPECT_EQ(Counts.Hits, 1u);
  EXPECT_EQ(Counts.Misses, 1u);
  EXPECT_EQ(Counts.SectorMisses, 0u);
  EXPECT_EQ(Counts.BytesRead, 32u);
}

// The sector is there from cycle 113 on. What comes before joins the miss, and
// is not ready before a hit would be.
TEST(L1Test, Merge) {
  MemoryHarness M(chipWithL1());
  M.load(10, A);
  uint32_t Early = M.load(20, A);
  uint32_t Late = M.load(112, A);
  uint32_t Hit = M.load(113, A);
  M.run(400);
  EXPECT_EQ(M.ready(Early), 113u);
  EXPECT_EQ(M.level(Early), ServedBy::Memory);
  EXPECT_EQ(M.ready(Late), 115u);
  EXPECT_EQ(M.level(Late), ServedBy::Memory);
  EXPECT_EQ(M.ready(Hit), 116u);
  EXPECT_EQ(M.level(Hit), ServedBy::L1);
  CacheStatistics Counts = *M.statistics().L1;
  EXPECT_EQ(Counts.Merged, 2u);
  EXPECT_EQ(Counts.Hits, 1u);
  EXPECT_EQ(Counts.Misses, 1u);
}

TEST(L1Test, SectorMiss) {
  MemoryHarness M(chipWithL1());
  M.load(10, A);
  uint32_t OtherSector = M.load(200, A + 32);
  uint32_t First = M.load(400, A);
  M.run(500);
  EXPECT_EQ(M.ready(OtherSector), 303u);
  EXPECT_EQ(M.ready(First), 403u);
  EXPECT_EQ(M.statistics().L1->SectorMisses, 1u);
  EXPECT_EQ(M.statistics().L1->Misses, 2u);
  EXPECT_EQ(M.statistics().L1->Evictions, 0u);
}

// Banks are of four bytes: A and A + 8 are in bank 0, A + 4 in bank 1.
TEST(L1Test, BankConflict) {
  MemoryHarness M(chipWithL1());
  M.load(10, A);
  uint32_t Third = M.load(200, A + 16, 5);
  uint32_t Second = M.load(200, A + 8, 3);
  uint32_t First = M.load(200, A, 1);
  uint32_t OtherBank = M.load(200, A + 4, 7);
  uint32_t Next = M.load(201, A, 0);
  M.run(400);
  EXPECT_EQ(M.ready(First), 203u);
  EXPECT_EQ(M.ready(OtherBank), 203u);
  EXPECT_EQ(M.ready(Second), 204u);
  EXPECT_EQ(M.ready(Third), 205u);
  EXPECT_EQ(M.ready(Next), 206u);
  EXPECT_EQ(M.statistics().L1->BankConflicts, 3u);
  EXPECT_EQ(M.statistics().L1->BankConflictCycles, 1u + 2 + 2);
}

// With one register B waits for A's sector, 113, and departs in 116. A + 8
// stands behind it in bank 0; bank 1 goes on.
TEST(L1Test, MissRegistersFull) {
  CacheConfig L1 = smallL1();
  L1.MissRegisters = 1;
  MemoryHarness M(chipWithL1(L1));
  M.load(10, A);
  uint32_t Blocked = M.load(11, B);
  uint32_t Behind = M.load(12, A + 8);
  uint32_t OtherBank = M.load(12, A + 4);
  M.run(400);
  EXPECT_EQ(M.ready(OtherBank), 113u);
  EXPECT_EQ(M.ready(Blocked), 216u);
  EXPECT_EQ(M.ready(Behind), 117u);
  EXPECT_EQ(M.level(Behind), ServedBy::L1);
  EXPECT_EQ(M.statistics().L1->MissRegisterWaitCycles, 113u - 11);
  EXPECT_EQ(M.statistics().L1->BankConflicts, 1u);
  EXPECT_EQ(M.statistics().L1->BankConflictCycles, 114u - 12);
}

TEST(L1Test, MergesFull) {
  CacheConfig L1 = smallL1();
  L1.MergesPerMiss = 2;
  MemoryHarness M(chipWithL1(L1));
  M.load(10, A);
  uint32_t Joins = M.load(11, A);
  uint32_t Waits = M.load(12, A);
  M.run(400);
  EXPECT_EQ(M.ready(Joins), 113u);
  EXPECT_EQ(M.ready(Waits), 116u);
  EXPECT_EQ(M.level(Waits), ServedBy::L1);
  EXPECT_EQ(M.statistics().L1->MissRegisterWaitCycles, 113u - 12);
}

// Two ways: C replaces B, because A was used after it.
TEST(L1Test, LeastRecentlyUsedIsReplaced) {
  MemoryHarness M(chipWithL1());
  M.load(0, A);
  M.load(200, B);
  M.load(400, A);
  M.load(600, C);
  uint32_t Kept = M.load(800, A);
  uint32_t Gone = M.load(1000, B);
  M.run(1200);
  EXPECT_EQ(M.ready(Kept), 803u);
  EXPECT_EQ(M.ready(Gone), 1103u);
  EXPECT_EQ(M.statistics().L1->Evictions, 2u);
  EXPECT_EQ(M.statistics().L1->WritebackBytes, 0u);
}

// The store's line is not fetched, and the store is with memory in 13 + 100.
TEST(L1Test, WriteThroughDoesNotAllocate) {
  MemoryHarness M(chipWithL1());
  uint32_t Store = M.store(10, A);
  uint32_t Miss = M.load(200, A);
  uint32_t StoreHit = M.store(400, A);
  uint32_t Hit = M.load(401, A);
  M.run(600);
  EXPECT_EQ(M.ready(Store), 113u);
  EXPECT_EQ(M.ready(Miss), 303u);
  EXPECT_EQ(M.ready(StoreHit), 503u);
  EXPECT_EQ(M.ready(Hit), 404u);
  EXPECT_EQ(M.statistics().L1->Stores, 2u);
  EXPECT_EQ(M.statistics().L1->StoreHits, 1u);
  EXPECT_EQ(M.statistics().L1->BytesWritten, 8u);
  EXPECT_EQ(M.statistics().L1->BytesRead, 32u);
}

// The store fetches its sector; when C evicts the line the sector goes back.
TEST(L1Test, WriteBackAllocates) {
  MemoryHarness M(chipWithL1(writeBack()));
  uint32_t Store = M.store(10, A);
  uint32_t Merged = M.load(12, A);
  uint32_t Hit = M.store(200, A + 4);
  M.load(400, B);
  M.load(600, C);
  uint32_t Gone = M.load(800, A);
  M.run(1000);
  EXPECT_EQ(M.ready(Store), 113u);
  EXPECT_EQ(M.ready(Merged), 113u);
  EXPECT_EQ(M.ready(Hit), 203u);
  EXPECT_EQ(M.ready(Gone), 903u);
  CacheStatistics Counts = *M.statistics().L1;
  EXPECT_EQ(Counts.WritebackBytes, 32u);
  EXPECT_EQ(Counts.BytesWritten, 32u);
  EXPECT_EQ(Counts.BytesRead, 4u * 32);
  EXPECT_EQ(Counts.StoreHits, 1u);
  EXPECT_EQ(Counts.Misses, 3u);
  EXPECT_EQ(Counts.Merged, 1u);
}

// The atomic is done in memory: departure in 203. The copy of its sector is
// gone, that of the line's other sector is not.
TEST(L1Test, AtomicInvalidatesItsSector) {
  MemoryHarness M(chipWithL1());
  M.load(0, A);
  M.load(0, A + 36, 1);
  uint32_t Atomic = M.request(RequestKind::Atomic, 200, A + 8);
  uint32_t OtherSector = M.load(400, A + 32);
  uint32_t Sector = M.load(400, A + 4, 1);
  M.run(600);
  EXPECT_EQ(M.ready(Atomic), 303u);
  EXPECT_EQ(M.ready(OtherSector), 403u);
  EXPECT_EQ(M.ready(Sector), 503u);
  EXPECT_EQ(M.statistics().L1->Atomics, 1u);
}

TEST(L1Test, AtomicWritesDirtySectorBack) {
  MemoryHarness M(chipWithL1(writeBack()));
  M.store(0, A);
  M.request(RequestKind::Atomic, 200, A);
  M.run(400);
  EXPECT_EQ(M.statistics().L1->WritebackBytes, 32u);
}

// A fetch passes the L1 by, in its time, and leaves nothing in it.
TEST(L1Test, FetchPassesBy) {
  MemoryHarness M(chipWithL1());
  uint32_t Fetch = M.request(RequestKind::Fetch, 10, A, 0, 0, 64);
  uint32_t Load = M.load(200, A);
  M.run(400);
  EXPECT_EQ(M.ready(Fetch), 113u);
  EXPECT_EQ(M.ready(Load), 303u);
  EXPECT_EQ(M.statistics().L1->Loads, 1u);
  EXPECT_EQ(M.statistics().L1->Fetches, 0u);
}

// What the engine relies on within a window.
TEST(L1Test, AnswersDuringTheWindow) {
  ChipConfig Chip = chipWithL1();
  Chip.L2 = smallL2();
  Chip.TmsPerL2 = 1;
  std::unique_ptr<MemorySystem> System = makeMemorySystem(Chip);
  TmMemory &Tm = System->tm(0);
  std::vector<MemoryAnswer> Answers;
  Tm.request({5, A + 8, 2, 1, 1, 4, RequestKind::Load});
  Tm.request({5, A, 1, 0, 0, 4, RequestKind::Load});
  Tm.advance(6, Answers);
  ASSERT_EQ(Answers.size(), 1u);
  EXPECT_EQ(Answers[0].Ticket, 1u);
  EXPECT_EQ(Answers[0].ReadyCycle, AnsweredLater);
  EXPECT_EQ(Tm.nextEvent(), 6u);
  Tm.advance(7, Answers);
  ASSERT_EQ(Answers.size(), 2u);
  EXPECT_EQ(Answers[1].Ticket, 2u);
  EXPECT_EQ(Answers[1].ReadyCycle, AnsweredLater);
  EXPECT_EQ(Tm.nextEvent(), ~uint64_t(0));
  EXPECT_FALSE(Tm.hasAnswers());
}

} // namespace
