//===- MemorySystem.h - Caches, crossbar and DRAM of a chip -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Two parts: what belongs to a TM (its L1), which runs with the TM, and what
// TMs share (crossbar, L2s, DRAM), which runs between windows. Nothing that a
// TM asks in a window comes back to it before the window's end: chip files
// whose window is longer than the shortest round trip are refused.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_MEMORY_MEMORYSYSTEM_H
#define TP_SIMULATOR_MEMORY_MEMORYSYSTEM_H

#include "simulator/chip/ChipConfig.h"
#include "simulator/core/Archive.h"
#include "simulator/memory/MemoryRequest.h"
#include "simulator/memory/MemoryStatistics.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace tp {

/// A TM's side of the memory system. One host thread at a time may use it.
class TmMemory {
public:
  virtual ~TmMemory() = default;

  /// Takes a request of the window at hand, in any order, but no earlier than
  /// the cycle up to which advance() has decided.
  virtual void request(const MemoryRequest &Request) = 0;

  /// Decides all that happens in the TM before \p Cycle, in the order of time,
  /// and appends the answers that this makes known; their ReadyCycle may be
  /// any later one. All requests before \p Cycle must have been made. With an
  /// L1 a hit's answer is known here; of a load or store that goes on to the
  /// next level, that it is AnsweredLater. None is ready earlier than the L1's
  /// latency after the start of its service, which is decided here if it is
  /// before \p Cycle.
  virtual void advance(uint64_t Cycle, std::vector<MemoryAnswer> &Answers) = 0;
  /// The first cycle, not before that of the last advance(), in which something
  /// happens in the TM without new requests and answers from outside; ~0 if
  /// nothing does.
  virtual uint64_t nextEvent() const = 0;

  /// Appends the answers that the last finishWindow() made known: none is ready
  /// before the window's end.
  virtual void takeAnswers(std::vector<MemoryAnswer> &Answers) = 0;
  /// Whether takeAnswers() would append any.
  virtual bool hasAnswers() const = 0;
};

/// The memory system of a chip that has an L1, an L2 or DRAM.
class MemorySystem {
public:
  virtual ~MemorySystem() = default;

  virtual TmMemory &tm(uint32_t Tm) = 0;
  /// A hint that tm(\p Tm) is used soon, and the one two further after it.
  virtual void prefetch(uint32_t) const {}

  /// The shared part of a window's work, after advance(WindowEnd) of every TM
  /// that has requests: for each stage in order, runPart() of all its parts,
  /// which may run at the same time. Then takeAnswers() has the answers.
  virtual unsigned stages() const = 0;
  virtual unsigned parts(unsigned Stage) const = 0;
  virtual void runPart(unsigned Stage, unsigned Part, uint64_t WindowEnd) = 0;
  /// The first cycle in which the shared part has something to decide by
  /// itself; ~0 if it waits for requests.
  virtual uint64_t nextEvent() const = 0;

  /// Counts up to the last window's end.
  virtual MemoryStatistics statistics(uint64_t WindowEnd) const = 0;
  virtual void serialize(Archive &A) = 0;
};

/// Null if the chip has neither caches nor DRAM.
std::unique_ptr<MemorySystem> makeMemorySystem(const ChipConfig &Chip);

} // namespace tp

#endif // TP_SIMULATOR_MEMORY_MEMORYSYSTEM_H
