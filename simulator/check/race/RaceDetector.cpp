//===- RaceDetector.cpp - Accesses that nothing orders --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/check/race/RaceDetector.h"

#include <bit>
#include <utility>

namespace tp {

RaceDetector::RaceDetector(uint32_t ThreadCount, uint64_t MemoryBytes,
                           RaceFunction Report, size_t ClockBytes)
    : ThreadCount(ThreadCount), MemoryBytes(MemoryBytes),
      ClockBytes(ClockBytes), Format(ThreadCount), Report(std::move(Report)) {
  static_assert(sizeof(WordShadow) == 32);
  restart();
}

void RaceDetector::restart() {
  Order = std::make_unique<HappensBefore>(ThreadCount, ClockBytes);
  // Not twice at the same time.
  Pages.reset();
  Pages =
      std::make_unique<HostPages>((MemoryBytes + 3) / 4 * sizeof(WordShadow));
  SplitWords.clear();
  FreeSplitWords.clear();
}

void RaceDetector::keepFormat() {
  if (Order->latest() < Format.greatest()) [[likely]]
    return;
  Restarts += 1 + Order->overflows();
  restart();
}

static AccessKind kindOf(AccessRecord Record, bool Writes) {
  if (Record.isAtomic())
    return Writes ? AccessKind::AtomicWrite : AccessKind::AtomicRead;
  return Writes ? AccessKind::Write : AccessKind::Read;
}

void RaceDetector::compare(uint32_t Word, AccessRecord Kept, bool KeptWrites,
                           uint32_t Thread, AccessRecord Now, bool NowWrites) {
  const uint8_t Common = Kept.bytes() & Now.bytes();
  if (!Common || (Kept.isAtomic() && Now.isAtomic()) || isBefore(Kept, Thread))
    return;
  Report({Word + std::countr_zero(Common),
          {Format.thread(Kept.epoch()), kindOf(Kept, KeptWrites), Kept.site()},
          {Thread, kindOf(Now, NowWrites), Now.site()}});
}

bool RaceDetector::supersedes(uint32_t Thread, AccessRecord Now,
                              AccessRecord Kept) const {
  return !(Kept.bytes() & ~Now.bytes()) &&
         (Kept.isAtomic() || !Now.isAtomic()) && isBefore(Kept, Thread);
}

/// Whether \p Kept and \p Now can be one record of the bytes of both.
static bool mergeable(AccessRecord Kept, AccessRecord Now) {
  return Kept.withBytes(0).isSameAs(Now.withBytes(0)) &&
         Kept.site() == Now.site();
}

/// Whether \p Now takes bytes of a record that has to keep its others.
static bool divides(AccessRecord Kept, AccessRecord Now) {
  return (Kept.bytes() & ~Now.bytes()) != 0 && !mergeable(Kept, Now);
}

void RaceDetector::keepRead(WordShadow &W, uint32_t Thread, AccessRecord Now) {
  auto &[Latest, Other] = W.Reads;
  for (AccessRecord &Kept : W.Reads)
    if (mergeable(Kept, Now)) {
      Now = Now.withBytes(Now.bytes() | Kept.bytes());
      Kept = AccessRecord();
    }
  if (supersedes(Thread, Now, Other))
    Other = AccessRecord();
  if (!Latest.isNone() && !supersedes(Thread, Now, Latest))
    Other = Latest;
  Latest = Now;
}

void RaceDetector::noteRead(WordShadow &W, uint32_t Word, uint32_t Thread,
                            AccessRecord Now) {
  if (!isSplit(W))
    for (AccessRecord Kept : W.Reads)
      if (Kept.epoch() == Now.epoch() && divides(Kept, Now) && split(W))
        break;
  if (isSplit(W)) [[unlikely]]
    return eachByte(W, Now, [&](WordShadow &Byte, AccessRecord Part) {
      noteRead(Byte, Word, Thread, Part);
    });
  compare(Word, W.Write, true, Thread, Now, false);
  compare(Word, W.Atomic, true, Thread, Now, false);
  keepRead(W, Thread, Now);
}

void RaceDetector::noteWrite(WordShadow &W, uint32_t Word, uint32_t Thread,
                             AccessRecord Now) {
  AccessRecord &Last = Now.isAtomic() ? W.Atomic : W.Write;
  if (isSplit(W) || (divides(Last, Now) && split(W))) [[unlikely]] {
    eachByte(W, Now, [&](WordShadow &Byte, AccessRecord Part) {
      noteWrite(Byte, Word, Thread, Part);
    });
    if (Now.bytes() == AccessRecord::WholeWord && !Now.isAtomic())
      join(W, Now);
    return;
  }
  compare(Word, W.Write, true, Thread, Now, true);
  compare(Word, W.Atomic, true, Thread, Now, true);
  for (AccessRecord Read : W.Reads)
    compare(Word, Read, false, Thread, Now, true);
  Last = mergeable(Last, Now) ? Now.withBytes(Now.bytes() | Last.bytes()) : Now;
  if (Now.isAtomic())
    return;
  // Whatever races with these and comes later, races with this write.
  W.Atomic = W.Atomic.without(Now.bytes());
  for (AccessRecord &Read : W.Reads)
    Read = Read.without(Now.bytes());
  if (W.Reads[0].isNone())
    std::swap(W.Reads[0], W.Reads[1]);
}

bool RaceDetector::split(WordShadow &W) {
  AccessSite Index = AccessSite(SplitWords.size());
  if (!FreeSplitWords.empty()) {
    Index = FreeSplitWords.back();
    FreeSplitWords.pop_back();
  } else if (Index == MaxSplitWords) {
    return false;
  } else {
    SplitWords.emplace_back();
  }
  for (unsigned Byte = 0; Byte != 4; ++Byte) {
    const uint8_t Others = AccessRecord::WholeWord & ~(1u << Byte);
    WordShadow &Part = SplitWords[Index][Byte];
    Part = {W.Write.without(Others),
            W.Atomic.without(Others),
            {W.Reads[0].without(Others), W.Reads[1].without(Others)}};
    if (Part.Reads[0].isNone())
      std::swap(Part.Reads[0], Part.Reads[1]);
  }
  // No thread has an epoch of 0.
  W = {AccessRecord(Format.pack(1, 0), 0, false, Index), {}, {}};
  return true;
}

void RaceDetector::join(WordShadow &W, AccessRecord Write) {
  SplitWords[W.Write.site()] = {};
  FreeSplitWords.push_back(W.Write.site());
  W = {Write, {}, {}};
}

template <class Function>
void RaceDetector::eachByte(WordShadow &W, AccessRecord Now, Function Note) {
  const AccessSite Index = W.Write.site();
  for (unsigned Byte = 0; Byte != 4; ++Byte)
    if (const uint8_t Bit = Now.bytes() & (1u << Byte))
      Note(SplitWords[Index][Byte], Now.withBytes(Bit));
}

void RaceDetector::atomicRead(uint32_t Thread, uint32_t Address, unsigned Bytes,
                              AccessSite Site) {
  noteRead(wordAt(Address), Address & ~3u, Thread,
           record(Thread, Address, Bytes, true).withSite(Site));
}

void RaceDetector::atomicWrite(uint32_t Thread, uint32_t Address,
                               unsigned Bytes, AccessSite Site) {
  noteWrite(wordAt(Address), Address & ~3u, Thread,
            record(Thread, Address, Bytes, true).withSite(Site));
}

void RaceDetector::atomicOrder(uint32_t Thread, uint32_t Address) {
  Order->atomicChange(Thread, Address);
  keepFormat();
}

void RaceDetector::atomicLoad(uint32_t Thread, uint32_t Address, unsigned Bytes,
                              bool Acquires, AccessSite Site) {
  Order->atomicLoad(Thread, Address & ~3u, Acquires);
  atomicRead(Thread, Address, Bytes, Site);
}

void RaceDetector::atomicStore(uint32_t Thread, uint32_t Address,
                               unsigned Bytes, AccessSite Site) {
  atomicWrite(Thread, Address, Bytes, Site);
  Order->atomicStore(Thread, Address & ~3u);
  keepFormat();
}

void RaceDetector::atomicChange(uint32_t Thread, uint32_t Address,
                                AccessSite Site) {
  atomicWrite(Thread, Address, 4, Site);
  atomicOrder(Thread, Address);
}

void RaceDetector::streamOperation(uint32_t Thread, uint32_t Stream) {
  Order->streamOperation(Thread, Stream);
  keepFormat();
}

void RaceDetector::fence(uint32_t Thread) {
  Order->fence(Thread);
  keepFormat();
}

void RaceDetector::barrier() {
  Order->orderAll();
  keepFormat();
}

} // namespace tp
