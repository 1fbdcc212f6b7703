//===- SharedMemorySystem.cpp - Memory of all the TMs ---------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/memory/SharedMemorySystem.h"

#include <algorithm>
#include <span>

namespace tp {

/// In how large blocks TMs ask; 0 if nothing is shared.
static uint32_t requestGranule(const ChipConfig &Chip) {
  return Chip.L2 ? Chip.L2->SectorBytes : Chip.Dram ? Chip.Dram->BurstBytes : 0;
}

/// How many TMs are served together. Without L2s any number will do: enough
/// groups for the host's threads.
static uint32_t tmsPerGroup(const ChipConfig &Chip) {
  return Chip.L2 ? Chip.TmsPerL2 : (Chip.TmCount + 31) / 32;
}

SharedMemorySystem::SharedMemorySystem(const ChipConfig &Chip)
    : Ways(shortestWays(Chip)), HasL1(Chip.L1), HasCrossbar(Chip.Crossbar),
      HasL2(Chip.L2) {
  for (uint32_t Tm = 0; Tm != Chip.TmCount; ++Tm)
    Tms.push_back(std::make_unique<TmPath>(Chip, requestGranule(Chip)));
  if (!Chip.L2 && !Chip.Dram)
    return;
  uint32_t Size = tmsPerGroup(Chip);
  std::span<const std::unique_ptr<TmPath>> All(Tms);
  for (uint32_t First = 0; First < Chip.TmCount; First += Size)
    Groups.push_back(std::make_unique<TmGroup>(
        Chip, uint32_t(Groups.size()), First,
        All.subspan(First, std::min(Size, Chip.TmCount - First))));
  if (Chip.Dram) {
    Dram = std::make_unique<DramChannels>(*Chip.Dram, Chip.ClockGHz);
    Stages = {Step::Groups, Step::ToChannels, Step::Channels, Step::ToGroups,
              Step::Deliver};
  } else {
    Stages = {Step::GroupsAndDeliver};
  }
}

unsigned SharedMemorySystem::parts(unsigned Stage) const {
  switch (Stages[Stage]) {
  case Step::Groups:
  case Step::Deliver:
  case Step::GroupsAndDeliver:
    return unsigned(Groups.size());
  case Step::Channels:
    return Dram->size();
  case Step::ToChannels:
  case Step::ToGroups:
    return 1;
  }
}

void SharedMemorySystem::runPart(unsigned Stage, unsigned Part,
                                 uint64_t WindowEnd) {
  switch (Stages[Stage]) {
  case Step::Groups:
    Groups[Part]->advance(WindowEnd + Ways.ToShared);
    return;
  case Step::ToChannels:
    for (const std::unique_ptr<TmGroup> &Group : Groups) {
      for (const BurstRequest &Request : Group->Outgoing)
        Dram->add(Request);
      Group->Outgoing.clear();
    }
    return;
  case Step::Channels:
    Dram->advance(Part, dramLimit(WindowEnd));
    return;
  case Step::ToGroups:
    Dram->takeAnswers([this](uint32_t Group, const BurstAnswer &Answer) {
      Groups[Group]->takeAnswer(Answer);
    });
    return;
  case Step::Deliver:
    Groups[Part]->deliver(deliveryLimit(WindowEnd));
    return;
  case Step::GroupsAndDeliver:
    Groups[Part]->advance(WindowEnd + Ways.ToShared);
    Groups[Part]->deliver(deliveryLimit(WindowEnd));
    return;
  }
}

/// The first cycle of which it is enough that a window contains it for all up
/// to
/// \p Cycle to be decided, if that is done \p Ahead beyond the window's end.
static uint64_t windowFor(uint64_t Cycle, uint64_t Ahead) {
  if (Cycle == NoCycle)
    return NoCycle;
  return Cycle > Ahead ? Cycle - Ahead : 0;
}

uint64_t SharedMemorySystem::nextEvent() const {
  uint64_t Next = NoCycle;
  for (const std::unique_ptr<TmGroup> &Group : Groups)
    Next = std::min({Next, windowFor(Group->nextAdvance(), Ways.ToShared),
                     windowFor(Group->nextReturn(), deliveryLimit(0))});
  if (Dram)
    Next = std::min(Next, windowFor(Dram->nextEvent(), dramLimit(0)));
  return Next;
}

MemoryStatistics SharedMemorySystem::statistics(uint64_t WindowEnd) const {
  MemoryStatistics Sum;
  if (HasL1)
    Sum.L1.emplace();
  if (HasCrossbar)
    Sum.Crossbar.emplace();
  if (HasL2)
    Sum.L2.emplace();
  for (const std::unique_ptr<TmPath> &Tm : Tms)
    Tm->addTo(Sum);
  for (const std::unique_ptr<TmGroup> &Group : Groups)
    Group->addTo(Sum);
  if (Dram) {
    (HasL2 ? Sum.SentByL2sUnderWay : Sum.SentByTmsUnderWay) += Dram->underWay();
    Sum.DramChannels = Dram->statistics(dramLimit(WindowEnd));
  }
  return Sum;
}

void SharedMemorySystem::serialize(Archive &A) {
  for (const std::unique_ptr<TmPath> &Tm : Tms)
    Tm->serialize(A);
  for (const std::unique_ptr<TmGroup> &Group : Groups)
    Group->serialize(A);
  if (Dram)
    Dram->serialize(A);
}

std::unique_ptr<MemorySystem> makeMemorySystem(const ChipConfig &Chip) {
  if (!Chip.hasMemorySystem())
    return nullptr;
  return std::make_unique<SharedMemorySystem>(Chip);
}

} // namespace tp
