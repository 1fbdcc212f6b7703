//===- MemoryRequest.h - What TPs ask of the memory system ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The memory system is about time alone: it holds tags, not data. What loads
// and stores do to values is the engine's business (docs/cycle-model.md).
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_MEMORY_MEMORYREQUEST_H
#define TP_SIMULATOR_MEMORY_MEMORYREQUEST_H

#include <cstdint>

namespace tp {

enum class RequestKind : uint8_t {
  Load,
  Store,
  /// Atomics and stream operations: done at the level behind the L1.
  Atomic,
  /// A line for the instruction cache; does not go through the L1.
  Fetch,
};

/// An access that a TP issued. Those of a TM are served in the order (Cycle,
/// Priority).
struct MemoryRequest {
  /// Cycle of issue.
  uint64_t Cycle;
  uint32_t Address;
  /// The asker's name for it, given back with the answer.
  uint32_t Ticket;
  /// Of the TP within its TM, in the arbitration window of Cycle.
  uint16_t Priority;
  uint16_t Tp;
  uint16_t Bytes;
  RequestKind Kind;
};

/// The level that had what was asked for, the nearest first. Of what comes in
/// parts it is that of the last one to come, of several the farthest.
enum class ServedBy : uint8_t {
  L1,
  L2,
  /// The controller of a channel: it took a store, or had the data among those
  /// to be written.
  DramQueue,
  /// A burst of DRAM whose row was open, which found no row open, or another.
  DramRowHit,
  DramRowMiss,
  DramRowConflict,
  /// Memory of fixed latency.
  Memory,
};
inline constexpr unsigned NumServedBy = unsigned(ServedBy::Memory) + 1;

constexpr bool isDram(ServedBy Level) {
  return Level >= ServedBy::DramQueue && Level <= ServedBy::DramRowConflict;
}

/// The ReadyCycle of an answer that only says that the request has gone beyond
/// the L1: a second answer follows after a finishWindow(), of this or a later
/// window.
inline constexpr uint64_t AnsweredLater = ~uint64_t(0);

/// When a request is done: a load's or atomic's result is ready, a store has
/// been taken by the level that keeps it, a line has arrived.
struct MemoryAnswer {
  uint64_t ReadyCycle;
  uint32_t Ticket;
  uint16_t Tp;
  ServedBy Level;
};

} // namespace tp

#endif // TP_SIMULATOR_MEMORY_MEMORYREQUEST_H
