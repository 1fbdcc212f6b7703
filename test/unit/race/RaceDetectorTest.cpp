//===- RaceDetectorTest.cpp - Accesses that nothing orders ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/check/race/RaceDetector.h"

#include "gtest/gtest.h"

using namespace tp;

static constexpr uint32_t X = 0x10000;
static constexpr uint32_t Flag = 0x10100;

namespace {

class RaceDetection : public testing::Test {
protected:
  void read(uint32_t Thread, uint32_t Address, AccessSite Site,
            unsigned Bytes = 4) {
    Detector.read(Thread, Address, Bytes, [=] { return Site; });
  }
  void write(uint32_t Thread, uint32_t Address, AccessSite Site,
             unsigned Bytes = 4) {
    Detector.write(Thread, Address, Bytes, [=] { return Site; });
  }
  /// A release store and an acquire load, as they are compiled.
  void release(uint32_t Thread, uint32_t Address = Flag) {
    Detector.fence(Thread);
    Detector.atomicStore(Thread, Address, 4, 90);
  }
  void acquire(uint32_t Thread, uint32_t Address = Flag) {
    Detector.atomicLoad(Thread, Address, 4, /*Acquires=*/true, 91);
  }
  /// The sites of the two sides of each race.
  using Sites = std::vector<std::pair<AccessSite, AccessSite>>;
  Sites sites() const {
    Sites Result;
    for (const Race &R : Found)
      Result.push_back({R.Earlier.Site, R.Later.Site});
    return Result;
  }

  std::vector<Race> Found;
  RaceDetector Detector{8, 1 << 20,
                        [this](const Race &R) { Found.push_back(R); }};
};

TEST_F(RaceDetection, WriteAndRead) {
  write(1, X, 10);
  read(2, X, 11);
  ASSERT_EQ(Found.size(), 1u);
  EXPECT_EQ(Found[0].Address, X);
  EXPECT_EQ(Found[0].Earlier.Thread, 1u);
  EXPECT_EQ(Found[0].Earlier.Kind, AccessKind::Write);
  EXPECT_EQ(Found[0].Later.Thread, 2u);
  EXPECT_EQ(Found[0].Later.Kind, AccessKind::Read);
  EXPECT_EQ(sites(), (Sites{{10, 11}}));
}

TEST_F(RaceDetection, ReadAndWriteTwoReadersTwoRaces) {
  read(1, X, 10);
  read(2, X, 11);
  write(3, X, 12);
  EXPECT_EQ(sites(), (Sites{{11, 12}, {10, 12}}));
}

TEST_F(RaceDetection, ReadsDoNotRaceNorDoesAThreadWithItself) {
  read(1, X, 10);
  read(2, X, 11);
  write(3, X + 4, 12);
  read(3, X + 4, 13);
  write(3, X + 4, 14);
  Detector.fence(3);
  write(3, X + 4, 15);
  EXPECT_EQ(sites(), Sites());
}

TEST_F(RaceDetection, BarrierOrders) {
  write(1, X, 10);
  read(1, X + 4, 10);
  Detector.barrier();
  read(2, X, 11);
  write(2, X + 4, 11);
  EXPECT_EQ(sites(), Sites());
  write(3, X, 12);
  EXPECT_EQ(sites(), (Sites{{11, 12}}));
}

TEST_F(RaceDetection, ReleaseAndAcquireOrder) {
  write(1, X, 10);
  release(1);
  write(1, X + 4, 11);
  acquire(2);
  read(2, X, 20);
  EXPECT_EQ(sites(), Sites());
  // What came after the release is not ordered.
  read(2, X + 4, 21);
  EXPECT_EQ(sites(), (Sites{{11, 21}}));
}

TEST_F(RaceDetection, OrderIsTransitive) {
  write(1, X, 10);
  release(1);
  acquire(2);
  release(2, Flag + 4);
  acquire(3, Flag + 4);
  write(3, X, 30);
  EXPECT_EQ(sites(), Sites());
}

TEST_F(RaceDetection, RelaxedOperationsOrderNothing) {
  write(1, X, 10);
  Detector.atomicStore(1, Flag, 4, 90);
  acquire(2);
  read(2, X, 20);
  EXPECT_EQ(sites(), (Sites{{10, 20}}));
  Found.clear();
  write(1, X + 4, 11);
  release(1);
  Detector.atomicLoad(3, Flag, 4, /*Acquires=*/false, 91);
  read(3, X + 4, 30);
  EXPECT_EQ(sites(), (Sites{{11, 30}}));
  // A fence behind the load acquires after all.
  Found.clear();
  Detector.fence(3);
  read(3, X + 4, 31);
  EXPECT_EQ(sites(), Sites());
}

TEST_F(RaceDetection, AtomicChangesKeepWhatWasReleasedBefore) {
  write(1, X, 10);
  release(1);
  Detector.atomicChange(2, Flag, 92);
  acquire(3);
  read(3, X, 30);
  EXPECT_EQ(sites(), Sites());
}

TEST_F(RaceDetection, CounterAndFenceCollectAll) {
  // Each adds to a counter with acquire and release; the last one may touch
  // what all the others wrote.
  for (uint32_t Thread = 0; Thread != 8; ++Thread) {
    write(Thread, X + 4 * Thread, 10 + Thread);
    Detector.fence(Thread);
    Detector.atomicChange(Thread, Flag, 92);
    Detector.fence(Thread);
  }
  for (uint32_t Word = 0; Word != 8; ++Word)
    write(7, X + 4 * Word, 30);
  EXPECT_EQ(sites(), Sites());
  write(6, X, 31);
  EXPECT_EQ(sites(), (Sites{{30, 31}}));
}

TEST_F(RaceDetection, AtomicsRaceOnlyWithOrdinaryAccesses) {
  Detector.atomicChange(1, X, 10);
  Detector.atomicChange(2, X, 11);
  Detector.atomicLoad(3, X, 4, false, 12);
  EXPECT_EQ(sites(), Sites());
  read(4, X, 13);
  EXPECT_EQ(sites(), (Sites{{11, 13}}));
  EXPECT_EQ(Found[0].Earlier.Kind, AccessKind::AtomicWrite);
}

TEST_F(RaceDetection, FirstValueWithoutOrderRacesWithAtomics) {
  // The atomic operation of the writer itself does not hide its first value.
  write(1, X, 10);
  Detector.atomicChange(1, X, 11);
  Detector.atomicChange(2, X, 12);
  EXPECT_EQ(sites(), (Sites{{10, 12}}));
}

TEST_F(RaceDetection, AtomicReadDoesNotHideAnOrdinaryOne) {
  read(1, X, 10);
  Detector.atomicLoad(1, X, 4, false, 11);
  Detector.atomicChange(2, X, 12);
  EXPECT_EQ(sites(), (Sites{{10, 12}}));
}

TEST_F(RaceDetection, StreamsOrder) {
  write(1, X, 10);
  Detector.atomicWrite(1, Flag, 4, 50);
  Detector.streamOperation(1, Flag);
  Detector.atomicRead(2, Flag, 4, 51);
  Detector.streamOperation(2, Flag);
  read(2, X, 20);
  EXPECT_EQ(sites(), Sites());
  // Its words are not for other accesses.
  write(3, Flag, 30);
  EXPECT_EQ(sites(), (Sites{{50, 30}, {51, 30}}));
}

TEST_F(RaceDetection, BytesOfAWordAreApart) {
  write(1, X, 10, 1);
  write(2, X + 1, 20, 1);
  write(3, X + 2, 30, 2);
  read(1, X, 11, 1);
  EXPECT_EQ(sites(), Sites());
  read(4, X, 40);
  ASSERT_EQ(Found.size(), 4u);
  EXPECT_EQ(Found[0].Address, X);
  EXPECT_EQ(Found[1].Address, X + 1);
  EXPECT_EQ(sites(), (Sites{{10, 40}, {20, 40}, {30, 40}, {30, 40}}));
}

TEST_F(RaceDetection, BytesOfOneThreadKeepTheirSites) {
  write(1, X, 10, 1);
  write(1, X + 1, 11, 1);
  read(2, X, 20, 1);
  EXPECT_EQ(sites(), (Sites{{10, 20}}));
  Found.clear();
  read(3, X + 4, 30, 1);
  read(3, X + 5, 31, 1);
  write(4, X + 4, 40, 1);
  EXPECT_EQ(sites(), (Sites{{30, 40}}));
}

TEST_F(RaceDetection, WholeWordsBecomeSimpleAgain) {
  for (int Round = 0; Round != 3; ++Round) {
    write(1, X, 10, 1);
    write(2, X + 1, 20, 1);
    Detector.barrier();
    write(3, X, 30);
    Detector.barrier();
    read(4, X, 40);
    read(5, X + 1, 50, 1);
    EXPECT_EQ(sites(), Sites());
    Detector.barrier();
  }
}

TEST(RaceDetectorLimits, FullClockMemoryHidesButNeverInvents) {
  std::vector<Race> Found;
  RaceDetector Detector(
      64, 1 << 20, [&](const Race &R) { Found.push_back(R); }, 4096);
  for (uint32_t I = 0; I != 2000; ++I) {
    const uint32_t Thread = I * 7 % 64;
    Detector.fence(Thread);
    Detector.atomicChange(Thread, Flag + I % 1000 * 4, 1);
    Detector.fence(Thread);
    Detector.write(Thread, X + 0x8000 + 4 * Thread, 4, [] { return 2; });
  }
  EXPECT_TRUE(Found.empty());
  EXPECT_GT(Detector.interruptions(), 0u);
}

TEST(RaceDetectorLimits, ClocksThatDoNotFitBeginAgain) {
  // A million threads leave 16 bits for the epoch.
  std::vector<Race> Found;
  RaceDetector Detector(1 << 20, 1 << 20,
                        [&](const Race &R) { Found.push_back(R); });
  for (uint32_t I = 0; I != 70000; ++I)
    Detector.fence(5);
  EXPECT_EQ(Detector.interruptions(), 1u);
  Detector.write(5, X, 4, [] { return 1; });
  Detector.read((1 << 20) - 1, X, 4, [] { return 2; });
  ASSERT_EQ(Found.size(), 1u);
  EXPECT_EQ(Found[0].Earlier.Thread, 5u);
  EXPECT_EQ(Found[0].Later.Thread, (1u << 20) - 1);
}

} // namespace
