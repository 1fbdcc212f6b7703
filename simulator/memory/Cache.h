//===- Cache.h - Timing of a cache ------------------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Tags, banks and miss registers. docs/memory-system.md has the rules.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_MEMORY_CACHE_H
#define TP_SIMULATOR_MEMORY_CACHE_H

#include "simulator/chip/MemoryConfig.h"
#include "simulator/core/Archive.h"
#include "simulator/memory/AccessPool.h"
#include "simulator/memory/MemoryStatistics.h"
#include "simulator/memory/MissRegisters.h"
#include "simulator/memory/TagArray.h"
#include "simulator/memory/TimeQueue.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace tp {

/// What surrounds a cache. Departures never decrease from call to call.
class CacheClient {
public:
  /// The access is done; the cache has no further use for it.
  virtual void answer(uint32_t Index, uint64_t Ready, ServedBy Level) = 0;
  /// The access waits for a sector whose arrival is not known yet.
  virtual void postpone(uint32_t Index) = 0;
  /// Asks the next level for the sector at \p Address on behalf of a miss
  /// register: calls Cache::expect(), then or later Cache::arrive().
  virtual void fetch(uint32_t Register, uint32_t Address,
                     uint64_t Departure) = 0;
  /// The access goes on to the next level, which answers it.
  virtual void forward(uint32_t Index, uint64_t Departure) = 0;
  /// Data for the next level for which nobody waits.
  virtual void write(uint32_t Address, uint32_t Bytes, uint64_t Departure) = 0;

protected:
  ~CacheClient() = default;
};

/// A cache of one level. Its accesses live in the client's pool.
class Cache {
public:
  /// \p DoesAtomics: else atomics invalidate their sector and go on.
  Cache(const CacheConfig &Config, ServedBy Level, bool DoesAtomics,
        AccessPool &Pool, CacheClient &Client);

  /// Does everything before \p Limit. \p Arrivals has
  /// - nextCycle(), that of the next arrival;
  /// - arrivals(), those that are known in their order, which have members
  ///   Cycle, Address and Kind;
  /// - take(), which makes an access of the next one and gives its index, or
  ///   NoIndex for one that passes the cache by;
  /// - addToPool(I), which makes an access of arrivals()[I];
  /// - answerHit(I, Ready), which answers it;
  /// - drop(Count), of the first arrivals.
  template <class ArrivalQueue>
  void advance(uint64_t Limit, ArrivalQueue &Arrivals) {
    for (;;) {
      uint64_t Cycle = std::min(nextEvent(), Arrivals.nextCycle());
      if (Cycle >= Limit)
        return;
      beginCycle(Cycle);
      if (Waiting == 0 && serveUncontested(Arrivals))
        continue;
      while (Arrivals.nextCycle() == Cycle) {
        uint32_t Index = Arrivals.take();
        if (Index != NoIndex)
          enqueue(Index);
      }
      serveBanks();
    }
  }

  /// The sector of a miss register comes in so many parts, the answers to which
  /// are told one by one. None arrives before what advance() has done. With the
  /// last one those that wait for the sector are answered.
  void expect(uint32_t Register, uint32_t Parts) {
    Registers[Register].Remaining = uint16_t(Parts);
  }
  void arrive(uint32_t Register, uint64_t Cycle, ServedBy From);

  /// An access to this address is coming.
  void prefetch(uint32_t Address) const {
    Tags.prefetch(lineOf(Address >> SectorShift));
  }

  /// Brings the queues of the banks and what arrives next into the host's
  /// cache.
  void prefetch() const {
    __builtin_prefetch(Banks.data(), 1);
    __builtin_prefetch(Fills.data(), 1);
  }

  /// The next cycle by which advance() must be called even without a new
  /// access; NoCycle if it can wait.
  uint64_t nextDeadline() const {
    return Waiting != 0 || isBack() ? nextEvent() : NoCycle;
  }

  /// Accesses that wait for their bank.
  uint64_t queueLength() const;

  const CacheStatistics &statistics() const { return Counts; }
  void serialize(Archive &A);

private:
  struct Fill {
    uint64_t Cycle;
    uint32_t Sector;
    uint32_t Register;
  };
  /// The order of a heap with the earliest on top.
  static bool later(const Fill &A, const Fill &B) {
    return A.Cycle != B.Cycle ? A.Cycle > B.Cycle : A.Sector > B.Sector;
  }

  /// The next cycle in which something happens without a new access.
  uint64_t nextEvent() const {
    if ((Waiting & ~Blocked) != 0)
      return Now + 1;
    return Fills.empty() ? NoCycle : Fills.front().Cycle;
  }

  void beginCycle(uint64_t Cycle) {
    Now = Cycle;
    while (!Fills.empty() && Fills.front().Cycle == Cycle)
      completeFill();
  }
  void enqueue(uint32_t Index) {
    uint32_t Bank = bankOf(Pool[Index].Address);
    Banks[Bank].append(Pool, Index);
    Waiting |= uint64_t(1) << Bank;
  }
  uint32_t bankOf(uint32_t Address) const {
    return Address >> BankShift & BankMask;
  }

  /// Whether all arrivals of this cycle were loads for different banks, and
  /// have been served: the same as through the banks' queues, at less cost.
  template <class ArrivalQueue> bool serveUncontested(ArrivalQueue &Arrivals);
  /// Whether a load hits: then that is noted.
  bool hit(uint32_t Address) {
    uint32_t Sector = Address >> SectorShift;
    CacheLine *Line = Tags.find(lineOf(Sector));
    if (!Line || !(Line->Valid & maskOf(Sector)))
      return false;
    Tags.promote(Line);
    ++Counts.Loads;
    ++Counts.Hits;
    return true;
  }

  void serveBanks() {
    uint64_t Above = ~uint64_t(0);
    while (uint64_t Left = Waiting & ~Blocked & Above) {
      unsigned Bank = unsigned(std::countr_zero(Left));
      serveBank(Bank);
      Above = ~uint64_t(1) << Bank;
    }
  }

  void completeFill();
  void serveBank(unsigned Bank);
  /// These are false if the access cannot be served now.
  bool serve(uint32_t Index);
  bool serveRead(uint32_t Index);
  bool serveStore(uint32_t Index);
  bool serveAtomic(uint32_t Index);
  /// Joins or begins the miss of a sector that is not there.
  bool miss(uint32_t Index, bool MakesDirty, bool LineIsThere);
  /// Makes a whole sector dirty that is not there, without fetching it.
  void place(uint32_t Sector);
  /// The line of a sector, made if it is not there.
  CacheLine *lineFor(uint32_t Sector);
  void writeBack(const CacheLine &Line, uint16_t Sectors);

  uint32_t lineOf(uint32_t Sector) const { return Sector >> SectorsShift; }
  uint16_t maskOf(uint32_t Sector) const {
    return uint16_t(1u << (Sector & SectorsMask));
  }
  bool isBack() const { return Config.Writes == WritePolicy::Back; }

  const CacheConfig Config;
  const ServedBy Level;
  const bool DoesAtomics;
  const uint32_t SectorShift;
  const uint32_t SectorsShift;
  const uint32_t SectorsMask;
  const uint32_t BankShift;
  const uint32_t BankMask;
  AccessPool &Pool;
  CacheClient &Client;

  /// The cycle at hand.
  uint64_t Now = 0;
  TagArray Tags;
  MissRegisters Registers;
  /// A heap of the sectors whose arrival is known.
  std::vector<Fill> Fills;
  std::vector<AccessList> Banks;
  /// Banks with accesses, and those whose first one waits for a miss register
  /// and cannot be served before sectors arrive, as masks.
  uint64_t Waiting = 0;
  uint64_t Blocked = 0;
  CacheStatistics Counts;
};

template <class ArrivalQueue>
bool Cache::serveUncontested(ArrivalQueue &Arrivals) {
  auto Next = Arrivals.arrivals();
  std::array<uint8_t, 64> ArrivalOf;
  uint64_t Wanted = 0;
  uint32_t Count = 0;
  for (; Count != Next.size() && Next[Count].Cycle == Now; ++Count) {
    uint32_t Bank = bankOf(Next[Count].Address);
    if (Next[Count].Kind != RequestKind::Load || Wanted >> Bank & 1)
      return false;
    Wanted |= uint64_t(1) << Bank;
    ArrivalOf[Bank] = uint8_t(Count);
  }
  for (; Wanted != 0; Wanted &= Wanted - 1) {
    auto Bank = unsigned(std::countr_zero(Wanted));
    uint32_t I = ArrivalOf[Bank];
    if (hit(Next[I].Address)) {
      Arrivals.answerHit(I, Now + Config.Latency);
      continue;
    }
    uint32_t Index = Arrivals.addToPool(I);
    if (!serve(Index)) {
      enqueue(Index);
      Blocked |= uint64_t(1) << Bank;
    }
  }
  Arrivals.drop(Count);
  return true;
}

} // namespace tp

#endif // TP_SIMULATOR_MEMORY_CACHE_H
