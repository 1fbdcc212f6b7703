//===- DramChannels.h - The DRAM of a chip ----------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_MEMORY_DRAMCHANNELS_H
#define TP_SIMULATOR_MEMORY_DRAMCHANNELS_H

#include "simulator/chip/MemoryConfig.h"
#include "simulator/memory/TimeQueue.h"
#include "simulator/memory/dram/DramChannel.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tp {

/// What a TM or an L2 asks of DRAM: a burst.
struct BurstRequest {
  /// Of arrival.
  uint64_t Cycle;
  uint32_t Address;
  /// Of the group, and its name for the request, given back with the answer.
  uint32_t Group;
  uint32_t Tag;
  /// Source and Sequence order what arrives in one cycle.
  uint32_t Source;
  uint32_t Sequence;
  bool IsWrite;
};

/// An answer to a group.
struct BurstAnswer {
  uint64_t Cycle;
  uint32_t Tag;
  ServedBy Level;
};

/// All channels, with what has been sent to them.
class DramChannels {
public:
  DramChannels(const DramConfig &Config, double ChipGHz);

  uint32_t size() const { return uint32_t(Channels.size()); }

  /// Hands a request to its channel.
  void add(const BurstRequest &Request);
  /// Lets a channel decide all before \p Limit; all requests before it must
  /// have been added. Different channels may run at the same time.
  void advance(uint32_t Channel, uint64_t Limit);
  /// Calls \p Take(Group, BurstAnswer) for each answer that the last advance()
  /// of the channels made known.
  template <class TakeFunction> void takeAnswers(TakeFunction Take) {
    for (Channel &C : Channels) {
      for (const DramAnswer &Answer : C.Answers)
        if (uint32_t(Answer.Tag) != NoAnswer)
          Take(uint32_t(Answer.Tag >> 32), burstAnswer(Answer));
      C.Answers.clear();
    }
  }
  /// The next cycle in which a channel has something to do.
  uint64_t nextEvent() const;

  /// The tag of requests whose answer nobody waits for.
  static constexpr uint32_t NoAnswer = ~uint32_t(0);

  /// Requests that have not arrived at their controller.
  uint64_t underWay() const;
  std::vector<DramChannelStatistics> statistics(uint64_t Cycle) const;
  void serialize(Archive &A);

private:
  struct ArrivalBefore {
    bool operator()(const BurstRequest &A, const BurstRequest &B) const {
      if (A.Cycle != B.Cycle)
        return A.Cycle < B.Cycle;
      if (A.Source != B.Source)
        return A.Source < B.Source;
      return A.Sequence != B.Sequence ? A.Sequence < B.Sequence
                                      : A.IsWrite < B.IsWrite;
    }
  };

  struct Channel {
    DramChannel Controller;
    TimeQueue<BurstRequest, ArrivalBefore> Arrivals;
    std::vector<DramAnswer> Answers;
  };

  BurstAnswer burstAnswer(const DramAnswer &Answer) const;

  DramAddressMapping Mapping;
  /// What a write's answer takes beyond the controller's, so that it takes at
  /// least as long as the fastest read's.
  uint64_t WriteAnswerCycles;
  std::vector<Channel> Channels;
};

} // namespace tp

#endif // TP_SIMULATOR_MEMORY_DRAMCHANNELS_H
