//===- Cache.cpp - Timing of a cache --------------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/memory/Cache.h"

#include <cassert>
#include <tuple>

namespace tp {

static uint32_t log2Of(uint32_t Value) {
  return uint32_t(std::countr_zero(Value));
}

Cache::Cache(const CacheConfig &Config, ServedBy Level, bool DoesAtomics,
             AccessPool &Pool, CacheClient &Client)
    : Config(Config), Level(Level), DoesAtomics(DoesAtomics),
      SectorShift(log2Of(Config.SectorBytes)),
      SectorsShift(log2Of(Config.LineBytes / Config.SectorBytes)),
      SectorsMask(Config.LineBytes / Config.SectorBytes - 1),
      BankShift(log2Of(Config.BankBytes)), BankMask(Config.Banks - 1),
      Pool(Pool), Client(Client), Tags(Config), Registers(Config.MissRegisters),
      Banks(Config.Banks) {}

void Cache::arrive(uint32_t Register, uint64_t Cycle, ServedBy From) {
  assert(Cycle > Now && "a sector arrives too late to be exact");
  MissRegister &R = Registers[Register];
  std::tie(R.ArrivalCycle, R.Level) =
      std::max(std::tuple(R.ArrivalCycle, R.Level), std::tuple(Cycle, From));
  if (--R.Remaining != 0)
    return;
  while (!R.Waiting.isEmpty()) {
    uint32_t Index = R.Waiting.removeFirst(Pool);
    Client.answer(Index, std::max(R.ArrivalCycle, Pool[Index].Cycle), R.Level);
  }
  Fills.push_back({R.ArrivalCycle, R.Sector, Register});
  std::push_heap(Fills.begin(), Fills.end(), later);
}

uint64_t Cache::queueLength() const {
  uint64_t Length = 0;
  for (const AccessList &Bank : Banks)
    for (uint32_t I = Bank.First; I != NoIndex; I = Pool[I].Next)
      ++Length;
  return Length;
}

void Cache::completeFill() {
  Fill Done = Fills.front();
  std::pop_heap(Fills.begin(), Fills.end(), later);
  Fills.pop_back();
  CacheLine *Line = lineFor(Done.Sector);
  Line->Valid |= maskOf(Done.Sector);
  if (Registers[Done.Register].Dirty)
    Line->Dirty |= maskOf(Done.Sector);
  Registers.release(Done.Register);
  Blocked = 0;
}

CacheLine *Cache::lineFor(uint32_t Sector) {
  uint32_t Number = lineOf(Sector);
  if (CacheLine *Line = Tags.find(Number))
    return Tags.promote(Line);
  CacheLine Victim = Tags.replace(Number);
  if (Victim.Valid != 0) {
    ++Counts.Evictions;
    writeBack(Victim, Victim.Dirty);
  }
  return Tags.lastUsed(Number);
}

void Cache::writeBack(const CacheLine &Line, uint16_t Sectors) {
  for (uint32_t Left = Sectors; Left != 0; Left &= Left - 1) {
    uint32_t Sector =
        Line.Number << SectorsShift | uint32_t(std::countr_zero(Left));
    Counts.WritebackBytes += Config.SectorBytes;
    Counts.BytesWritten += Config.SectorBytes;
    Client.write(Sector << SectorShift, Config.SectorBytes,
                 Now + Config.Latency);
  }
}

void Cache::serveBank(unsigned Bank) {
  AccessList &List = Banks[Bank];
  uint32_t Index = List.First;
  uint32_t Next = Pool[Index].Next;
  if (!serve(Index)) {
    Blocked |= uint64_t(1) << Bank;
    return;
  }
  List.First = Next;
  if (List.isEmpty())
    Waiting &= ~(uint64_t(1) << Bank);
}

bool Cache::serve(uint32_t Index) {
  Access &A = Pool[Index];
  if (!A.Attempted) {
    Counts.BankConflicts += Now != A.Cycle;
    Counts.BankConflictCycles += Now - A.Cycle;
    A.Attempted = true;
    A.Cycle = Now;
  }
  uint64_t Waited = Now - A.Cycle;
  bool Served = A.Kind == RequestKind::Store    ? serveStore(Index)
                : A.Kind == RequestKind::Atomic ? serveAtomic(Index)
                                                : serveRead(Index);
  if (Served)
    Counts.MissRegisterWaitCycles += Waited;
  return Served;
}

bool Cache::serveRead(uint32_t Index) {
  const Access &A = Pool[Index];
  uint32_t Sector = A.Address >> SectorShift;
  uint64_t &Count = A.Kind == RequestKind::Load ? Counts.Loads : Counts.Fetches;
  CacheLine *Line = Tags.find(lineOf(Sector));
  if (!Line || !(Line->Valid & maskOf(Sector))) {
    if (!miss(Index, false, Line))
      return false;
    ++Count;
    return true;
  }
  Tags.promote(Line);
  ++Count;
  ++Counts.Hits;
  Client.answer(Index, Now + Config.Latency, Level);
  return true;
}

bool Cache::serveStore(uint32_t Index) {
  const Access &A = Pool[Index];
  uint32_t Sector = A.Address >> SectorShift;
  CacheLine *Line = Tags.find(lineOf(Sector));
  bool IsHit = Line && Line->Valid & maskOf(Sector);
  if (IsHit)
    Line = Tags.promote(Line);
  if (!isBack()) {
    Counts.BytesWritten += A.Bytes;
    Client.forward(Index, Now + Config.Latency);
  } else if (IsHit) {
    Line->Dirty |= maskOf(Sector);
    Client.answer(Index, Now + Config.Latency, Level);
  } else if (A.Bytes == Config.SectorBytes &&
             Registers.find(Sector) == NoIndex) {
    place(Sector);
    Client.answer(Index, Now + Config.Latency, Level);
  } else if (!miss(Index, true, Line)) {
    return false;
  }
  ++Counts.Stores;
  Counts.StoreHits += IsHit;
  return true;
}

void Cache::place(uint32_t Sector) {
  CacheLine *Line = lineFor(Sector);
  Line->Valid |= maskOf(Sector);
  Line->Dirty |= maskOf(Sector);
  Blocked = 0;
}

bool Cache::serveAtomic(uint32_t Index) {
  const Access &A = Pool[Index];
  uint32_t Sector = A.Address >> SectorShift;
  uint16_t Mask = maskOf(Sector);
  CacheLine *Line = Tags.find(lineOf(Sector));
  bool IsHit = Line && Line->Valid & Mask;
  if (!DoesAtomics) {
    ++Counts.Atomics;
    if (IsHit) {
      writeBack(*Line, Line->Dirty & Mask);
      Tags.invalidate(Line, Mask);
    }
    Client.forward(Index, Now + Config.Latency);
    return true;
  }
  uint32_t Address = A.Address;
  uint32_t Bytes = A.Bytes;
  if (IsHit) {
    Line = Tags.promote(Line);
    if (isBack())
      Line->Dirty |= Mask;
    ++Counts.Hits;
    Client.answer(Index, Now + Config.Latency, Level);
  } else if (!miss(Index, isBack(), Line)) {
    return false;
  }
  ++Counts.Atomics;
  if (!isBack()) {
    Counts.BytesWritten += Bytes;
    Client.write(Address, Bytes, Now + Config.Latency);
  }
  return true;
}

bool Cache::miss(uint32_t Index, bool MakesDirty, bool LineIsThere) {
  Access &A = Pool[Index];
  uint32_t Sector = A.Address >> SectorShift;
  bool IsStore = A.Kind == RequestKind::Store;
  uint64_t Earliest = Now + Config.Latency;
  uint32_t Register = Registers.find(Sector);
  if (Register != NoIndex) {
    MissRegister &R = Registers[Register];
    if (R.Joined == Config.MergesPerMiss)
      return false;
    ++R.Joined;
    R.Dirty |= MakesDirty;
    Counts.Merged += !IsStore;
    A.Cycle = Earliest;
    if (R.Remaining == 0) {
      Client.answer(Index, std::max(R.ArrivalCycle, Earliest), R.Level);
    } else {
      R.Waiting.append(Pool, Index);
      Client.postpone(Index);
    }
    return true;
  }
  if (Registers.isFull())
    return false;
  Register = Registers.take(Sector);
  MissRegister &R = Registers[Register];
  R.Joined = 1;
  R.Dirty = MakesDirty;
  A.Cycle = Earliest;
  R.Waiting.append(Pool, Index);
  Counts.Misses += !IsStore;
  Counts.SectorMisses += !IsStore && LineIsThere;
  Counts.BytesRead += Config.SectorBytes;
  Client.fetch(Register, Sector << SectorShift, Earliest);
  if (R.Remaining != 0)
    Client.postpone(Index);
  return true;
}

void Cache::serialize(Archive &A) {
  A(Now);
  A(Tags);
  A(Registers);
  A(Fills);
  A(Banks);
  A(Waiting);
  A(Blocked);
  A(Counts);
}

} // namespace tp
