//===- ResourceLayout.h - What a TM can start in one cycle ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// All limits of one cycle stand side by side in one word. Each has a counter
// field with a guard bit above it, set up so that counting one use more than
// the capacity carries into the guard bit: one addition and one AND test all
// limits of an instruction at once.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_RESOURCELAYOUT_H
#define TP_SIMULATOR_CORE_RESOURCELAYOUT_H

#include "simulator/chip/ChipConfig.h"

#include <array>
#include <cstdint>
#include <vector>

namespace tp {

/// Wide enough for the limits of any chip.
using WideWord = unsigned _BitInt(512);

/// Places of the limits in the word. No limit lies across a boundary between
/// parts of PartBits bits, and each part says for itself whether the cycle is
/// closed: whoever knows which parts an instruction uses can leave the others
/// alone.
class ResourceLayout {
public:
  explicit ResourceLayout(const ChipConfig &Chip);

  /// Bits of the word in use; more than fit a WideWord if the chip has too many
  /// limits.
  unsigned bits() const { return Bits; }
  /// What an instruction of a unit, fetched from an icache bank, adds.
  WideWord use(Unit Type, uint32_t Bank) const;
  /// The word of a cycle in which nothing has started yet.
  WideWord unused(uint64_t Cycle) const;
  /// The word of a cycle in which nothing may start.
  WideWord closed() const;
  /// All guard bits, and those of the icache banks.
  WideWord guards() const { return Guards; }
  WideWord icacheGuards() const { return IcacheGuards; }
  /// Whether unused() is the same for all cycles.
  bool isUniform() const { return Uniform; }

private:
  /// One limit: Capacity uses in the cycles divisible by Interval.
  struct Limit {
    bool Exists = false;
    unsigned Shift = 0;
    unsigned CounterBits = 0;
    uint32_t Capacity = 0;
    uint32_t Interval = 1;

    WideWord unused(uint64_t Cycle) const;
    WideWord guard() const { return WideWord(1) << (Shift + CounterBits); }
    WideWord one() const { return Exists ? WideWord(1) << Shift : WideWord(0); }
  };

  /// The lowest bit of a part says that the cycle is closed.
  static constexpr unsigned PartBits = 64;

  Limit place(uint32_t Capacity, uint32_t Interval, uint32_t Users);

  unsigned Bits = 1;
  std::array<Limit, NumUnits> Units;
  std::vector<Limit> Banks;
  WideWord Guards = 0;
  WideWord IcacheGuards = 0;
  bool Uniform = true;
};

} // namespace tp

#endif // TP_SIMULATOR_CORE_RESOURCELAYOUT_H
