//===- TmPath.h - A TM's way to memory --------------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The L1, the crossbar ports and, if nothing is shared, the memory behind them:
// each of these may be absent.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_MEMORY_TMPATH_H
#define TP_SIMULATOR_MEMORY_TMPATH_H

#include "simulator/memory/Cache.h"
#include "simulator/memory/CrossbarPort.h"
#include "simulator/memory/MemorySystem.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tp {

/// What the shared part sends back to a TM.
struct ReturnMessage {
  /// Of departure.
  uint64_t Cycle;
  /// Of the request: orders what departs in one cycle.
  uint32_t Sequence;
  uint32_t Tag;
  uint32_t Bytes;
  ServedBy Level;
};

/// One TM's side of the memory system.
class TmPath final : public TmMemory, private CacheClient {
public:
  /// \p Granule: requests to the shared part lie in one aligned block of so
  /// many bytes each; 0 if nothing is shared.
  TmPath(const ChipConfig &Chip, uint32_t Granule);
  TmPath(const TmPath &) = delete;

  void request(const MemoryRequest &Request) override { Requests.add(Request); }
  void advance(uint64_t Cycle, std::vector<MemoryAnswer> &Answers) override;
  uint64_t nextEvent() const override;
  void takeAnswers(std::vector<MemoryAnswer> &Answers) override;
  bool hasAnswers() const override { return !Late.empty(); }

  /// Requests to the shared part, in the order of their arrival there; for it
  /// to clear.
  std::vector<Access> Outgoing;

  /// A message departs, no earlier than what deliver() has done.
  void sendBack(const ReturnMessage &Message);
  /// Brings back all that departs before \p Limit, which is now known to be
  /// all.
  void deliver(uint64_t Limit);

  /// Brings into the host's cache what the next calls need: the object itself,
  /// and, if that is there already, what it points to.
  void prefetchObject() const;
  void prefetchBuffers() const;
  /// The earliest departure of what was not delivered.
  uint64_t nextReturn() const {
    return Returns.empty() ? NoCycle : Returns.front().Cycle;
  }

  /// Adds up what was counted.
  void addTo(MemoryStatistics &Sum) const;
  void serialize(Archive &A);

  /// @{ What the L1 sees as its arrivals.
  uint64_t nextCycle() const { return Requests.nextCycle(); }
  std::span<const MemoryRequest> arrivals() const { return Requests.entries(); }
  uint32_t take();
  uint32_t addToPool(uint32_t Arrival);
  void answerHit(uint32_t Arrival, uint64_t Ready) {
    const MemoryRequest &Request = arrivals()[Arrival];
    Early->push_back({Ready, Request.Ticket, Request.Tp, ServedBy::L1});
  }
  void drop(uint32_t Count) { Requests.pop(Count); }
  /// @}

private:
  struct RequestBefore {
    static uint64_t key(const MemoryRequest &Request) {
      return Request.Cycle << 18 | uint64_t(Request.Priority) << 2 |
             uint64_t(Request.Kind);
    }
    bool operator()(const MemoryRequest &A, const MemoryRequest &B) const {
      return key(A) < key(B);
    }
  };
  static bool later(const ReturnMessage &A, const ReturnMessage &B) {
    return A.Cycle != B.Cycle ? A.Cycle > B.Cycle : A.Sequence > B.Sequence;
  }
  /// Tags with this bit name miss registers, those without accesses.
  static constexpr uint32_t RegisterTag = 1u << 31;

  void answer(uint32_t Index, uint64_t Ready, ServedBy Level) override;
  void postpone(uint32_t Index) override;
  void fetch(uint32_t Register, uint32_t Address, uint64_t Departure) override;
  void forward(uint32_t Index, uint64_t Departure) override;
  void write(uint32_t Address, uint32_t Bytes, uint64_t Departure) override;

  /// How many requests to the shared part an access makes.
  uint32_t partsOf(uint32_t Address, uint32_t Bytes) const;
  void send(uint64_t Departure, uint32_t Address, uint32_t Bytes,
            RequestKind Kind, uint32_t Tag);
  void sendParts(Access Request);
  /// A part of the answer to what was sent with \p Tag is back.
  void receive(uint32_t Tag, uint64_t Cycle, ServedBy Level);
  /// Likewise, of an access that has gone on.
  void receivePart(uint32_t Index, uint64_t Cycle, ServedBy Level);

  const uint32_t Granule;
  const uint32_t HeaderBytes;
  const uint32_t MemoryLatency;
  const uint32_t L1Latency;
  const uint32_t L1SectorBytes;

  AccessPool Pool;
  TimeQueue<MemoryRequest, RequestBefore> Requests;
  /// @{ What the chip has of these, and where it is, or null.
  std::optional<Cache> OwnL1;
  std::optional<CrossbarPort> OwnRequestPort;
  std::optional<CrossbarPort> OwnAnswerPort;
  Cache *L1 = nullptr;
  CrossbarPort *RequestPort = nullptr;
  CrossbarPort *AnswerPort = nullptr;
  /// @}
  /// A heap of what is on its way back.
  std::vector<ReturnMessage> Returns;
  /// Numbers of messages and of parts of them that were sent.
  uint64_t Messages = 0;
  uint32_t NextSequence = 0;
  uint64_t Sent = 0;

  /// Where advance() wants its answers, and the others.
  std::vector<MemoryAnswer> *Early = nullptr;
  std::vector<MemoryAnswer> Late;
};

} // namespace tp

#endif // TP_SIMULATOR_MEMORY_TMPATH_H
