//===- NaiveCache.cpp - The rules of caches, literally --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/memory/NaiveMemory.h"

#include <algorithm>

namespace tp::test {

void NaiveCache::fillArrived(uint64_t Cycle) {
  for (auto It = Misses.begin(); It != Misses.end();) {
    if (It->second.Arrival != Cycle) {
      ++It;
      continue;
    }
    insert(Cycle, It->first, It->second.MakesDirty);
    It = Misses.erase(It);
  }
}

void NaiveCache::serve(uint64_t Cycle) {
  for (std::deque<NaiveAccess> &Bank : Banks)
    if (!Bank.empty() && attempt(Cycle, Bank.front()))
      Bank.pop_front();
}

NaiveCache::Line *NaiveCache::find(uint32_t Sector, bool Use) {
  std::list<Line> &Set = setOf(Sector);
  for (auto It = Set.begin(); It != Set.end(); ++It) {
    if (It->Number != lineOf(Sector))
      continue;
    if (Use)
      Set.splice(Set.begin(), Set, It);
    return &*It;
  }
  return nullptr;
}

void NaiveCache::insert(uint64_t Cycle, uint32_t Sector, bool IsDirty) {
  Line *Found = find(Sector, true);
  if (!Found) {
    std::list<Line> &Set = setOf(Sector);
    if (Set.size() == Config.Ways) {
      ++Counts.Evictions;
      for (uint32_t Dirty : Set.back().Dirty)
        writeBack(Cycle, Dirty);
      Set.pop_back();
    }
    Set.push_front({lineOf(Sector), {}, {}});
    Found = &Set.front();
  }
  Found->Valid.insert(Sector);
  if (IsDirty)
    Found->Dirty.insert(Sector);
}

void NaiveCache::writeBack(uint64_t Cycle, uint32_t Sector) {
  Counts.WritebackBytes += Config.SectorBytes;
  Send(Cycle + Config.Latency, {RequestKind::Store, Sector * Config.SectorBytes,
                                Config.SectorBytes, nullptr});
}

bool NaiveCache::attempt(uint64_t Cycle, NaiveAccess &Access) {
  if (!Access.FirstAttempt) {
    Access.FirstAttempt = Cycle;
    Counts.BankConflicts += Cycle > Access.Arrival;
    Counts.BankConflictCycles += Cycle - Access.Arrival;
  }
  uint32_t Sector = Access.Address / Config.SectorBytes;
  Line *Found = find(Sector, false);
  bool IsHit = Found && Found->Valid.count(Sector);
  bool IsBack = Config.Writes == WritePolicy::Back;
  bool IsAtomic = Access.Kind == RequestKind::Atomic;
  bool IsStore = Access.Kind == RequestKind::Store;
  uint64_t Done = Cycle + Config.Latency;
  if (IsAtomic && Level == ServedBy::L1) {
    ++Counts.Atomics;
    if (IsHit) {
      if (Found->Dirty.count(Sector))
        writeBack(Cycle, Sector);
      Found->Valid.erase(Sector);
      Found->Dirty.erase(Sector);
      if (Found->Valid.empty())
        setOf(Sector).remove_if(
            [&](const Line &L) { return L.Number == lineOf(Sector); });
    }
    Send(Done, Access);
    return true;
  }
  if (IsStore && !IsBack) {
    ++Counts.Stores;
    Counts.StoreHits += IsHit;
    if (IsHit)
      find(Sector, true);
    Send(Done, Access);
    return true;
  }
  bool MakesDirty = IsBack && (IsStore || IsAtomic);
  if (IsHit) {
    find(Sector, true);
    if (MakesDirty)
      Found->Dirty.insert(Sector);
    if (Access.Done)
      Access.Done(Done, Level);
    ++(IsStore ? Counts.StoreHits : Counts.Hits);
  } else if (IsStore && Access.Bytes == Config.SectorBytes &&
             !Misses.count(Sector)) {
    insert(Cycle, Sector, true);
    if (Access.Done)
      Access.Done(Done, Level);
  } else if (!miss(Cycle, Access, Sector, MakesDirty)) {
    ++Counts.MissRegisterWaitCycles;
    return false;
  }
  ++(IsStore                            ? Counts.Stores
     : IsAtomic                         ? Counts.Atomics
     : Access.Kind == RequestKind::Load ? Counts.Loads
                                        : Counts.Fetches);
  if (IsAtomic && !IsBack)
    Send(Done, {RequestKind::Store, Access.Address, Access.Bytes, nullptr});
  return true;
}

bool NaiveCache::miss(uint64_t Cycle, const NaiveAccess &Access,
                      uint32_t Sector, bool MakesDirty) {
  uint64_t Earliest = Cycle + Config.Latency;
  bool IsStore = Access.Kind == RequestKind::Store;
  auto Found = Misses.find(Sector);
  if (Found != Misses.end()) {
    Miss &M = Found->second;
    if (M.Joined == Config.MergesPerMiss)
      return false;
    ++M.Joined;
    M.MakesDirty |= MakesDirty;
    Counts.Merged += !IsStore;
    if (!M.Arrival)
      M.Waiting.push_back({Earliest, Access.Done});
    else if (Access.Done)
      Access.Done(std::max(*M.Arrival, Earliest), M.From);
    return true;
  }
  if (Misses.size() == Config.MissRegisters)
    return false;
  Counts.Misses += !IsStore;
  Counts.SectorMisses += !IsStore && find(Sector, false);
  Miss &M = Misses[Sector];
  M.Joined = 1;
  M.MakesDirty = MakesDirty;
  M.Waiting.push_back({Earliest, Access.Done});
  auto Arrived = [&M](uint64_t Arrival, ServedBy From) {
    M.Arrival = Arrival;
    M.From = From;
    for (auto &[First, Done] : M.Waiting)
      if (Done)
        Done(std::max(First, Arrival), From);
  };
  Send(Earliest, {RequestKind::Load, Sector * Config.SectorBytes,
                  Config.SectorBytes, Arrived});
  return true;
}

void NaivePort::put(uint64_t Cycle, uint32_t Bytes, Arrive Done) {
  if (Bytes == 0)
    Done(Cycle + Latency);
  else
    Queue.push_back({Bytes, std::move(Done)});
}

void NaivePort::tick(uint64_t Cycle) {
  if (Queue.empty())
    return;
  Message &First = Queue.front();
  First.Left -= std::min(First.Left, BytesPerCycle);
  if (First.Left != 0)
    return;
  Arrive Done = std::move(First.Done);
  Queue.pop_front();
  Done(Cycle + Latency);
}

} // namespace tp::test
