//===- DramAddressMapping.h - Where a byte lies in DRAM ---------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_MEMORY_DRAM_DRAMADDRESSMAPPING_H
#define TP_SIMULATOR_MEMORY_DRAM_DRAMADDRESSMAPPING_H

#include "simulator/chip/MemoryConfig.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace tp {

/// A burst's place. Banks are counted through the groups: Bank /
/// DramConfig::BanksPerGroup is the group.
struct DramLocation {
  uint32_t Channel;
  uint32_t Bank;
  uint32_t Row;
  /// In bursts from the row's start.
  uint32_t Column;

  bool operator==(const DramLocation &) const = default;
};

/// Bytes of all channels together.
uint64_t dramCapacityBytes(const DramConfig &Config);

/// What is wrong with the address mapping of \p Config; empty if it is good.
std::string checkAddressMapping(const DramConfig &Config);

/// Takes an address apart by DramConfig::AddressMapping. The number of the
/// burst is written in digits, one per field, the last field the lowest digit;
/// a field's base is its size, which need not be a power of two. A field may be
/// split: `column/8` is a digit of base 8, the lower one of the columns if
/// another `column` stands before it, which then has the rest. For example
/// `row:bank:column:bankgroup:channel:column/8` puts eight bursts in a row into
/// the same channel, bank and row before the next channel's turn.
class DramAddressMapping {
public:
  /// checkAddressMapping() must have found nothing.
  explicit DramAddressMapping(const DramConfig &Config);

  DramLocation locate(uint64_t Address) const;
  uint32_t channelOf(uint64_t Address) const;

private:
  friend std::string checkAddressMapping(const DramConfig &Config);

  enum class Field : uint8_t { Row, Bank, BankGroup, Column, Channel };
  static constexpr unsigned NumFields = 5;

  /// A digit of an address.
  struct Digit {
    Field Of;
    uint32_t Base;
    /// What one counts in its field.
    uint32_t Weight;
  };

  /// Sets Digits; returns what is wrong, or nothing.
  std::string parse(const DramConfig &Config);
  DramAddressMapping() = default;

  uint32_t BurstBytes = 0;
  uint32_t BanksPerGroup = 0;
  /// From the lowest.
  std::vector<Digit> Digits;
};

} // namespace tp

#endif // TP_SIMULATOR_MEMORY_DRAM_DRAMADDRESSMAPPING_H
