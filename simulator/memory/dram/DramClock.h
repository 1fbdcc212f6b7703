//===- DramClock.h - Ticks of DRAM and cycles of the chip -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_MEMORY_DRAM_DRAMCLOCK_H
#define TP_SIMULATOR_MEMORY_DRAM_DRAMCLOCK_H

#include <cmath>
#include <cstdint>
#include <numeric>

namespace tp {

/// A chip's clock in kHz, to the nearest.
inline uint64_t clockKHz(double GHz) { return std::llround(GHz * 1e6); }

/// Two clocks whose first edges are at the same time. Conversions are exact:
/// the ratio is one of integers.
class DramClock {
public:
  DramClock(uint64_t DramKHz, uint64_t ChipKHz)
      : Ticks(DramKHz / std::gcd(DramKHz, ChipKHz)),
        Cycles(ChipKHz / std::gcd(DramKHz, ChipKHz)) {}

  /// The first tick at or after the beginning of \p Cycle.
  uint64_t tickAtOrAfter(uint64_t Cycle) const {
    return ceilingOfRatio(Cycle, Ticks, Cycles);
  }

  /// The first cycle at or after \p Tick.
  uint64_t cycleAtOrAfter(uint64_t Tick) const {
    return ceilingOfRatio(Tick, Cycles, Ticks);
  }

  /// The last cycle at or before \p Tick.
  uint64_t cycleAtOrBefore(uint64_t Tick) const {
    uint64_t Product;
    if (__builtin_mul_overflow(Tick, Cycles, &Product))
      return uint64_t(static_cast<unsigned __int128>(Tick) * Cycles / Ticks);
    return Product / Ticks;
  }

private:
  static uint64_t ceilingOfRatio(uint64_t Count, uint64_t Factor,
                                 uint64_t Divisor) {
    uint64_t Sum;
    if (__builtin_mul_overflow(Count, Factor, &Sum) ||
        __builtin_add_overflow(Sum, Divisor - 1, &Sum))
      return uint64_t(
          (static_cast<unsigned __int128>(Count) * Factor + Divisor - 1) /
          Divisor);
    return Sum / Divisor;
  }

  /// Ticks ticks take as long as Cycles cycles.
  uint64_t Ticks;
  uint64_t Cycles;
};

} // namespace tp

#endif // TP_SIMULATOR_MEMORY_DRAM_DRAMCLOCK_H
