//===- DramChannel.h - A channel of DRAM and its controller -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The controller decides tick by tick, from what has arrived by then alone:
// which command the device gets (docs/memory-system.md has the rules). Ticks
// in which nothing can happen are skipped, and an idle channel is not touched
// at all: refreshes that came due meanwhile are caught up.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_MEMORY_DRAM_DRAMCHANNEL_H
#define TP_SIMULATOR_MEMORY_DRAM_DRAMCHANNEL_H

#include "simulator/core/Archive.h"
#include "simulator/memory/MemoryRequest.h"
#include "simulator/memory/MemoryStatistics.h"
#include "simulator/memory/dram/DramAddressMapping.h"
#include "simulator/memory/dram/DramClock.h"
#include "simulator/memory/dram/DramDevice.h"
#include "simulator/memory/dram/DramQueue.h"

#include <cstdint>
#include <deque>
#include <functional>
#include <vector>

namespace tp {

/// A read or write of the burst that holds an address.
struct DramRequest {
  /// Of arrival at the controller.
  uint64_t Cycle;
  uint64_t Address;
  /// The asker's name for it, given back with the answer.
  uint64_t Tag;
  bool IsWrite;
};

/// When a read's data is there, or a write has its place in the queue. Every
/// request gets one.
struct DramAnswer {
  uint64_t ReadyCycle;
  uint64_t Tag;
  bool IsWrite;
  ServedBy Level;
};

/// Least cycles of the chip from a read's arrival to its answer.
uint64_t minimumDramReadCycles(const DramConfig &Config, uint64_t ChipKHz);
/// Least cycles of the chip from a write's arrival to its answer.
uint64_t minimumDramWriteCycles(const DramConfig &Config);

class DramChannel {
public:
  DramChannel(const DramConfig &Config, uint64_t ChipKHz);

  /// Requests come in the order of their cycles, none before the horizon of
  /// the last advance(). Of those of one cycle the one enqueued first is the
  /// older.
  void enqueue(const DramRequest &Request);

  /// Decides all ticks before cycle \p Horizon and appends the answers that
  /// this makes known; they may be ready later. All requests before \p Horizon
  /// must have been enqueued.
  void advance(uint64_t Horizon, std::vector<DramAnswer> &Answers);

  /// advance() up to this cycle has nothing to do; ~0 without requests.
  uint64_t nextEvent() const;

  /// Counts as after advance(\p Cycle), which would answer nothing that has
  /// not been answered.
  DramChannelStatistics statistics(uint64_t Cycle) const;

  /// Calls \p Observer with each command in the order of ticks.
  void observe(std::function<void(const DramCommand &)> Observer) {
    this->Observer = std::move(Observer);
  }

  void serialize(Archive &A);

private:
  struct Arrival {
    uint64_t Tick;
    DramRequest Request;

    void serialize(Archive &A) {
      A(Tick);
      A(Request.Cycle);
      A(Request.Address);
      A(Request.Tag);
      A(Request.IsWrite);
    }
  };

  DramQueue &queue() { return Writing ? Writes : Reads; }
  const DramQueue &queue() const { return Writing ? Writes : Reads; }
  bool hasRequests() const {
    return !Arrivals.empty() || !Reads.empty() || !Writes.empty();
  }

  void admitArrivals(std::vector<DramAnswer> &Answers);
  bool admit(const DramRequest &Request, std::vector<DramAnswer> &Answers);
  /// Whether the bus is to turn before the next command.
  bool turns() const;
  /// Each issues what the tick at hand allows, and returns a tick after it,
  /// before which no more commands can be issued unless something arrives or
  /// the bus turns.
  uint64_t refreshStep();
  uint64_t schedule(std::vector<DramAnswer> &Answers);
  /// The first tick in which the device may get what \p Bank wants; ~0 if that
  /// is nothing.
  uint64_t earliest(uint32_t Bank) const;
  void issueColumn(uint32_t Bank, std::vector<DramAnswer> &Answers);
  void issueRow(uint32_t Bank);
  /// The answer to a read whose command is issued now.
  void answerRead(uint64_t ArrivalCycle, uint64_t Tag, ServedBy Level,
                  std::vector<DramAnswer> &Answers);
  void moveTo(uint64_t NewTick);
  void note(DramCommandKind Kind, uint32_t Bank = 0, uint32_t Row = 0);

  DramConfig Config;
  DramClock Clock;
  DramAddressMapping Mapping;
  DramDevice Device;

  /// The first tick that is not decided.
  uint64_t Tick = 0;
  /// No command before this tick unless something arrives.
  uint64_t NextReady = 0;
  uint64_t NextRefresh = 0;
  /// Arrival order of requests in the queues.
  uint64_t NextAge = 0;
  /// Bursts since the bus last turned.
  uint64_t BurstsOfPhase = 0;
  bool Writing = false;

  /// In front of the queues, in order.
  std::deque<Arrival> Arrivals;
  DramQueue Reads;
  DramQueue Writes;

  DramChannelStatistics Counts;
  std::function<void(const DramCommand &)> Observer;
};

} // namespace tp

#endif // TP_SIMULATOR_MEMORY_DRAM_DRAMCHANNEL_H
