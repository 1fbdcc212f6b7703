//===- ScriptedMemory.h - A memory system that does as told -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_TEST_UNIT_CORE_SCRIPTEDMEMORY_H
#define TP_TEST_UNIT_CORE_SCRIPTEDMEMORY_H

#include "simulator/memory/MemorySystem.h"
#include "test/unit/core/Simulation.h"

#include <memory>
#include <utility>
#include <vector>

namespace tp::test {

/// What the scripted memory answers is in the address, in units of 256 bytes
/// from DataBegin on: in the first 256 bytes an L1, if there is one, hits; in
/// the n-th after them the answer comes 10 n cycles after the request, from the
/// L2 if n is 1 to 4, from fixed-latency memory if it is 5 to 9, else from
/// DRAM.
///
/// An L1 serves one request a cycle, in the order (cycle, priority). Lines of
/// the text come 30 cycles after the request, past the L1.
struct ScriptedMemory {
  /// A chip of quietChip() with this memory. \p L1Latency 0: without an L1.
  static ChipConfig chip(uint32_t TmCount, uint32_t TpsPerTm,
                         uint32_t L1Latency = 0);
  static std::unique_ptr<MemorySystem> make(const ChipConfig &Chip);
  /// Where answers take so many cycles; 0: where an L1 hits.
  static uint32_t offset(uint32_t Cycles) { return Cycles / 10 * 256; }
};

} // namespace tp::test

#endif // TP_TEST_UNIT_CORE_SCRIPTEDMEMORY_H
