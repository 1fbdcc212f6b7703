//===- ArchitecturalState.h - A thread as its program knows it --*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_ARCHITECTURALSTATE_H
#define TP_SIMULATOR_CORE_ARCHITECTURALSTATE_H

#include "simulator/core/Thread.h"

#include <array>
#include <cstdint>

namespace tp {

/// What a thread is in any kind of execution: where one can be left and another
/// begin.
struct ArchitecturalState {
  std::array<uint32_t, NumRegisters> Registers{};
  uint32_t Pc = 0;
  /// Not Trapped.
  ThreadState State = ThreadState::Running;
  /// With which it halted.
  int32_t Status = 0;
  /// The chip's LocalStoreBytes of them.
  const uint8_t *LocalStore = nullptr;
};

} // namespace tp

#endif // TP_SIMULATOR_CORE_ARCHITECTURALSTATE_H
