//===- DramChannels.cpp - The DRAM of a chip ------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/memory/DramChannels.h"

#include "simulator/memory/dram/DramClock.h"

#include <algorithm>

namespace tp {

DramChannels::DramChannels(const DramConfig &Config, double ChipGHz)
    : Mapping(Config),
      WriteAnswerCycles(minimumDramReadCycles(Config, clockKHz(ChipGHz)) -
                        minimumDramWriteCycles(Config)) {
  Channels.reserve(Config.Channels);
  for (uint32_t I = 0; I != Config.Channels; ++I)
    Channels.push_back({DramChannel(Config, clockKHz(ChipGHz)), {}, {}});
}

void DramChannels::add(const BurstRequest &Request) {
  Channels[Mapping.channelOf(Request.Address)].Arrivals.add(Request);
}

void DramChannels::advance(uint32_t Number, uint64_t Limit) {
  Channel &C = Channels[Number];
  C.Arrivals.settle();
  for (; C.Arrivals.nextCycle() < Limit; C.Arrivals.pop()) {
    const BurstRequest &Request = C.Arrivals.front();
    C.Controller.enqueue({Request.Cycle, Request.Address,
                          uint64_t(Request.Group) << 32 | Request.Tag,
                          Request.IsWrite});
  }
  if (C.Controller.nextEvent() < Limit)
    C.Controller.advance(Limit, C.Answers);
}

BurstAnswer DramChannels::burstAnswer(const DramAnswer &Answer) const {
  return {Answer.ReadyCycle + (Answer.IsWrite ? WriteAnswerCycles : 0),
          uint32_t(Answer.Tag), Answer.Level};
}

uint64_t DramChannels::nextEvent() const {
  uint64_t Next = NoCycle;
  for (const Channel &C : Channels)
    Next = std::min({Next, C.Arrivals.nextCycle(), C.Controller.nextEvent()});
  return Next;
}

uint64_t DramChannels::underWay() const {
  uint64_t Count = 0;
  for (const Channel &C : Channels)
    Count += C.Arrivals.size();
  return Count;
}

std::vector<DramChannelStatistics>
DramChannels::statistics(uint64_t Cycle) const {
  std::vector<DramChannelStatistics> Counts;
  Counts.reserve(Channels.size());
  for (const Channel &C : Channels)
    Counts.push_back(C.Controller.statistics(Cycle));
  return Counts;
}

void DramChannels::serialize(Archive &A) {
  for (Channel &C : Channels) {
    C.Controller.serialize(A);
    A(C.Arrivals);
  }
}

} // namespace tp
