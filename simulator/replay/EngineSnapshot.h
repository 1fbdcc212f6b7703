//===- EngineSnapshot.h - A machine's state in little memory ----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_REPLAY_ENGINESNAPSHOT_H
#define TP_SIMULATOR_REPLAY_ENGINESNAPSHOT_H

#include "simulator/core/BufferArchive.h"

#include <cassert>
#include <cstdint>
#include <vector>

namespace tp {

/// What serialize() of an Engine or a FunctionalMachine saves.
class EngineSnapshot {
public:
  EngineSnapshot() = default;
  /// Of \p Source between two runs. A packed one needs less memory and more
  /// time.
  template <class Machine> EngineSnapshot(Machine &Source, bool IsPacked) {
    SavingArchive A;
    Source.serialize(A);
    keep(A.collected(), IsPacked);
  }

  template <class Machine> void restore(Machine &Target) const {
    std::vector<uint8_t> Unpacked = unpacked();
    RestoringArchive A(UnpackedBytes == 0 ? State : Unpacked);
    Target.serialize(A);
    assert(A.isComplete() && "a snapshot of another machine");
  }
  /// Bytes of host memory.
  uint64_t bytes() const { return State.capacity(); }

private:
  void keep(const std::vector<uint8_t> &Collected, bool IsPacked);
  /// Of a packed one.
  std::vector<uint8_t> unpacked() const;

  std::vector<uint8_t> State;
  /// Of a packed one, its size when it is not; else 0.
  size_t UnpackedBytes = 0;
};

} // namespace tp

#endif // TP_SIMULATOR_REPLAY_ENGINESNAPSHOT_H
