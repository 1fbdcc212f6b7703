//===- PixelQueue.h - Which pixels a thread renders -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Each thread owns one contiguous range of the picture's PixelOrder, so that
// its rays are coherent, and takes its pixels one by one from a counter of its
// own. A thread whose range is exhausted takes single pixels from those of
// others, chosen at random, until it finds none several times in a row. Every
// range is finished at least by its owner.
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_COMMON_PIXELQUEUE_H
#define TP_KERNELS_COMMON_PIXELQUEUE_H

#include "kernels/common/EarlyLoad.h"
#include "kernels/common/PixelOrder.h"
#include "kernels/common/Random.h"
#include "kernels/common/WorkShares.h"
#include "tp/atomic.h"
#include "tp/launch.h"
#include "tp/memory.h"
#include "tp/thread.h"

namespace tp {

/// The pixels of the launch's picture for one thread; all threads have one.
class PixelQueue {
public:
  explicit PixelQueue(const LaunchBlock &Launch)
      : Order(Launch.Width, Launch.Height), Threads(threadCount()),
        Shares(Launch.Width * Launch.Height, Threads),
        Counters(devicePointer<uint32_t>(Launch.WorkCounters)),
        Range(threadId()) {}

  /// The next pixel of this thread; false if there is none left.
  bool take(PixelPlace &Pixel) {
    do {
      const uint32_t Item = atomicAdd(Counters + Range, 1);
      if (Item < Shares.size(Range)) {
        Pixel = Order.at(Shares.begin(Range) + Item);
        return true;
      }
    } while (findRange());
    return false;
  }

private:
  /// Counters that are looked at in one wait for memory, and how often that may
  /// fail.
  static constexpr uint32_t Looks = 8;
  static constexpr uint32_t MaxFailures = 4;

  /// Goes to a range that had pixels left; false if it finds none.
  bool findRange() {
    for (uint32_t Failures = 0; Failures != MaxFailures; ++Failures) {
      uint32_t Ranges[Looks];
      uint32_t Taken[Looks];
      for (uint32_t Look = 0; Look != Looks; ++Look) {
        const RandomWords Random = randomWords(threadId(), Attempts++, 0, 0);
        Ranges[Look] = chooseIndex(Random.X, Threads).Index;
        Taken[Look] = atomicLoad(Counters + Ranges[Look]);
      }
      for (uint32_t &Items : Taken)
        loadHere(Items);
      for (uint32_t Look = 0; Look != Looks; ++Look) {
        Range = Ranges[Look];
        if (Taken[Look] < Shares.size(Range))
          return true;
      }
    }
    return false;
  }

  const PixelOrder Order;
  const uint32_t Threads;
  const WorkShares Shares;
  uint32_t *const Counters;
  /// The range that pixels are taken from.
  uint32_t Range;
  uint32_t Attempts = 0;
};

} // namespace tp

#endif // TP_KERNELS_COMMON_PIXELQUEUE_H
