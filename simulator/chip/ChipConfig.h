//===- ChipConfig.h - A simulated chip, resolved ----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHIP_CHIPCONFIG_H
#define TP_SIMULATOR_CHIP_CHIPCONFIG_H

#include "simulator/chip/MemoryConfig.h"
#include "simulator/chip/TechnologyConfig.h"
#include "simulator/isa/Instructions.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace tp {

/// A functional unit type of a TM.
struct UnitConfig {
  /// Operations that may start in one cycle in each TM; at least 1.
  uint32_t Count = 1;
  /// Initiation interval in cycles; a unit with interval k starts operations
  /// only in cycles divisible by k.
  uint32_t Interval = 1;
};

/// Where the lines come from that the instruction cache misses.
enum class IcacheMisses : uint8_t {
  /// It has the whole program from the start.
  Never,
  /// From a memory of fixed latency of their own.
  Fixed,
  /// From the memory system, past the L1.
  Memory,
};

/// Everything that the engine and the reports need to know of a chip. Built
/// from a chip file by loadChip(), which has checked every value.
struct ChipConfig {
  std::string Name;
  std::string Description;
  double ClockGHz = 1;

  uint32_t TmCount = 1;
  uint32_t TpsPerTm = 1;
  /// Cycles for which the priority among the TPs of a TM is fixed; at most
  /// minimumRoundTrip(). In window w the TP (w mod TpsPerTm) comes first, then
  /// the next higher number, and so on, cyclically.
  uint32_t ArbitrationWindow = 64;

  /// Bytes of each TP's local store; a multiple of 16, at most 1 MiB.
  uint32_t LocalStoreBytes = 0;
  /// Global memory is [64 KiB, MemoryBytes).
  uint64_t MemoryBytes = 0;
  /// Cycles from the issue of a global load or atomic to its result if there
  /// are neither caches nor DRAM; else from the departure out of the last level
  /// in front of memory, if that is not Dram.
  uint32_t MemoryLatency = 100;

  /// The levels between TMs and memory; each may be absent.
  std::optional<CacheConfig> L1;
  std::optional<CrossbarConfig> Crossbar;
  std::optional<CacheConfig> L2;
  /// TMs [k n, k n + n) share the k-th L2.
  uint32_t TmsPerL2 = 1;
  std::optional<DramConfig> Dram;
  /// Stores of a TP that may be on their way at once if there are caches or
  /// DRAM; the next one waits.
  uint32_t StoreBufferEntries = 8;

  /// Whether the time of accesses comes from a MemorySystem.
  bool hasMemorySystem() const { return L1 || Crossbar || L2 || Dram; }

  /// Bank of an instruction is (pc / 4) mod IcacheBanks; IcachePorts fetches
  /// per bank and cycle in each TM.
  uint32_t IcacheBanks = 8;
  uint32_t IcachePorts = 2;
  uint32_t IcacheBytes = 4096;
  /// Lines and sets are looked at only if fetches can miss.
  IcacheMisses IcacheMissKind = IcacheMisses::Never;
  uint32_t IcacheLineBytes = 64;
  uint32_t IcacheWays = 1;
  /// Cycles from a miss to its line, if they are fixed.
  uint32_t IcacheMissLatency = 100;

  /// Subnormal inputs and results of float arithmetic become zero.
  bool FlushToZero = false;

  std::array<UnitConfig, NumUnits> Units{};
  /// Cycles from issue to result by latency class; default from the ISA
  /// definition. The class of global loads and atomics is not used: their
  /// latency is MemoryLatency, or 1 for the local store.
  std::array<uint32_t, NumLatencyClasses> Latency{};

  /// For area and energy; a chip without it has neither.
  std::optional<TechnologyConfig> Technology;

  uint32_t threadCount() const { return TmCount * TpsPerTm; }
};

} // namespace tp

#endif // TP_SIMULATOR_CHIP_CHIPCONFIG_H
