//===- DramQueue.cpp - Requests that wait for their bursts ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/memory/dram/DramQueue.h"

#include <algorithm>

using namespace tp;

bool DramQueue::contains(uint32_t Bank, uint32_t Row, uint32_t Column) const {
  return std::any_of(Entries[Bank].begin(), Entries[Bank].end(),
                     [&](const DramQueueEntry &Entry) {
                       return Entry.Row == Row && Entry.Column == Column;
                     });
}

void DramQueue::add(const DramQueueEntry &Entry, uint32_t Bank,
                    uint32_t OpenRow) {
  Entries[Bank].push_back(Entry);
  ++Size;
  choose(Bank, OpenRow);
}

DramQueueEntry DramQueue::take(uint32_t Bank, uint32_t OpenRow) {
  auto Taken = Entries[Bank].begin() + Candidates[Bank].Index;
  DramQueueEntry Entry = *Taken;
  if (Entries[Bank].front().Row != Entry.Row)
    ++HitsPassed[Bank];
  Entries[Bank].erase(Taken);
  --Size;
  choose(Bank, OpenRow);
  return Entry;
}

void DramQueue::noteActivate(uint32_t Bank, uint32_t OpenRow) {
  ++Entries[Bank].front().Activates;
  rowChanged(Bank, OpenRow);
}

void DramQueue::notePrecharge(uint32_t Bank) {
  ++Entries[Bank].front().Precharges;
  rowChanged(Bank, DramDevice::NoRow);
}

void DramQueue::rowChanged(uint32_t Bank, uint32_t OpenRow) {
  HitsPassed[Bank] = 0;
  choose(Bank, OpenRow);
}

void DramQueue::choose(uint32_t Bank, uint32_t OpenRow) {
  const std::vector<DramQueueEntry> &Waiting = Entries[Bank];
  Candidate &C = Candidates[Bank];
  uint64_t Bit = uint64_t(1) << Bank;
  if (Waiting.empty()) {
    WantingBanks &= ~Bit;
    return;
  }
  WantingBanks |= Bit;
  C = {Waiting.front().Age, DramCommandKind::Activate, 0};
  if (OpenRow == DramDevice::NoRow)
    return;
  C.Wants = DramCommandKind::Precharge;
  auto Hit = std::find_if(
      Waiting.begin(), Waiting.end(),
      [&](const DramQueueEntry &Entry) { return Entry.Row == OpenRow; });
  if (Hit == Waiting.end())
    return;
  if (Hit == Waiting.begin() || HitsPassed[Bank] < RowHitLimit)
    C = {Hit->Age, Column, uint32_t(Hit - Waiting.begin())};
}

void DramQueue::serialize(Archive &A) {
  A(Size);
  A(WantingBanks);
  for (std::vector<DramQueueEntry> &Waiting : Entries)
    A(Waiting);
  A(HitsPassed);
  A(Candidates);
}
