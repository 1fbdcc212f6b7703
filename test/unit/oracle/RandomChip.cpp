//===- RandomChip.cpp - Random chips --------------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/oracle/RandomProgram.h"

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

} // namespace tp::test
