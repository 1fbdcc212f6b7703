//===- MemoryHarness.h - Requests to a memory system ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_TEST_UNIT_MEMORY_MEMORYHARNESS_H
#define TP_TEST_UNIT_MEMORY_MEMORYHARNESS_H

#include "simulator/memory/MemorySystem.h"
#include "test/unit/memory/MemoryArchive.h"

#include <compare>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace tp::test {

/// A request of a TM.
struct TmRequest {
  uint32_t Tm;
  MemoryRequest Request;
};

/// What is known of a request.
struct Outcome {
  uint64_t ReadyCycle = 0;
  ServedBy Level = ServedBy::L1;

  auto operator<=>(const Outcome &) const = default;
};

/// By ticket.
using Outcomes = std::map<uint32_t, Outcome>;

/// Plays the engine's part: makes prepared requests, window by window.
class MemoryHarness {
public:
  explicit MemoryHarness(const ChipConfig &Chip)
      : Chip(Chip), System(makeMemorySystem(Chip)), Pending(Chip.TmCount) {}

  /// Prepares a request; gives its ticket.
  uint32_t request(RequestKind Kind, uint64_t Cycle, uint32_t Address,
                   uint16_t Priority = 0, uint32_t Tm = 0, uint16_t Bytes = 4);
  uint32_t load(uint64_t Cycle, uint32_t Address, uint16_t Priority = 0,
                uint32_t Tm = 0) {
    return request(RequestKind::Load, Cycle, Address, Priority, Tm);
  }
  uint32_t store(uint64_t Cycle, uint32_t Address, uint16_t Priority = 0,
                 uint32_t Tm = 0) {
    return request(RequestKind::Store, Cycle, Address, Priority, Tm);
  }
  void add(const TmRequest &Request) {
    Pending[Request.Tm].push_back(Request.Request);
  }

  /// Simulates windows of the chip's length until \p Cycle.
  void run(uint64_t Cycle) {
    while (End < Cycle)
      runWindow(End + Chip.ArbitrationWindow);
  }
  /// Simulates until \p WindowEnd as one window, the TMs' part in steps at the
  /// cycles \p Stops.
  void runWindow(uint64_t WindowEnd, const std::vector<uint64_t> &Stops = {});
  /// The first cycle that cannot be skipped.
  uint64_t nextEvent() const;
  uint64_t end() const { return End; }

  /// Of an answered request; fails the test otherwise.
  uint64_t ready(uint32_t Ticket) const { return outcome(Ticket).ReadyCycle; }
  ServedBy level(uint32_t Ticket) const { return outcome(Ticket).Level; }
  Outcome outcome(uint32_t Ticket) const;
  const Outcomes &outcomes() const { return Answered; }
  MemoryStatistics statistics() const { return System->statistics(End); }

  /// Goes on with the memory system of another run of the same chip.
  void continueFrom(MemoryHarness &Other) {
    copyThroughCheckpoint(*Other.System, *System);
    Asked = Other.Asked - Other.Answered.size();
    End = Other.End;
  }

private:
  void note(const std::vector<MemoryAnswer> &Answers);
  void askBefore(uint32_t Tm, uint64_t Limit);

  ChipConfig Chip;
  std::unique_ptr<MemorySystem> System;
  /// By TM.
  std::vector<std::vector<MemoryRequest>> Pending;
  Outcomes Answered;
  /// Requests made.
  size_t Asked = 0;
  uint32_t NextTicket = 0;
  uint64_t End = 0;
};

/// A chip of one TM with 16 TPs and nothing but memory of 100 cycles.
ChipConfig smallChip();
/// 1 KiB of lines of 64 bytes in sectors of 32, two ways, so eight sets: lines
/// 512 bytes apart are in the same. Two banks of four bytes, three cycles.
CacheConfig smallL1();
/// 4 KiB of such lines, four ways, so 16 sets. Two banks of 32 bytes, 20
/// cycles.
CacheConfig smallL2();

} // namespace tp::test

#endif // TP_TEST_UNIT_MEMORY_MEMORYHARNESS_H
