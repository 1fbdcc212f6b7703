//===- State.h - What can be seen of a machine ------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_TEST_UNIT_REPLAY_STATE_H
#define TP_TEST_UNIT_REPLAY_STATE_H

#include "simulator/functional/FunctionalMachine.h"
#include "simulator/replay/Replay.h"

#include <array>
#include <cstdint>
#include <vector>

namespace tp::test {

/// What can be seen of a machine at a moment.
struct State {
  std::vector<std::array<uint32_t, NumRegisters>> Registers;
  std::vector<uint32_t> Pcs;
  std::vector<uint8_t> Memory;
  std::vector<uint8_t> LocalStores;
  /// Executions of each word of the text.
  std::vector<uint64_t> Executed;
  /// Of each thread.
  std::vector<uint64_t> Issued;
  /// With timing.
  std::vector<LossCounts> Lost;

  bool operator==(const State &) const = default;
};

/// Of a replay and its memory.
State stateOf(const Replay &R, const ChipConfig &Chip, const Memory &Global);

/// Of an engine between two runs, and its memory.
State stateOf(const Engine &Machine, const ChipConfig &Chip,
              const Program &Text, const Memory &Global);
/// Likewise without timing.
State stateOf(const FunctionalMachine &Machine, const ChipConfig &Chip,
              const Memory &Global);

} // namespace tp::test

#endif // TP_TEST_UNIT_REPLAY_STATE_H
