//===- AccessRecord.h - Who accessed a word of memory -----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHECK_RACE_ACCESSRECORD_H
#define TP_SIMULATOR_CHECK_RACE_ACCESSRECORD_H

#include "simulator/check/race/VectorClock.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdint>

namespace tp {

/// Where in the program an access was made: a number of the caller's.
using AccessSite = uint32_t;

/// How a thread and its epoch become one number, for so many threads.
class EpochFormat {
public:
  static constexpr unsigned Bits = 36;

  explicit EpochFormat(uint32_t ThreadCount)
      : ThreadBits(std::max(4, int(std::bit_width(ThreadCount - 1)))) {}

  uint64_t pack(uint32_t Thread, Clock When) const {
    return uint64_t(When) << ThreadBits | Thread;
  }
  uint32_t thread(uint64_t Epoch) const {
    return uint32_t(Epoch & ((uint64_t(1) << ThreadBits) - 1));
  }
  Clock clock(uint64_t Epoch) const { return Clock(Epoch >> ThreadBits); }
  /// The last epoch that fits.
  Clock greatest() const {
    return Clock((uint64_t(1) << (Bits - ThreadBits)) - 1);
  }

private:
  unsigned ThreadBits;
};

/// One access to some of the four bytes of a word. All zero: none.
class AccessRecord {
public:
  static constexpr unsigned SiteBits = 23;
  static constexpr uint8_t WholeWord = 15;

  AccessRecord() = default;
  /// \p Bytes has a bit for each byte of the word.
  AccessRecord(uint64_t Epoch, uint8_t Bytes, bool IsAtomic, AccessSite Site)
      : Value(uint64_t(Site) << SiteShift | uint64_t(IsAtomic) << AtomicShift |
              uint64_t(Bytes) << BytesShift | Epoch) {
    assert(Site < (1u << SiteBits) && Epoch >> EpochFormat::Bits == 0);
  }

  bool isNone() const { return Value == 0; }
  uint64_t epoch() const { return Value & EpochMask; }
  uint8_t bytes() const { return Value >> BytesShift & WholeWord; }
  bool isAtomic() const { return Value >> AtomicShift & 1; }
  AccessSite site() const { return AccessSite(Value >> SiteShift); }

  /// Whether the two say the same but for the site.
  bool isSameAs(AccessRecord Other) const {
    return (Value ^ Other.Value) << SiteBits == 0;
  }
  AccessRecord withSite(AccessSite Site) const {
    return AccessRecord(epoch(), bytes(), isAtomic(), Site);
  }
  AccessRecord withBytes(uint8_t Bytes) const {
    return AccessRecord(epoch(), Bytes, isAtomic(), site());
  }
  /// Without \p Bytes; none if nothing is left.
  AccessRecord without(uint8_t Bytes) const {
    const uint8_t Rest = bytes() & ~Bytes;
    return Rest ? withBytes(Rest) : AccessRecord();
  }

private:
  static constexpr unsigned BytesShift = EpochFormat::Bits;
  static constexpr unsigned AtomicShift = BytesShift + 4;
  static constexpr unsigned SiteShift = AtomicShift + 1;
  static constexpr uint64_t EpochMask = (uint64_t(1) << BytesShift) - 1;
  static_assert(SiteShift + SiteBits == 64);

  uint64_t Value = 0;
};

} // namespace tp

#endif // TP_SIMULATOR_CHECK_RACE_ACCESSRECORD_H
