//===- TechnologyConfig.h - Area and energy of parts ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHIP_TECHNOLOGYCONFIG_H
#define TP_SIMULATOR_CHIP_TECHNOLOGYCONFIG_H

#include "simulator/isa/Instructions.h"

#include <array>
#include <cstdint>
#include <string>

namespace tp {

/// Where a figure comes from.
struct FigureSource {
  std::string Text;
  /// Nobody published it for this part: it is our assumption.
  bool IsAssumption = false;
};

/// What a part of a given size costs.
struct PartCost {
  double AreaMm2 = 0;
  /// Of one operation or access.
  double EnergyNj = 0;
  FigureSource Source;
};

/// What a memory of a given size costs. One of another size costs this times
/// the ratio of the two sizes' costs by the law of caches with one bank.
struct MemoryCost {
  uint64_t Bytes = 0;
  PartCost Cost;
};

/// A cache of n KiB has AreaMm2 + n x AreaMm2PerKiB mm2, and an access takes
/// EnergyNj + sqrt(n) x EnergyNjPerSqrtKiB nJ: bit lines and word lines both
/// grow with the side of the array.
struct CacheLaw {
  double AreaMm2 = 0;
  double AreaMm2PerKiB = 0;
  double EnergyNj = 0;
  double EnergyNjPerSqrtKiB = 0;
  FigureSource Source;
};

/// Numbers of banks with figures of their own: 1, 2, 4, ... 64.
inline constexpr unsigned NumBankCounts = 7;

/// Area and energy of a chip's parts in one process. Energies are dynamic; no
/// part leaks.
struct TechnologyConfig {
  std::string Name;
  std::string Description;
  std::array<PartCost, NumUnits> Units;
  /// Of the registers of one thread; the energy is that of one access.
  PartCost RegisterFile;
  /// Of one TP.
  MemoryCost LocalStore;
  /// By the logarithm of the banks; of a cache whose banks have IcachePorts
  /// ports. More ports than that need copies of the cache. The energy is that
  /// of one fetch.
  uint64_t IcacheBytes = 0;
  uint32_t IcachePorts = 1;
  std::array<PartCost, NumBankCounts> Icache;
  /// By the logarithm of the banks.
  std::array<CacheLaw, NumBankCounts> Cache;
  /// Of a TM's port; the energy is that of one byte.
  PartCost Crossbar;
};

} // namespace tp

#endif // TP_SIMULATOR_CHIP_TECHNOLOGYCONFIG_H
