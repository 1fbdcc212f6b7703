//===- DramRandomTest.cpp - Random requests to a DRAM channel ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/memory/dram/DramChannel.h"
#include "test/unit/memory/DramBench.h"
#include "test/unit/memory/DramTraceChecker.h"
#include "test/unit/memory/MemoryArchive.h"

#include "gtest/gtest.h"

#include <map>
#include <random>

using namespace tp;

namespace {

using Random = std::mt19937;

uint32_t upTo(Random &R, uint32_t Max) { return R() % (Max + 1); }

/// A device with random times that fit together.
DramConfig randomConfig(Random &R) {
  DramConfig Config = smallDram();
  Config.ClockKHz = 300'000 + upTo(R, 2'000'000);
  Config.BankGroups = 1 << upTo(R, 2);
  Config.BanksPerGroup = 1 << upTo(R, 2);
  Config.RcdReadTicks = 1 + upTo(R, 30);
  Config.RcdWriteTicks = 1 + upTo(R, 30);
  Config.RpTicks = 1 + upTo(R, 30);
  Config.ClTicks = 1 + upTo(R, 30);
  Config.CwlTicks = 1 + upTo(R, 10);
  Config.RasTicks = Config.RcdReadTicks + upTo(R, 40);
  Config.RrdShortTicks = 1 + upTo(R, 8);
  Config.RrdLongTicks = Config.RrdShortTicks + upTo(R, 4);
  Config.FawTicks = upTo(R, 60) + 1;
  Config.WrTicks = 1 + upTo(R, 30);
  Config.WtrShortTicks = upTo(R, 10);
  Config.WtrLongTicks = Config.WtrShortTicks + upTo(R, 6);
  Config.RtpTicks = 1 + upTo(R, 8);
  Config.BurstTicks = 1 + upTo(R, 3);
  Config.CcdShortTicks = Config.BurstTicks + upTo(R, 1);
  Config.CcdLongTicks = Config.CcdShortTicks + upTo(R, 3);
  Config.RtwTicks = 1 + upTo(R, 30);
  Config.RfcTicks = 50 + upTo(R, 200);
  Config.RefiTicks = upTo(R, 3) ? 400 + upTo(R, 1000) : 0;
  Config.CommandBuses = 1 + upTo(R, 1);
  Config.ReadQueueEntries = 1 + upTo(R, 20);
  Config.WriteQueueEntries = 1 + upTo(R, 20);
  Config.WriteHighMark = 1 + upTo(R, Config.WriteQueueEntries - 1);
  Config.WriteLowMark = upTo(R, Config.WriteHighMark - 1);
  Config.RowHitLimit = 1 + upTo(R, 4);
  Config.ControllerCycles = upTo(R, 10);
  return Config;
}

/// Bursts of them now and then, with some order in the addresses.
std::vector<DramRequest> randomRequests(Random &R, const DramConfig &Config) {
  std::vector<DramRequest> Requests;
  uint64_t Cycle = 0;
  uint64_t Burst = 0;
  unsigned Writes = upTo(R, 10);
  for (unsigned Tag = 0; Tag < 400; ++Tag) {
    Cycle += upTo(R, 9) ? upTo(R, 4) : upTo(R, 800);
    uint64_t Bursts = dramCapacityBytes(Config) / Config.BurstBytes;
    Burst = (upTo(R, 1) ? Burst + upTo(R, 3) : R()) % Bursts;
    Requests.push_back(
        {Cycle, Burst * Config.BurstBytes, Tag, upTo(R, 9) < Writes});
  }
  return Requests;
}

using Answers = std::map<uint64_t, uint64_t>;

void note(Answers &All, const std::vector<DramAnswer> &New) {
  for (const DramAnswer &Answer : New)
    EXPECT_TRUE(All.emplace(Answer.Tag, Answer.ReadyCycle).second);
}

constexpr uint64_t End = 200'000;

Answers runAtOnce(DramChannel &Channel,
                  const std::vector<DramRequest> &Requests) {
  for (const DramRequest &Request : Requests)
    Channel.enqueue(Request);
  std::vector<DramAnswer> New;
  Channel.advance(End, New);
  Answers All;
  note(All, New);
  return All;
}

/// With the requests of a window known just before it, windows of random
/// length, and a channel restored from a checkpoint now and then; windows in
/// which nothing happens are left out.
Answers runInWindows(Random &R, const DramConfig &Config, uint64_t ChipKHz,
                     const std::vector<DramRequest> &Requests) {
  auto Channel = std::make_unique<DramChannel>(Config, ChipKHz);
  Answers All;
  size_t Next = 0;
  for (uint64_t Horizon = 0; Horizon < End;) {
    uint64_t Begin = Horizon;
    Horizon += 1 + upTo(R, upTo(R, 3) ? 50 : 2000);
    for (; Next < Requests.size() && Requests[Next].Cycle < Horizon; ++Next)
      Channel->enqueue(Requests[Next]);
    if (Channel->nextEvent() >= Horizon)
      continue;
    std::vector<DramAnswer> New;
    Channel->advance(Horizon, New);
    for (const DramAnswer &Answer : New)
      if (!Answer.IsWrite)
        EXPECT_GE(Answer.ReadyCycle,
                  Begin + minimumDramReadCycles(Config, ChipKHz));
    note(All, New);
    if (upTo(R, 20) == 0) {
      auto Restored = std::make_unique<DramChannel>(Config, ChipKHz);
      copyThroughCheckpoint(*Channel, *Restored);
      Channel = std::move(Restored);
    }
  }
  return All;
}

TEST(DramRandom, KeepsAllRulesAndDependsOnNothingElse) {
  for (unsigned Seed = 0; Seed < 60; ++Seed) {
    SCOPED_TRACE("seed " + std::to_string(Seed));
    Random R(Seed);
    DramConfig Config = randomConfig(R);
    uint64_t ChipKHz = 500'000 + upTo(R, 2'000'000);
    std::vector<DramRequest> Requests = randomRequests(R, Config);

    DramChannel Channel(Config, ChipKHz);
    std::vector<DramCommand> Commands;
    Channel.observe([&](const DramCommand &C) { Commands.push_back(C); });
    Answers All = runAtOnce(Channel, Requests);
    EXPECT_EQ(brokenRules(Config, Commands), std::vector<std::string>());
    ASSERT_EQ(All.size(), Requests.size());
    for (const DramRequest &Request : Requests)
      EXPECT_GE(All[Request.Tag],
                Request.Cycle + (Request.IsWrite
                                     ? minimumDramWriteCycles(Config)
                                     : minimumDramReadCycles(Config, ChipKHz)));
    EXPECT_EQ(runInWindows(R, Config, ChipKHz, Requests), All);

    DramChannelStatistics Counts = Channel.statistics(End);
    EXPECT_EQ(Counts.Pending, 0u);
    EXPECT_EQ(Counts.Reads + Counts.Writes + Counts.ForwardedReads +
                  Counts.MergedWrites,
              Requests.size());
    EXPECT_EQ(Counts.RowHits + Counts.RowMisses + Counts.RowConflicts,
              Counts.Reads + Counts.Writes);
    EXPECT_LE(Counts.MaxReadQueue, Config.ReadQueueEntries);
    EXPECT_LE(Counts.MaxWriteQueue, Config.WriteQueueEntries);
  }
}

/// What the checker says of correct commands of which one is moved or dropped.
TEST(DramRandom, CheckerFindsBrokenRules) {
  DramBench Bench(smallDram());
  std::vector<DramCommand> Commands;
  Bench.Channel.observe([&](const DramCommand &C) { Commands.push_back(C); });
  Bench.read(0, 1, 0, 0);
  Bench.read(0, 2, 0, 1);
  Bench.run(200); // ACT, RD, PRE, ACT, RD
  ASSERT_EQ(Commands.size(), 5u);
  EXPECT_TRUE(brokenRules(Bench.Config, Commands).empty());
  for (size_t I = 1; I < 5; ++I) {
    std::vector<DramCommand> Early = Commands;
    --Early[I].Tick;
    EXPECT_FALSE(brokenRules(Bench.Config, Early).empty()) << I;
  }
  for (size_t I = 0; I < 4; ++I) {
    if (Commands[I].Kind == DramCommandKind::Read)
      continue;
    std::vector<DramCommand> Dropped = Commands;
    Dropped.erase(Dropped.begin() + I);
    EXPECT_FALSE(brokenRules(Bench.Config, Dropped).empty()) << I;
  }
}

} // namespace
