//===- MemoryConfig.h - Caches, crossbar and DRAM of a chip -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHIP_MEMORYCONFIG_H
#define TP_SIMULATOR_CHIP_MEMORYCONFIG_H

#include "simulator/chip/TechnologyConfig.h"

#include <cstdint>
#include <optional>
#include <string>

namespace tp {

/// What a cache does with stores.
enum class WritePolicy : uint8_t {
  /// Stores go on to the next level at once; one that misses leaves the cache
  /// as it is.
  Through,
  /// Stores stay in the cache until their line is evicted; one that misses
  /// fetches its line first.
  Back,
};

/// A cache: the L1 of a TM, or the L2 of a group of TMs.
struct CacheConfig {
  uint64_t Bytes = 0;
  /// Bytes that share a tag, and bytes that are fetched at once. Powers of two.
  uint32_t LineBytes = 64;
  uint32_t SectorBytes = 32;
  uint32_t Ways = 1;
  /// Banks, each of which serves one request a cycle. The bank of an address is
  /// (address / BankBytes) mod Banks.
  uint32_t Banks = 1;
  uint32_t BankBytes = 4;
  /// Cycles from the start of a bank's service to the result of a hit, and to
  /// the departure of a miss.
  uint32_t Latency = 1;
  /// Misses on different sectors that can be under way at once, and requests
  /// that can wait for each of them, the first included.
  uint32_t MissRegisters = 1;
  uint32_t MergesPerMiss = 1;
  WritePolicy Writes = WritePolicy::Through;
};

/// The way between the TMs and the next level of memory.
struct CrossbarConfig {
  /// Cycles for one way.
  uint32_t Latency = 1;
  /// Of each TM's port towards memory, and of the one back. A request has
  /// HeaderBytes, with a store or atomic its data, an answer its data.
  uint32_t RequestBytesPerCycle = 8;
  uint32_t AnswerBytesPerCycle = 32;
  uint32_t HeaderBytes = 8;
};

/// Energy of one channel of DRAM with its interface.
struct DramEnergy {
  FigureSource Source;
  /// Of opening and closing a row.
  double ActivateNj = 0;
  /// Of one access of BurstBytes.
  double ReadNj = 0;
  double WriteNj = 0;
  double RefreshNj = 0;
  /// Of all that goes on without accesses, in watts.
  double BackgroundW = 0;
};

/// A DRAM device family and its controller. All times that end in `Ticks` count
/// cycles of the command clock (CK), those in `Cycles` cycles of the chip.
struct DramConfig {
  std::string Name;
  /// Where the numbers come from.
  std::string Source;
  /// Frequency of CK in kHz.
  uint64_t ClockKHz = 0;
  /// Independent channels (of HBM2: pseudo channels).
  uint32_t Channels = 1;
  uint32_t BankGroups = 1;
  uint32_t BanksPerGroup = 4;
  uint32_t RowsPerBank = 1 << 14;
  uint32_t RowBytes = 2048;
  /// Bytes of one access, and ticks for which it holds the data bus.
  uint32_t BurstBytes = 32;
  uint32_t BurstTicks = 2;
  /// Command buses: 1, or 2 if row commands (activate, precharge, refresh) and
  /// column commands (read, write) have one each. Each takes a command a tick.
  uint32_t CommandBuses = 1;
  /// Fields of an address from the highest to the lowest digit above a burst,
  /// of `row`, `bank`, `bankgroup`, `column`, `channel`, separated by colons
  /// (memory/dram/DramAddressMapping.h).
  std::string AddressMapping = "row:bank:column:bankgroup:channel";

  uint32_t RcdReadTicks = 0;
  uint32_t RcdWriteTicks = 0;
  uint32_t RpTicks = 0;
  uint32_t ClTicks = 0;
  uint32_t CwlTicks = 0;
  uint32_t RasTicks = 0;
  uint32_t RrdShortTicks = 0;
  uint32_t RrdLongTicks = 0;
  uint32_t FawTicks = 0;
  uint32_t WrTicks = 0;
  uint32_t WtrShortTicks = 0;
  uint32_t WtrLongTicks = 0;
  uint32_t RtpTicks = 0;
  uint32_t CcdShortTicks = 0;
  uint32_t CcdLongTicks = 0;
  /// From a read command to a write command of any bank.
  uint32_t RtwTicks = 0;
  uint32_t RfcTicks = 0;
  /// Between refreshes; 0: none.
  uint32_t RefiTicks = 0;

  /// Entries per channel. Requests beyond wait in front of the queue.
  uint32_t ReadQueueEntries = 64;
  uint32_t WriteQueueEntries = 64;
  /// Writes are drained from the high mark down to the low one.
  uint32_t WriteHighMark = 48;
  uint32_t WriteLowMark = 16;
  /// Row hits that may pass an older request to another row of their bank.
  uint32_t RowHitLimit = 16;
  /// Cycles of the chip that controller and PHY add to each read.
  uint32_t ControllerCycles = 0;

  /// Nothing if the file does not give it.
  std::optional<DramEnergy> Energy;
};

} // namespace tp

#endif // TP_SIMULATOR_CHIP_MEMORYCONFIG_H
