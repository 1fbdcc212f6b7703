//===- RaceDetector.h - Accesses that nothing orders ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Two accesses of different threads to a byte of global memory race if one of
// them writes, not both are atomic, and neither happens before the other. What
// is found does not depend on which of the two came first in this run.
//
// Of each word the last plain write, the last atomic write and the last reads
// of two threads are kept. That is enough for every race with a write, and for
// every race with a read where threads meet only at barriers. Where reads of
// three and more threads are ordered by nothing else, a later write that is
// ordered behind the last two of them is not compared with the others.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHECK_RACE_RACEDETECTOR_H
#define TP_SIMULATOR_CHECK_RACE_RACEDETECTOR_H

#include "simulator/check/race/AccessRecord.h"
#include "simulator/check/race/HappensBefore.h"
#include "simulator/core/Memory.h"

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace tp {

enum class AccessKind : uint8_t { Read, Write, AtomicRead, AtomicWrite };

/// One side of a race.
struct RacingAccess {
  uint32_t Thread = 0;
  AccessKind Kind = AccessKind::Read;
  AccessSite Site = 0;
};

struct Race {
  /// The first byte that both access.
  uint32_t Address = 0;
  RacingAccess Earlier;
  RacingAccess Later;
};

class RaceDetector {
public:
  using RaceFunction = std::function<void(const Race &)>;

  static constexpr size_t DefaultClockBytes = size_t(256) << 20;

  /// For \p ThreadCount threads on a global memory of \p MemoryBytes.
  /// \p Report is called for each race that is found.
  RaceDetector(uint32_t ThreadCount, uint64_t MemoryBytes, RaceFunction Report,
               size_t ClockBytes = DefaultClockBytes);

  /// False if the host has no room for it.
  bool isMapped() const { return Pages->data() != nullptr; }

  /// A thread reads \p Bytes (1, 2 or 4) at \p Address. \p Site gives the
  /// AccessSite, if it is asked for.
  template <class SiteFunction>
  [[gnu::always_inline]] void read(uint32_t Thread, uint32_t Address,
                                   unsigned Bytes, SiteFunction Site) {
    const AccessRecord Now = record(Thread, Address, Bytes, false);
    WordShadow &W = wordAt(Address);
    if (W.Reads[0].isSameAs(Now) || W.Write.isSameAs(Now)) [[likely]]
      return;
    noteRead(W, Address & ~3u, Thread, Now.withSite(Site()));
  }

  template <class SiteFunction>
  [[gnu::always_inline]] void write(uint32_t Thread, uint32_t Address,
                                    unsigned Bytes, SiteFunction Site) {
    const AccessRecord Now = record(Thread, Address, Bytes, false);
    WordShadow &W = wordAt(Address);
    // Whoever has accessed it since then has been compared with that write.
    if (W.Write.isSameAs(Now)) [[likely]]
      return;
    noteWrite(W, Address & ~3u, Thread, Now.withSite(Site()));
  }

  void atomicLoad(uint32_t Thread, uint32_t Address, unsigned Bytes,
                  bool Acquires, AccessSite Site);
  void atomicStore(uint32_t Thread, uint32_t Address, unsigned Bytes,
                   AccessSite Site);
  /// An atomic operation on the word at \p Address that reads and writes.
  void atomicChange(uint32_t Thread, uint32_t Address, AccessSite Site);
  /// What atomicChange() orders, without the access.
  void atomicOrder(uint32_t Thread, uint32_t Address);
  /// Atomic accesses that order nothing by themselves.
  void atomicRead(uint32_t Thread, uint32_t Address, unsigned Bytes,
                  AccessSite Site);
  void atomicWrite(uint32_t Thread, uint32_t Address, unsigned Bytes,
                   AccessSite Site);
  /// What an operation on the stream with this descriptor orders.
  void streamOperation(uint32_t Thread, uint32_t Stream);
  void fence(uint32_t Thread);
  /// All threads have met at the barrier.
  void barrier();

  /// How often the memory for clocks was full, or clocks at their end: races
  /// between what was before and after such a moment are not found.
  uint64_t interruptions() const { return Restarts + Order->overflows(); }

private:
  /// What is known of a word. In one whose bytes differ, Write tells where the
  /// bytes' own shadows are.
  struct WordShadow {
    AccessRecord Write;
    AccessRecord Atomic;
    /// Of different threads or bytes; the latest first.
    std::array<AccessRecord, 2> Reads;
  };
  /// Words whose bytes have shadows of their own, at most.
  static constexpr size_t MaxSplitWords = 1 << 20;

  AccessRecord record(uint32_t Thread, uint32_t Address, unsigned Bytes,
                      bool IsAtomic) const {
    return AccessRecord(Format.pack(Thread, Order->now(Thread)),
                        uint8_t(((1u << Bytes) - 1) << Address % 4), IsAtomic,
                        0);
  }
  WordShadow &wordAt(uint32_t Address) {
    return reinterpret_cast<WordShadow *>(Pages->data())[Address / 4];
  }

  void noteRead(WordShadow &W, uint32_t Word, uint32_t Thread,
                AccessRecord Now);
  void noteWrite(WordShadow &W, uint32_t Word, uint32_t Thread,
                 AccessRecord Now);
  void keepRead(WordShadow &W, uint32_t Thread, AccessRecord Now);
  /// Whether \p Now can take the place of \p Kept, whatever comes.
  bool supersedes(uint32_t Thread, AccessRecord Now, AccessRecord Kept) const;
  void compare(uint32_t Word, AccessRecord Kept, bool KeptWrites,
               uint32_t Thread, AccessRecord Now, bool NowWrites);
  bool isBefore(AccessRecord Kept, uint32_t Thread) const {
    return Order->isBefore(Format.thread(Kept.epoch()),
                           Format.clock(Kept.epoch()), Thread);
  }

  static bool isSplit(const WordShadow &W) {
    return !W.Write.isNone() && W.Write.bytes() == 0;
  }
  /// Gives the bytes of a word their own shadows; false if there are too many
  /// such words.
  bool split(WordShadow &W);
  /// The reverse, when all that is known of the word is \p Write.
  void join(WordShadow &W, AccessRecord Write);
  /// Calls \p Note with the shadow of each byte that \p Now accesses.
  template <class Function>
  void eachByte(WordShadow &W, AccessRecord Now, Function Note);

  /// Forgets everything if an epoch does not fit into a record any more.
  void keepFormat();
  void restart();

  const uint32_t ThreadCount;
  const uint64_t MemoryBytes;
  const size_t ClockBytes;
  const EpochFormat Format;
  RaceFunction Report;
  std::unique_ptr<HappensBefore> Order;
  std::unique_ptr<HostPages> Pages;
  std::vector<std::array<WordShadow, 4>> SplitWords;
  std::vector<AccessSite> FreeSplitWords;
  uint64_t Restarts = 0;
};

} // namespace tp

#endif // TP_SIMULATOR_CHECK_RACE_RACEDETECTOR_H
