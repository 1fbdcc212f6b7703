//===- Moment.h - A point of a run ------------------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_REPLAY_MOMENT_H
#define TP_SIMULATOR_REPLAY_MOMENT_H

#include <compare>
#include <cstdint>

namespace tp {

/// A point of a run between two instructions.
///
/// With timing, Time is a cycle: all that was issued in earlier cycles has
/// happened, and what earlier cycles stored is in memory. Threads that issue in
/// the same cycle follow each other by Order.
///
/// Without timing, Time is the number of instructions that all threads have
/// executed, and Order is 0.
struct Moment {
  uint64_t Time = 0;
  uint32_t Order = 0;

  auto operator<=>(const Moment &) const = default;
};

} // namespace tp

#endif // TP_SIMULATOR_REPLAY_MOMENT_H
