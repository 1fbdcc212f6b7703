//===- DramStreamingTest.cpp - Bandwidth of the DRAM parameter files -----===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/chip/ChipFile.h"
#include "simulator/chip/ChipSettings.h"
#include "simulator/memory/dram/DramChannel.h"
#include "test/unit/memory/DramTraceChecker.h"

#include "gtest/gtest.h"

using namespace tp;

namespace {

constexpr uint64_t ChipKHz = 1'000'000;

/// The file of that name in chips/dram.
DramConfig dramFile(const std::string &Name) {
  llvm::Expected<ChipConfig> Chip = loadChip("1x1", TP_CHIP_FOLDER);
  if (Chip)
    Chip = withSettings(*Chip,
                        {"arbitration_window_cycles=16", "memory.bytes=1 GiB",
                         "memory.dram=" + Name},
                        {TP_CHIP_FOLDER});
  if (Chip && Chip->Dram)
    return *Chip->Dram;
  ADD_FAILURE() << (Chip ? "no DRAM" : llvm::toString(Chip.takeError()));
  return {};
}

class DramStreaming : public testing::TestWithParam<const char *> {
protected:
  /// Bursts of a channel in \p Time ticks without anything but refreshes.
  double peakBursts(double Ticks) const {
    return Ticks / Config.BurstTicks *
           (1 - double(Config.RfcTicks) / Config.RefiTicks);
  }

  /// Sends all bursts of the first channel in the order of addresses, as fast
  /// as it takes them, and returns the tick behind the last.
  uint64_t stream(unsigned Bursts, bool IsWrite) {
    DramChannel Channel(Config, ChipKHz);
    std::vector<DramCommand> Commands;
    Channel.observe(
        [&](const DramCommand &Command) { Commands.push_back(Command); });
    DramAddressMapping Mapping(Config);
    uint64_t Address = 0;
    for (unsigned I = 0; I < Bursts; Address += Config.BurstBytes)
      if (Mapping.channelOf(Address) == 0)
        Channel.enqueue({0, Address, I++, IsWrite});
    std::vector<DramAnswer> Answers;
    Channel.advance(uint64_t(Bursts) * 10, Answers);
    EXPECT_EQ(Answers.size(), Bursts);
    EXPECT_EQ(brokenRules(Config, Commands), std::vector<std::string>());

    DramCommandKind Kind =
        IsWrite ? DramCommandKind::Write : DramCommandKind::Read;
    uint64_t Last = 0;
    for (const DramCommand &Command : Commands)
      if (Command.Kind == Kind)
        Last = Command.Tick;
    return Last + Config.BurstTicks;
  }

  DramConfig Config = dramFile(GetParam());
};

// 20,000 bursts are some 40,000 ticks and ten refreshes or more.
constexpr unsigned Bursts = 20'000;

TEST_P(DramStreaming, ReadsAtThePeakLessRefresh) {
  double Share = Bursts / peakBursts(stream(Bursts, false));
  EXPECT_GT(Share, 0.97);
  EXPECT_LT(Share, 1.005); // the last interval may be without its refresh
  RecordProperty("share", std::to_string(Share));
}

TEST_P(DramStreaming, WritesAtThePeakLessRefresh) {
  double Share = Bursts / peakBursts(stream(Bursts, true));
  EXPECT_GT(Share, 0.97);
  EXPECT_LT(Share, 1.005);
}

INSTANTIATE_TEST_SUITE_P(Files, DramStreaming,
                         testing::Values("gddr5", "gddr6", "hbm2"),
                         [](const auto &Info) { return Info.param; });

} // namespace
