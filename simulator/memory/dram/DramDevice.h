//===- DramDevice.h - Banks of a channel and their timing -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_MEMORY_DRAM_DRAMDEVICE_H
#define TP_SIMULATOR_MEMORY_DRAM_DRAMDEVICE_H

#include "simulator/chip/MemoryConfig.h"
#include "simulator/core/Archive.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace tp {

enum class DramCommandKind : uint8_t {
  Activate,
  Precharge,
  /// Closes all open rows.
  PrechargeAll,
  Read,
  Write,
  /// Of all banks.
  Refresh,
};

/// A command as a channel issues it.
struct DramCommand {
  uint64_t Tick;
  DramCommandKind Kind;
  /// Counted through the bank groups; 0 for commands to all banks.
  uint32_t Bank;
  /// Of Activate.
  uint32_t Row;
};

/// What the commands of a channel so far leave open: rows, and from which tick
/// on each command may come next.
class DramDevice {
public:
  static constexpr uint32_t NoRow = ~uint32_t(0);

  explicit DramDevice(const DramConfig &Config);

  uint32_t banks() const { return uint32_t(Banks.size()); }
  /// NoRow if the bank is precharged.
  uint32_t openRow(uint32_t Bank) const { return Banks[Bank].OpenRow; }

  /// The first tick at which the command keeps all rules, if none is issued
  /// before.
  uint64_t earliestActivate(uint32_t Bank) const {
    return std::max({Banks[Bank].Activate, groupOf(Bank).Activate,
                     Channel.Activate, FourActivates[NextActivate]});
  }
  uint64_t earliestPrecharge(uint32_t Bank) const {
    return Banks[Bank].Precharge;
  }
  uint64_t earliestRead(uint32_t Bank) const {
    return std::max({Banks[Bank].Read, groupOf(Bank).Read, Channel.Read});
  }
  uint64_t earliestWrite(uint32_t Bank) const {
    return std::max({Banks[Bank].Write, groupOf(Bank).Write, Channel.Write});
  }
  uint64_t earliestPrechargeAll() const;
  /// For a device without open rows.
  uint64_t earliestRefresh() const;
  bool hasOpenRow() const;

  void activate(uint64_t Tick, uint32_t Bank, uint32_t Row);
  void precharge(uint64_t Tick, uint32_t Bank);
  void prechargeAll(uint64_t Tick);
  void read(uint64_t Tick, uint32_t Bank);
  void write(uint64_t Tick, uint32_t Bank);
  void refresh(uint64_t Tick);

  void serialize(Archive &A);

private:
  /// First ticks that the commands to a bank, a group or the channel so far
  /// leave to the next one of each kind.
  struct Earliest {
    uint64_t Activate = 0;
    uint64_t Read = 0;
    uint64_t Write = 0;
  };
  struct BankState : Earliest {
    uint64_t Precharge = 0;
    uint64_t OpenRow = NoRow;
  };

  const Earliest &groupOf(uint32_t Bank) const {
    return Groups[Bank / Config.BanksPerGroup];
  }
  Earliest &groupOf(uint32_t Bank) {
    return Groups[Bank / Config.BanksPerGroup];
  }

  DramConfig Config;
  std::vector<BankState> Banks;
  std::vector<Earliest> Groups;
  Earliest Channel;
  /// Of each of the last four activates: the first tick of the fourth after it.
  std::array<uint64_t, 4> FourActivates{};
  uint32_t NextActivate = 0;
};

} // namespace tp

#endif // TP_SIMULATOR_MEMORY_DRAM_DRAMDEVICE_H
