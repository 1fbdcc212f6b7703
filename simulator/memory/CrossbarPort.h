//===- CrossbarPort.h - One way of a TM's crossbar port ---------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_MEMORY_CROSSBARPORT_H
#define TP_SIMULATOR_MEMORY_CROSSBARPORT_H

#include "simulator/core/Archive.h"

#include <algorithm>
#include <cstdint>

namespace tp {

/// A port that passes some bytes a cycle, in the order in which it is used.
class CrossbarPort {
public:
  CrossbarPort(uint32_t BytesPerCycle, uint32_t Latency)
      : BytesPerCycle(BytesPerCycle), Latency(Latency) {}

  /// Sends a message that is there at \p Cycle; gives the cycle in which its
  /// last byte is at the other side. One of no bytes does not wait.
  uint64_t send(uint64_t Cycle, uint32_t Bytes) {
    this->Bytes += Bytes;
    if (Bytes == 0)
      return Cycle + Latency;
    uint64_t Start = std::max(Cycle, Free);
    Waited += Start - Cycle;
    Free = Start + (Bytes + BytesPerCycle - 1) / BytesPerCycle;
    return Free - 1 + Latency;
  }

  uint64_t bytes() const { return Bytes; }
  /// Cycles that messages waited for the port.
  uint64_t waitCycles() const { return Waited; }

  void serialize(Archive &A) {
    A(Free);
    A(Bytes);
    A(Waited);
  }

private:
  uint32_t BytesPerCycle;
  uint32_t Latency;
  /// The first cycle in which nothing is on its way into the port.
  uint64_t Free = 0;
  uint64_t Bytes = 0;
  uint64_t Waited = 0;
};

} // namespace tp

#endif // TP_SIMULATOR_MEMORY_CROSSBARPORT_H
