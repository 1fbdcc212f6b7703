//===- TmGroup.h - TMs with what they share alone ---------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// TMs that share an L2; without L2s, TMs that are served together, in which
// case results do not depend on how many these are.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_MEMORY_TMGROUP_H
#define TP_SIMULATOR_MEMORY_TMGROUP_H

#include "simulator/chip/MinimumRoundTrip.h"
#include "simulator/memory/Cache.h"
#include "simulator/memory/DramChannels.h"
#include "simulator/memory/TmPath.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace tp {

/// Some TMs, numbered from 0 in the group, and their L2.
class TmGroup final : private CacheClient {
public:
  /// \p Tms of the chip from number \p FirstTm on.
  TmGroup(const ChipConfig &Chip, uint32_t Number, uint32_t FirstTm,
          std::span<const std::unique_ptr<TmPath>> Tms);
  TmGroup(const TmGroup &) = delete;

  /// Takes over what the TMs have sent and does all that the L2 does before
  /// \p Limit.
  void advance(uint64_t Limit);
  /// An answer from DRAM.
  void takeAnswer(const BurstAnswer &Answer) { Answers.push_back(Answer); }
  /// Brings back to the TMs what departs before \p Limit. All answers from DRAM
  /// before it must have been taken.
  void deliver(uint64_t Limit);

  /// Requests to DRAM, for it to clear.
  std::vector<BurstRequest> Outgoing;

  /// The least cycle with something to do at the L2, or in deliver().
  uint64_t nextAdvance() const;
  uint64_t nextReturn() const { return NextReturn; }

  /// Adds up what was counted.
  void addTo(MemoryStatistics &Sum) const;
  void serialize(Archive &A);

  /// @{ What the L2 sees as its arrivals.
  uint64_t nextCycle() const { return Requests.nextCycle(); }
  std::span<const Access> arrivals() const { return Requests.entries(); }
  uint32_t take() {
    uint32_t Index = addToPool(0);
    Requests.pop();
    return Index;
  }
  uint32_t addToPool(uint32_t Arrival) { return Pool.add(arrivals()[Arrival]); }
  void answerHit(uint32_t Arrival, uint64_t Ready) {
    sendBack(arrivals()[Arrival], Ready, ServedBy::L2);
  }
  void drop(uint32_t Count) { Requests.pop(Count); }
  /// @}

private:
  /// Tags with this bit name miss registers, those without accesses.
  static constexpr uint32_t RegisterTag = 1u << 31;

  void answer(uint32_t Index, uint64_t Ready, ServedBy Level) override;
  void postpone(uint32_t) override {}
  void fetch(uint32_t Register, uint32_t Address, uint64_t Departure) override;
  void forward(uint32_t Index, uint64_t Departure) override;
  void write(uint32_t Address, uint32_t Bytes, uint64_t Departure) override;

  void sendBack(const Access &A, uint64_t Departure, ServedBy Level);
  /// Without an L2: hands a TM's request to DRAM.
  void passOn(const Access &Request);
  uint32_t burstsOf(uint32_t Address, uint32_t Bytes) const;
  void sendBursts(uint64_t Cycle, uint32_t Address, uint32_t Bytes,
                  bool IsWrite, uint32_t Tag);
  void receive(const BurstAnswer &Answer);

  const uint32_t Number;
  const uint32_t FirstTm;
  /// 0 without DRAM.
  const uint32_t BurstBytes;
  const uint32_t SectorBytes;
  const uint32_t MemoryLatency;
  /// Whether TMs send anything that nobody waits for.
  const bool HasUnawaited;
  const std::span<const std::unique_ptr<TmPath>> Tms;

  AccessPool Pool;
  TimeQueue<Access, AccessBefore> Requests;
  std::optional<Cache> OwnL2;
  /// It, or null.
  Cache *L2 = nullptr;
  std::vector<BurstAnswer> Answers;
  uint32_t NextSequence = 0;
  /// By the L2; without one, what atomics write.
  uint64_t Sent = 0;
  uint64_t NextReturn = NoCycle;
};

} // namespace tp

#endif // TP_SIMULATOR_MEMORY_TMGROUP_H
