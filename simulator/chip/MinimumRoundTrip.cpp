//===- MinimumRoundTrip.cpp - Shortest ways in memory ---------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/chip/MinimumRoundTrip.h"

#include "simulator/memory/dram/DramChannel.h"
#include "simulator/memory/dram/DramClock.h"

#include <algorithm>

namespace tp {

ShortestWays shortestWays(const ChipConfig &Chip) {
  ShortestWays Ways;
  if (Chip.L1)
    Ways.ToShared += Chip.L1->Latency;
  if (Chip.Crossbar) {
    uint32_t HeaderCycles =
        (Chip.Crossbar->HeaderBytes - 1) / Chip.Crossbar->RequestBytesPerCycle +
        1;
    Ways.ToShared += HeaderCycles - 1 + Chip.Crossbar->Latency;
    Ways.Back = Chip.Crossbar->Latency;
  }
  Ways.InMemory =
      Chip.Dram ? minimumDramReadCycles(*Chip.Dram, clockKHz(Chip.ClockGHz))
                : Chip.MemoryLatency;
  Ways.InShared = Chip.L2 ? Chip.L2->Latency : Ways.InMemory;
  return Ways;
}

uint64_t minimumRoundTrip(const ChipConfig &Chip) {
  if (!Chip.hasMemorySystem())
    return Chip.MemoryLatency;
  ShortestWays Ways = shortestWays(Chip);
  uint64_t Cycles = Ways.ToShared + Ways.InShared + Ways.Back;
  if (Chip.L2 && Chip.Dram)
    Cycles = std::min(Cycles, Chip.L2->Latency + Ways.InMemory);
  return Cycles;
}

} // namespace tp
