//===- MinimumRoundTrip.h - Shortest ways in memory -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHIP_MINIMUMROUNDTRIP_H
#define TP_SIMULATOR_CHIP_MINIMUMROUNDTRIP_H

#include "simulator/chip/ChipConfig.h"

#include <cstdint>

namespace tp {

/// The least cycles that parts of an access beyond the L1 take.
struct ShortestWays {
  /// From the issue to the arrival at what TMs share: the L2, or memory.
  uint64_t ToShared = 0;
  /// There: from the arrival to the answer's departure.
  uint64_t InShared = 0;
  /// From there back to the TM.
  uint64_t Back = 0;
  /// In memory behind an L2: from the arrival of a request to the answer.
  uint64_t InMemory = 0;
};

/// Of a chip with a memory system.
ShortestWays shortestWays(const ChipConfig &Chip);

/// The longest arbitration window that a chip may have: what a TM asks of
/// others in a window is answered only after it, and so is what an L2 asks of
/// DRAM. MemoryLatency without a memory system.
uint64_t minimumRoundTrip(const ChipConfig &Chip);

} // namespace tp

#endif // TP_SIMULATOR_CHIP_MINIMUMROUNDTRIP_H
