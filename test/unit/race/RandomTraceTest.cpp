//===- RandomTraceTest.cpp - Against all pairs of accesses ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Random traces, of which an oracle keeps every access to every byte and
// compares each with all that were before it.
//
//===----------------------------------------------------------------------===//

#include "simulator/check/race/RaceDetector.h"

#include "gtest/gtest.h"

#include <map>
#include <random>
#include <set>

using namespace tp;

static constexpr uint32_t NumThreads = 6;
static constexpr uint32_t DataBegin = 0x10000;
static constexpr uint32_t FlagBegin = 0x10100;

namespace {

/// Counts the events of each thread.
using FullClock = std::array<uint32_t, NumThreads>;

void joinInto(FullClock &Sum, const FullClock &Other) {
  for (uint32_t I = 0; I != NumThreads; ++I)
    Sum[I] = std::max(Sum[I], Other[I]);
}

/// Knows all pairs of accesses that race.
class Oracle {
public:
  struct Event {
    uint32_t Thread;
    uint32_t Index;
    bool Writes;
    bool Atomic;
    AccessSite Site;
  };

  void access(uint32_t Thread, uint32_t Address, unsigned Bytes, bool Writes,
              bool Atomic, AccessSite Site) {
    const Event Now{Thread, ++Known[Thread][Thread], Writes, Atomic, Site};
    for (uint32_t Byte = Address; Byte != Address + Bytes; ++Byte) {
      for (const Event &Before : History[Byte])
        if (Before.Thread != Thread && (Before.Writes || Writes) &&
            !(Before.Atomic && Atomic) &&
            Before.Index > Known[Thread][Before.Thread]) {
          Races.insert({Before.Site, Site});
          if (FirstRaces.try_emplace(Byte, Site).second)
            Firsts.insert(Site);
        }
      History[Byte].push_back(Now);
    }
  }
  void fence(uint32_t Thread) {
    joinInto(Known[Thread], Found[Thread]);
    Fenced[Thread] = Known[Thread];
  }
  void load(uint32_t Thread, uint32_t Flag, bool Acquires) {
    joinInto(Acquires ? Known[Thread] : Found[Thread], Released[Flag]);
  }
  void store(uint32_t Thread, uint32_t Flag) {
    Released[Flag] = Fenced[Thread];
  }
  void change(uint32_t Thread, uint32_t Flag) {
    load(Thread, Flag, false);
    joinInto(Released[Flag], Fenced[Thread]);
  }
  void barrier() {
    FullClock All{};
    for (const FullClock &Clock : Known)
      joinInto(All, Clock);
    Known.fill(All);
  }

  std::set<std::pair<AccessSite, AccessSite>> Races;
  /// The accesses that are the first of their byte to race.
  std::set<AccessSite> Firsts;

private:
  std::array<FullClock, NumThreads> Known{};
  std::array<FullClock, NumThreads> Found{};
  std::array<FullClock, NumThreads> Fenced{};
  std::map<uint32_t, FullClock> Released;
  std::map<uint32_t, std::vector<Event>> History;
  std::map<uint32_t, AccessSite> FirstRaces;
};

struct TraceShape {
  /// Threads that read data; the others write only.
  uint32_t Readers;
  bool AtomicData;
};

class RandomTrace {
public:
  RandomTrace(unsigned Seed, TraceShape Shape) : Random(Seed), Shape(Shape) {
    for (AccessSite Site = 1; Site != 400; ++Site)
      step(Site);
  }

  Oracle Expected;
  std::set<std::pair<AccessSite, AccessSite>> Found;

private:
  uint32_t below(uint32_t Limit) { return Random() % Limit; }

  void step(AccessSite Site) {
    const uint32_t Thread = below(NumThreads);
    const uint32_t Flag = FlagBegin + 4 * below(3);
    switch (below(10)) {
    case 0:
      Expected.fence(Thread);
      return Detector.fence(Thread);
    case 1: {
      const bool Acquires = below(2);
      Expected.load(Thread, Flag, Acquires);
      return Detector.atomicLoad(Thread, Flag, 4, Acquires, Site);
    }
    case 2:
      Expected.store(Thread, Flag);
      return Detector.atomicStore(Thread, Flag, 4, Site);
    case 3:
      Expected.change(Thread, Flag);
      return Detector.atomicChange(Thread, Flag, Site);
    case 4:
      if (below(10) != 0)
        return;
      Expected.barrier();
      return Detector.barrier();
    default:
      return accessData(Thread, Site);
    }
  }

  void accessData(uint32_t Thread, AccessSite Site) {
    const unsigned Bytes = 1u << below(3);
    const uint32_t Address = DataBegin + below(12 / Bytes) * Bytes;
    const bool Writes = Thread >= Shape.Readers || below(3) == 0;
    const bool Atomic = Shape.AtomicData && below(2);
    Expected.access(Thread, Address, Bytes, Writes, Atomic, Site);
    if (Atomic && Writes)
      return Detector.atomicStore(Thread, Address, Bytes, Site);
    if (Atomic)
      return Detector.atomicLoad(Thread, Address, Bytes, false, Site);
    if (Writes)
      Detector.write(Thread, Address, Bytes, [=] { return Site; });
    else
      Detector.read(Thread, Address, Bytes, [=] { return Site; });
  }

  std::mt19937 Random;
  const TraceShape Shape;
  RaceDetector Detector{NumThreads, 1 << 20, [this](const Race &R) {
                          Found.insert({R.Earlier.Site, R.Later.Site});
                        }};
};

TEST(RandomTrace, FindsTheFirstRaceOfEachByteAndNothingElse) {
  size_t Races = 0;
  for (unsigned Seed = 0; Seed != 2000; ++Seed) {
    RandomTrace Trace(Seed, {/*Readers=*/2, /*AtomicData=*/false});
    std::set<AccessSite> FoundAt;
    for (auto Pair : Trace.Found) {
      ASSERT_TRUE(Trace.Expected.Races.count(Pair))
          << "seed " << Seed << ": " << Pair.first << " and " << Pair.second;
      FoundAt.insert(Pair.second);
    }
    for (AccessSite Site : Trace.Expected.Firsts)
      ASSERT_TRUE(FoundAt.count(Site)) << "seed " << Seed << ": " << Site;
    Races += Trace.Expected.Firsts.size();
  }
  EXPECT_GT(Races, 2000u);
}

TEST(RandomTrace, InventsNothingWithManyReadersAndAtomicData) {
  size_t Races = 0;
  for (unsigned Seed = 0; Seed != 2000; ++Seed) {
    RandomTrace Trace(Seed, {/*Readers=*/NumThreads, /*AtomicData=*/true});
    for (auto Pair : Trace.Found)
      ASSERT_TRUE(Trace.Expected.Races.count(Pair))
          << "seed " << Seed << ": " << Pair.first << " and " << Pair.second;
    Races += Trace.Found.size();
  }
  EXPECT_GT(Races, 2000u);
}

} // namespace
