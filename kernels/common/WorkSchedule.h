//===- WorkSchedule.h - Work divided into pieces ----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_COMMON_WORKSCHEDULE_H
#define TP_KERNELS_COMMON_WORKSCHEDULE_H

#include <stdint.h>

namespace tp {

/// Items [0, Items) divided into pieces, which threads take in the order of
/// their numbers. In each round there are as many pieces as threads, all of one
/// size, together a quarter of what is left; the last rounds are single items.
/// After C. Polychronopoulos and D. Kuck, "Guided Self-Scheduling", IEEE TC
/// C-36(12), 1987, with rounds so that a piece follows from its number.
class WorkSchedule {
public:
  /// Items [Begin, End); none if all have been given away.
  struct Piece {
    uint32_t Begin;
    uint32_t End;
  };

  /// \p Threads is not 0; \p Items is at most 2^31.
  constexpr WorkSchedule(uint32_t Items, uint32_t Threads)
      : Items(Items), Threads(Threads) {
    beginRound();
  }

  /// The piece of that number, which is not smaller than that of the call
  /// before.
  constexpr Piece piece(uint32_t Number) {
    while (Size != 1 && Number - FirstOfRound >= Threads) {
      RoundBegin += Size * Threads;
      FirstOfRound += Threads;
      beginRound();
    }
    const uint32_t Begin =
        atMostItems(RoundBegin + (Number - FirstOfRound) * Size);
    return {Begin, atMostItems(Begin + Size)};
  }

private:
  static constexpr uint32_t RoundsShare = 4;

  constexpr void beginRound() {
    const uint32_t Share = (Items - RoundBegin) / RoundsShare / Threads;
    Size = Share > 1 ? Share : 1;
  }
  constexpr uint32_t atMostItems(uint32_t Item) const {
    return Item < Items ? Item : Items;
  }

  uint32_t Items;
  uint32_t Threads;
  /// The first item and the first piece of the round, and its pieces' size.
  uint32_t RoundBegin = 0;
  uint32_t FirstOfRound = 0;
  uint32_t Size = 1;
};

} // namespace tp

#endif // TP_KERNELS_COMMON_WORKSCHEDULE_H
