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

enum class DramCommandKind : uint32_t {
  Activate,
  Precharge,
  Read,
  Write,
  /// Closes all open rows.
  PrechargeAll,
  /// Of all banks.
  Refresh,
};
inline constexpr unsigned NumBankCommands =
    unsigned(DramCommandKind::Write) + 1;

/// Reads and writes are column commands, the others row commands.
constexpr bool isColumnCommand(DramCommandKind Kind) {
  return Kind == DramCommandKind::Read || Kind == DramCommandKind::Write;
}

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

  /// The first tick at which a command to \p Bank keeps all rules, if none is
  /// issued before.
  uint64_t earliest(DramCommandKind Kind, uint32_t Bank) const {
    const BankState &State = Banks[Bank];
    return std::max({State[Kind], Groups[State.Group][Kind], Channel[Kind]});
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
    std::array<uint64_t, NumBankCommands> Ticks{};

    uint64_t operator[](DramCommandKind Kind) const {
      return Ticks[unsigned(Kind)];
    }
    void delay(DramCommandKind Kind, uint64_t Tick) {
      Ticks[unsigned(Kind)] = std::max(Ticks[unsigned(Kind)], Tick);
    }
  };
  struct BankState : Earliest {
    uint32_t OpenRow = NoRow;
    uint32_t Group = 0;
  };

  Earliest &groupOf(uint32_t Bank) { return Groups[Banks[Bank].Group]; }

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
