//===- RayProfilerTest.cpp - Counts of the ray events ---------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/profile/RayProfiler.h"
#include "kernels/profile/RayProfileText.h"

#include "gtest/gtest.h"

using namespace tp;

namespace {

constexpr uint32_t SlotBytes = 120;

constexpr uint32_t childWord(uint32_t Slot, uint32_t Child) {
  return Slot * SlotBytes + 96 + 4 * Child;
}

class RayProfilerTest : public testing::Test {
protected:
  void report(RayEvent Event, uint32_t Value, uint32_t Thread = 0) {
    Profiler.profileValue(Thread, static_cast<uint32_t>(Event), Value);
  }
  void describeCache(uint32_t Slots, uint32_t Thread = 0) {
    report(RayEvent::CacheSlots, Slots, Thread);
    report(RayEvent::CacheSlotBytes, SlotBytes, Thread);
    report(RayEvent::CacheSlotTriangles, 2, Thread);
    report(RayEvent::CacheChildOffset, 96, Thread);
  }
  void load(BvhReference From, uint32_t Word, CacheLink Into) {
    report(RayEvent::SlotLoadFrom, From);
    report(RayEvent::SlotLoadParent, Word);
    report(RayEvent::SlotLoadInto, Into);
    report(RayEvent::SlotVisit, Into);
  }
  RayProfile sum() { return *sumOf(Profiler.threads()); }
  std::string error() {
    const Status Checked = Profiler.check();
    return Checked ? "" : Checked.message();
  }

  RayProfiler Profiler{2};
};

} // namespace

TEST_F(RayProfilerTest, CountsRaysFromMemory) {
  report(RayEvent::RayBegin, 0);
  report(RayEvent::NodeFromMemory, 0);
  report(RayEvent::NodeFromMemory, 0x80);
  report(RayEvent::TrianglesFromMemory, leafReference(7, 3));
  report(RayEvent::RayBegin, 1);
  report(RayEvent::NodeFromMemory, 0);
  report(RayEvent::RayBegin, 1, 1);
  Profiler.profileValue(0, 5, 99);
  EXPECT_EQ(error(), "");
  const RayProfile Sum = sum();
  EXPECT_EQ(Sum.ClosestHitRays, 1u);
  EXPECT_EQ(Sum.AnyHitRays, 2u);
  EXPECT_EQ(Sum.NodesVisited.Total, 3u);
  EXPECT_EQ(Sum.NodesVisited.Maximum, 2u);
  EXPECT_EQ(Sum.NodesFromMemory.Total, 3u);
  EXPECT_EQ(Sum.TrianglesVisited.Total, 3u);
  EXPECT_EQ(Sum.TrianglesFromMemory.Maximum, 3u);
  EXPECT_FALSE(Sum.Cache);
  EXPECT_EQ(Profiler.threads()[1].NodesVisited.Total, 0u);
}

TEST_F(RayProfilerTest, CountsTheCache) {
  describeCache(3);
  report(RayEvent::RayBegin, 0);
  load(0, kRootWord, innerLink(0));
  load(0x80, childWord(0, 0), innerLink(SlotBytes));
  load(leafReference(4, 3), childWord(1, 1), leafLink(2 * SlotBytes));
  report(RayEvent::RayBegin, 1);
  report(RayEvent::SlotVisit, innerLink(0));
  report(RayEvent::SlotVisit, innerLink(SlotBytes));
  report(RayEvent::DeletionBegin, childWord(1, 1));
  report(RayEvent::SlotFreed, 2 * SlotBytes);
  report(RayEvent::DeletionEnd, 1);
  load(leafReference(9, 1), childWord(1, 2), leafLink(2 * SlotBytes));
  report(RayEvent::Bypass, 0x100);
  report(RayEvent::NodeFromMemory, 0x100);
  EXPECT_EQ(error(), "");

  const RayProfile Sum = sum();
  EXPECT_EQ(Sum.NodesVisited.Total, 5u);
  EXPECT_EQ(Sum.NodesFromMemory.Total, 3u);
  EXPECT_EQ(Sum.NodesFromMemory.Maximum, 2u);
  EXPECT_EQ(Sum.TrianglesVisited.Total, 3u);
  EXPECT_EQ(Sum.TrianglesFromMemory.Total, 3u);
  const CacheProfile &Cache = *Sum.Cache;
  EXPECT_EQ(Cache.Visits, 6u);
  EXPECT_EQ(Cache.Hits, 2u);
  EXPECT_EQ(Cache.Loads, 4u);
  EXPECT_EQ(Cache.HitsByDepth, (std::vector<uint64_t>{1, 1}));
  EXPECT_EQ(Cache.LoadsByDepth, (std::vector<uint64_t>{1, 1, 2}));
  EXPECT_EQ(Cache.Deletions, 1u);
  EXPECT_EQ(Cache.SlotsFreed, 1u);
  EXPECT_EQ(Cache.DeletionsBySlotsFreed[0], 1u);
  EXPECT_EQ(Cache.Bypasses, 1u);
  EXPECT_EQ(Cache.PeakSlotsUsed, 3u);
  EXPECT_NE(describe(Sum).find("3 slots of 120 bytes, at most 3 in use"),
            std::string::npos);
}

TEST_F(RayProfilerTest, VisitOfAnEarlierRaysLoadIsAHit) {
  describeCache(3);
  report(RayEvent::RayBegin, 0);
  load(0, kRootWord, innerLink(0));
  report(RayEvent::SlotLoadFrom, 0x80);
  report(RayEvent::SlotLoadParent, childWord(0, 0));
  report(RayEvent::SlotLoadInto, innerLink(SlotBytes));
  report(RayEvent::SlotVisit, innerLink(0));
  EXPECT_EQ(sum().Cache->Hits, 1u);
  report(RayEvent::RayBegin, 0);
  report(RayEvent::SlotVisit, innerLink(SlotBytes));
  EXPECT_EQ(sum().Cache->Hits, 2u);
  EXPECT_EQ(sum().Cache->Visits, 3u);
}

TEST_F(RayProfilerTest, RecordsADeletion) {
  Profiler.recordDeletion({0, 2});
  EXPECT_EQ(Profiler.recordedDeletion().message(),
            "thread 0 has no cache of the BVH");
  describeCache(4);
  report(RayEvent::RayBegin, 0);
  load(0, kRootWord, innerLink(0));
  for (uint32_t Child : {0, 1, 2}) {
    load(0x80, childWord(0, Child), innerLink(SlotBytes));
    load(0x100, childWord(1, 0), innerLink(2 * SlotBytes));
    report(RayEvent::DeletionBegin, childWord(0, Child));
    report(RayEvent::SlotFreed, SlotBytes);
    report(RayEvent::SlotFreed, 2 * SlotBytes);
    if (Child == 0)
      EXPECT_EQ(Profiler.recordedDeletion().message(),
                "thread 0 has no deletion 2: it made 0");
    report(RayEvent::DeletionEnd, 2);
    load(0x180, childWord(0, 3), innerLink(3 * SlotBytes));
    report(RayEvent::DeletionBegin, childWord(0, 3));
    report(RayEvent::SlotFreed, 3 * SlotBytes);
    report(RayEvent::DeletionEnd, 1);
  }
  EXPECT_EQ(error(), "");
  const DeletionRecord &Record = **Profiler.recordedDeletion();
  EXPECT_EQ(Record.Ray, 1u);
  EXPECT_EQ(Record.Freed, std::vector<uint16_t>{3});
  EXPECT_EQ(Record.Before.usedSlots(), 2u);
  EXPECT_EQ(Record.After.usedSlots(), 1u);
  EXPECT_EQ(Record.Path, std::vector<uint16_t>{0});
}

TEST_F(RayProfilerTest, ReportsTheFirstContradiction) {
  describeCache(3);
  report(RayEvent::RayBegin, 0);
  report(RayEvent::SlotVisit, innerLink(SlotBytes));
  report(RayEvent::SlotVisit, innerLink(1));
  EXPECT_EQ(error(),
            "ray events of thread 0 contradict each other: event 6, "
            "SlotVisit(0x00000079) in ray 1: a visit is to a slot that is not "
            "loaded");
}

TEST_F(RayProfilerTest, ChecksTheOrderOfEvents) {
  const auto Accepts = [](std::initializer_list<RayEvent> Events) {
    ThreadRayProfiler Thread;
    for (const RayEvent Event : Events)
      Thread.report(Event, 0);
    return Thread.contradiction().empty();
  };
  EXPECT_FALSE(Accepts({RayEvent::NodeFromMemory}));
  EXPECT_TRUE(Accepts({RayEvent::RayBegin, RayEvent::NodeFromMemory}));
  EXPECT_FALSE(Accepts({RayEvent::RayBegin, RayEvent::TrianglesFromMemory}));
  EXPECT_FALSE(Accepts({RayEvent::RayBegin, RayEvent::CacheSlots}));
  EXPECT_FALSE(Accepts({RayEvent::CacheSlotBytes}));
  EXPECT_FALSE(Accepts({RayEvent::RayBegin, RayEvent::SlotVisit}));

  describeCache(3);
  report(RayEvent::RayBegin, 0);
  report(RayEvent::SlotLoadFrom, 0);
  report(RayEvent::SlotLoadInto, innerLink(0));
  EXPECT_NE(error().find("it cannot follow the event before it"),
            std::string::npos);
}

TEST_F(RayProfilerTest, RefusesDifferentCaches) {
  describeCache(3, 0);
  describeCache(4, 1);
  EXPECT_EQ(error(),
            "ray events of thread 1: its cache is not like those of others");
}
