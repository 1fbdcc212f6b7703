//===- DramBench.h - A DRAM channel under test ------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_TEST_UNIT_MEMORY_DRAMBENCH_H
#define TP_TEST_UNIT_MEMORY_DRAMBENCH_H

#include "simulator/memory/dram/DramChannel.h"

#include <map>
#include <string>
#include <vector>

namespace tp {

/// A channel of two bank groups of two banks of 16 rows of eight bursts. Its
/// times are all different and its clock is the chip's, so that ticks are
/// cycles. No refresh.
inline DramConfig smallDram() {
  DramConfig Config;
  Config.ClockKHz = 1'000'000;
  Config.Channels = 1;
  Config.BankGroups = 2;
  Config.BanksPerGroup = 2;
  Config.RowsPerBank = 16;
  Config.RowBytes = 256;
  Config.BurstBytes = 32;
  Config.BurstTicks = 2;
  Config.AddressMapping = "row:bank:bankgroup:column:channel";
  Config.RcdReadTicks = 10;
  Config.RcdWriteTicks = 8;
  Config.RpTicks = 7;
  Config.ClTicks = 9;
  Config.CwlTicks = 4;
  Config.RasTicks = 25;
  Config.RrdShortTicks = 3;
  Config.RrdLongTicks = 5;
  Config.FawTicks = 12;
  Config.WrTicks = 11;
  Config.WtrShortTicks = 6;
  Config.WtrLongTicks = 8;
  Config.RtpTicks = 6;
  Config.CcdShortTicks = 2;
  Config.CcdLongTicks = 4;
  Config.RtwTicks = 12;
  Config.RfcTicks = 50;
  Config.RefiTicks = 0;
  return Config;
}

/// A channel with what it has said and done.
class DramBench {
public:
  explicit DramBench(const DramConfig &Config, uint64_t ChipKHz = 1'000'000)
      : Config(Config), Channel(Config, ChipKHz) {
    Channel.observe([this](const DramCommand &Command) {
      Trace +=
          (Trace.empty() ? "" : " ") + name(Command.Kind) +
          (isOfAllBanks(Command.Kind) ? "" : std::to_string(Command.Bank)) +
          "@" + std::to_string(Command.Tick);
    });
  }

  /// The address of a burst under smallDram()'s mapping. Banks are counted
  /// through the groups: 0 and 1 are in group 0.
  uint64_t address(uint32_t Bank, uint32_t Row, uint32_t Column = 0) const {
    uint32_t InGroup = Bank % Config.BanksPerGroup;
    uint32_t Group = Bank / Config.BanksPerGroup;
    uint32_t Columns = Config.RowBytes / Config.BurstBytes;
    return (((uint64_t(Row) * Config.BanksPerGroup + InGroup) *
                 Config.BankGroups +
             Group) *
                Columns +
            Column) *
           Config.BurstBytes;
  }

  void read(uint64_t Cycle, uint64_t Tag, uint32_t Bank, uint32_t Row,
            uint32_t Column = 0) {
    Channel.enqueue({Cycle, address(Bank, Row, Column), Tag, false});
  }
  void write(uint64_t Cycle, uint64_t Tag, uint32_t Bank, uint32_t Row,
             uint32_t Column = 0) {
    Channel.enqueue({Cycle, address(Bank, Row, Column), Tag, true});
  }

  /// Runs on to \p Horizon and forgets the commands before.
  void run(uint64_t Horizon) {
    Trace.clear();
    std::vector<DramAnswer> New;
    Channel.advance(Horizon, New);
    for (const DramAnswer &Answer : New)
      Ready[Answer.Tag] = Answer.ReadyCycle;
  }

  DramConfig Config;
  DramChannel Channel;
  /// The commands of the last run(): ACT, PRE, RD, WR with bank and tick; PREA
  /// and REF with the tick.
  std::string Trace;
  /// By tag.
  std::map<uint64_t, uint64_t> Ready;

private:
  static bool isOfAllBanks(DramCommandKind Kind) {
    return Kind == DramCommandKind::PrechargeAll ||
           Kind == DramCommandKind::Refresh;
  }
  static std::string name(DramCommandKind Kind) {
    constexpr const char *Names[] = {"ACT", "PRE", "RD", "WR", "PREA", "REF"};
    return Names[unsigned(Kind)];
  }
};

} // namespace tp

#endif // TP_TEST_UNIT_MEMORY_DRAMBENCH_H
