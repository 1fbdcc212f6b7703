//===- EngineSnapshot.h - An engine's state in little memory ----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_REPLAY_ENGINESNAPSHOT_H
#define TP_SIMULATOR_REPLAY_ENGINESNAPSHOT_H

#include "simulator/core/Engine.h"

#include <cstdint>
#include <vector>

namespace tp {

/// What Engine::serialize() saves.
class EngineSnapshot {
public:
  EngineSnapshot() = default;
  /// Of \p Machine between two runs. A packed one needs less memory and more
  /// time.
  EngineSnapshot(Engine &Machine, bool IsPacked);

  void restore(Engine &Machine) const;
  /// Bytes of host memory.
  uint64_t bytes() const { return State.capacity(); }

private:
  std::vector<uint8_t> State;
  /// Of a packed one, its size when it is not; else 0.
  size_t UnpackedBytes = 0;
};

} // namespace tp

#endif // TP_SIMULATOR_REPLAY_ENGINESNAPSHOT_H
