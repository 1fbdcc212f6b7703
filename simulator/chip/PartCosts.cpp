//===- PartCosts.cpp - What the parts of a chip cost ----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/chip/PartCosts.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace tp {

static unsigned bankIndex(uint32_t Banks) {
  return std::min(unsigned(std::bit_width(Banks)) - 1, NumBankCounts - 1);
}

static PartCost costByLaw(const CacheLaw &Law, uint64_t Bytes) {
  double KiB = double(Bytes) / 1024;
  return {Law.AreaMm2 + KiB * Law.AreaMm2PerKiB,
          Law.EnergyNj + std::sqrt(KiB) * Law.EnergyNjPerSqrtKiB, Law.Source};
}

/// \p Known, which holds for \p KnownBytes, for \p Bytes: by the ratio of
/// caches of the two sizes.
static PartCost scaled(PartCost Known, uint64_t KnownBytes, uint64_t Bytes,
                       const CacheLaw &Law) {
  if (Bytes == KnownBytes)
    return Known;
  PartCost From = costByLaw(Law, KnownBytes), To = costByLaw(Law, Bytes);
  if (From.AreaMm2 > 0)
    Known.AreaMm2 *= To.AreaMm2 / From.AreaMm2;
  if (From.EnergyNj > 0)
    Known.EnergyNj *= To.EnergyNj / From.EnergyNj;
  Known.Source.IsAssumption = true;
  Known.Source.Text += "; scaled by size like a cache of one bank";
  return Known;
}

PartCost unitCost(const ChipConfig &Chip, Unit Type) {
  return Chip.Technology ? Chip.Technology->Units[unsigned(Type)] : PartCost();
}

PartCost registerFileCost(const ChipConfig &Chip) {
  return Chip.Technology ? Chip.Technology->RegisterFile : PartCost();
}

PartCost localStoreCost(const ChipConfig &Chip) {
  if (!Chip.Technology)
    return {};
  const MemoryCost &Known = Chip.Technology->LocalStore;
  return scaled(Known.Cost, Known.Bytes, Chip.LocalStoreBytes,
                Chip.Technology->Cache[0]);
}

PartCost icacheCost(const ChipConfig &Chip) {
  if (!Chip.Technology)
    return {};
  const TechnologyConfig &T = *Chip.Technology;
  PartCost Cost = scaled(T.Icache[bankIndex(Chip.IcacheBanks)], T.IcacheBytes,
                         Chip.IcacheBytes, T.Cache[0]);
  uint32_t Copies = (Chip.IcachePorts + T.IcachePorts - 1) / T.IcachePorts;
  Cost.AreaMm2 *= Copies;
  return Cost;
}

PartCost cacheCost(const ChipConfig &Chip, const CacheConfig &Cache) {
  if (!Chip.Technology)
    return {};
  return costByLaw(Chip.Technology->Cache[bankIndex(Cache.Banks)], Cache.Bytes);
}

PartCost crossbarCost(const ChipConfig &Chip) {
  return Chip.Technology ? Chip.Technology->Crossbar : PartCost();
}

} // namespace tp
