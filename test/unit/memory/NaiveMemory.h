//===- NaiveMemory.h - The rules of memory, literally -----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// docs/memory-system.md done cycle by cycle with the plainest means, to compare
// the memory system with. Of that only the DRAM channels are used.
//
//===----------------------------------------------------------------------===//

#ifndef TP_TEST_UNIT_MEMORY_NAIVEMEMORY_H
#define TP_TEST_UNIT_MEMORY_NAIVEMEMORY_H

#include "simulator/memory/dram/DramAddressMapping.h"
#include "simulator/memory/dram/DramChannel.h"
#include "test/unit/memory/MemoryHarness.h"

#include <deque>
#include <functional>
#include <list>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace tp::test {

/// Called with the cycle and level of an answer.
using NaiveAnswer = std::function<void(uint64_t, ServedBy)>;

/// An access anywhere in the naive model.
struct NaiveAccess {
  RequestKind Kind;
  uint32_t Address;
  uint32_t Bytes;
  /// Empty if nobody waits.
  NaiveAnswer Done;
  uint64_t Arrival = 0;
  std::optional<uint64_t> FirstAttempt = {};
};

class NaiveCache {
public:
  /// \p Send takes what goes to the next level, and the cycle of departure.
  using SendFunction = std::function<void(uint64_t, const NaiveAccess &)>;
  NaiveCache(const CacheConfig &Config, ServedBy Level, SendFunction Send)
      : Config(Config), Level(Level), Send(std::move(Send)),
        Sets(Config.Bytes / Config.LineBytes / Config.Ways),
        Banks(Config.Banks) {}

  void arrive(const NaiveAccess &Access) {
    Banks[Access.Address / Config.BankBytes % Config.Banks].push_back(Access);
  }
  /// The parts of a cycle: what arrives from the next level comes first.
  void fillArrived(uint64_t Cycle);
  void serve(uint64_t Cycle);

  CacheStatistics Counts;

private:
  struct Line {
    uint32_t Number;
    std::set<uint32_t> Valid;
    std::set<uint32_t> Dirty;
  };
  struct Miss {
    std::optional<uint64_t> Arrival;
    ServedBy From = ServedBy::L1;
    /// With the cycle before which none is answered.
    std::vector<std::pair<uint64_t, NaiveAnswer>> Waiting;
    unsigned Joined = 0;
    bool MakesDirty = false;
  };

  std::list<Line> &setOf(uint32_t Sector) {
    return Sets[lineOf(Sector) % Sets.size()];
  }
  uint32_t lineOf(uint32_t Sector) const {
    return Sector / (Config.LineBytes / Config.SectorBytes);
  }
  Line *find(uint32_t Sector, bool Use);
  void insert(uint64_t Cycle, uint32_t Sector, bool IsDirty);
  void writeBack(uint64_t Cycle, uint32_t Sector);
  bool attempt(uint64_t Cycle, NaiveAccess &Access);
  bool miss(uint64_t Cycle, const NaiveAccess &Access, uint32_t Sector,
            bool MakesDirty);

  CacheConfig Config;
  ServedBy Level;
  SendFunction Send;
  /// The last used line first.
  std::vector<std::list<Line>> Sets;
  std::vector<std::deque<NaiveAccess>> Banks;
  std::map<uint32_t, Miss> Misses;
};

/// One way through a crossbar.
class NaivePort {
public:
  NaivePort(uint32_t BytesPerCycle, uint32_t Latency)
      : BytesPerCycle(BytesPerCycle), Latency(Latency) {}

  using Arrive = std::function<void(uint64_t)>;
  /// A message stands at the port from now on; \p Done is told when its last
  /// byte is through.
  void put(uint64_t Cycle, uint32_t Bytes, Arrive Done);
  void tick(uint64_t Cycle);

private:
  struct Message {
    uint32_t Left;
    Arrive Done;
  };
  uint32_t BytesPerCycle;
  uint32_t Latency;
  std::deque<Message> Queue;
};

/// The whole memory system.
class NaiveMemory {
public:
  explicit NaiveMemory(const ChipConfig &Chip);

  /// Simulates the next cycle, in which these requests are issued.
  void tick(std::vector<TmRequest> Issued);

  Outcomes Answered;
  MemoryStatistics statistics() const;

private:
  struct Tm {
    std::optional<NaiveCache> L1;
    std::optional<NaivePort> Requests;
    std::optional<NaivePort> Answers;
  };

  void leaveTm(uint32_t Number, const NaiveAccess &Access);
  void arriveShared(uint32_t Number, uint64_t Cycle, const NaiveAccess &Access);
  void answerTm(uint32_t Number, uint64_t Cycle, uint64_t Sequence,
                uint32_t Bytes, const NaiveAnswer &Done, ServedBy Level);
  /// \p Source and \p Sequence order what arrives in one cycle.
  void arriveMemory(uint64_t Cycle, const NaiveAccess &Access, uint32_t Source);
  void tickDram();

  /// What is to happen in later cycles, in the order of keys.
  struct Key {
    uint64_t Cycle;
    uint64_t Source;
    uint64_t Sequence;
    auto operator<=>(const Key &) const = default;
  };
  using Agenda = std::multimap<Key, std::function<void()>>;
  void runDue(Agenda &Agenda);

  ChipConfig Chip;
  uint64_t Now = 0;
  std::vector<Tm> Tms;
  std::vector<NaiveCache> L2s;
  Agenda Departures, SharedArrivals, Returns, Deliveries;
  std::optional<DramAddressMapping> Mapping;
  std::vector<DramChannel> Channels;
  std::map<uint64_t, std::function<void(const DramAnswer &)>> DramWaiting;
  Agenda DramArrivals;
  /// Of all accesses there ever were.
  std::deque<unsigned> PartsLeft;
  uint64_t NextDramTag = 0;
  uint64_t NextSequence = 0;
};

} // namespace tp::test

#endif // TP_TEST_UNIT_MEMORY_NAIVEMEMORY_H
