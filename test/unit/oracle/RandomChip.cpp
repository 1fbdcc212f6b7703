//===- RandomChip.cpp - Random chips --------------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/chip/MinimumRoundTrip.h"
#include "test/unit/oracle/RandomProgram.h"

#include <algorithm>

namespace tp::test {

ChipConfig randomChip(RandomSource &Random) {
  ChipConfig Chip;
  Chip.TmCount = Random.oneIn(2) ? 1 : Random.between(2, 4);
  Chip.TpsPerTm = Random.oneIn(3) ? 1 : Random.between(2, 8);
  Chip.MemoryLatency =
      Random.oneIn(4) ? Random.between(1, 8) : Random.between(9, 150);
  Chip.ArbitrationWindow = Random.oneIn(3)
                               ? Chip.MemoryLatency
                               : Random.between(1, Chip.MemoryLatency);
  Chip.LocalStoreBytes = Random.oneIn(8) ? 256 : 1024;
  Chip.MemoryBytes = 0x20000;
  Chip.IcacheBanks = Random.between(1, Random.oneIn(4) ? 40 : 8);
  Chip.IcachePorts = Random.between(1, Chip.TpsPerTm);
  Chip.FlushToZero = Random.oneIn(3);
  for (UnitConfig &Type : Chip.Units) {
    Type.Count = Random.between(1, Chip.TpsPerTm + 1);
    Type.Interval = Random.oneIn(4) ? Random.between(2, 17) : 1;
  }
  for (unsigned I = 0; I != NumLatencyClasses; ++I)
    Chip.Latency[I] = Random.oneIn(3) ? Random.between(1, 30)
                                      : defaultLatency(LatencyClass(I));
  return Chip;
}

static uint32_t powerOfTwo(RandomSource &Random, uint32_t LeastLog,
                           uint32_t MostLog) {
  return 1u << Random.between(LeastLog, MostLog);
}

static CacheConfig randomCache(RandomSource &Random, uint32_t MostLatency) {
  CacheConfig Cache;
  Cache.LineBytes = powerOfTwo(Random, 4, 6);
  Cache.SectorBytes = std::min(Cache.LineBytes, powerOfTwo(Random, 4, 6));
  Cache.Ways = Random.between(1, 4);
  Cache.Bytes =
      uint64_t(Cache.LineBytes) * Cache.Ways * powerOfTwo(Random, 0, 2);
  Cache.Banks = powerOfTwo(Random, 0, 3);
  Cache.BankBytes = powerOfTwo(Random, 2, 5);
  Cache.Latency = Random.between(1, MostLatency);
  Cache.MissRegisters = Random.between(1, 6);
  Cache.MergesPerMiss = Random.between(1, 4);
  Cache.Writes = Random.oneIn(2) ? WritePolicy::Through : WritePolicy::Back;
  return Cache;
}

static CrossbarConfig randomCrossbar(RandomSource &Random) {
  CrossbarConfig Crossbar;
  Crossbar.Latency = Random.between(1, 10);
  Crossbar.RequestBytesPerCycle = powerOfTwo(Random, 1, 4);
  Crossbar.AnswerBytesPerCycle = powerOfTwo(Random, 1, 6);
  Crossbar.HeaderBytes = Random.between(1, 9);
  return Crossbar;
}

static DramConfig randomDram(RandomSource &Random) {
  DramConfig Dram;
  Dram.ClockKHz = Random.between(500000, 2000000);
  Dram.Channels = Random.between(1, 3);
  Dram.BankGroups = 2;
  Dram.BanksPerGroup = 2;
  Dram.RowBytes = 256;
  Dram.BurstBytes = powerOfTwo(Random, 4, 6);
  Dram.BurstTicks = Random.between(1, 4);
  Dram.ClTicks = Random.between(4, 12);
  Dram.CwlTicks = Random.between(1, 4);
  Dram.RcdReadTicks = Dram.RcdWriteTicks = Random.between(3, 12);
  Dram.RpTicks = Random.between(3, 12);
  Dram.RasTicks = Random.between(12, 30);
  Dram.CcdShortTicks = Dram.CcdLongTicks = Dram.BurstTicks;
  Dram.ReadQueueEntries = Dram.WriteQueueEntries = Random.between(4, 8);
  Dram.WriteHighMark = 4;
  Dram.WriteLowMark = 2;
  Dram.ControllerCycles = Random.between(0, 9);
  return Dram;
}

ChipConfig randomMemoryChip(RandomSource &Random) {
  ChipConfig Chip = randomChip(Random);
  Chip.MemoryLatency = Random.between(5, 60);
  do {
    Chip.L1.reset();
    Chip.Crossbar.reset();
    Chip.L2.reset();
    Chip.Dram.reset();
    if (!Random.oneIn(4))
      Chip.L1 = randomCache(Random, 12);
    if (Random.oneIn(2))
      Chip.Crossbar = randomCrossbar(Random);
    if (Random.oneIn(2)) {
      Chip.L2 = randomCache(Random, 25);
      Chip.TmsPerL2 = Random.between(1, Chip.TmCount);
    }
    if (Random.oneIn(2))
      Chip.Dram = randomDram(Random);
  } while (!Chip.hasMemorySystem());
  Chip.StoreBufferEntries = Random.between(1, 8);
  uint32_t Longest = uint32_t(minimumRoundTrip(Chip));
  Chip.ArbitrationWindow =
      Random.oneIn(2) ? Longest : Random.between(1, Longest);
  return Chip;
}

} // namespace tp::test
