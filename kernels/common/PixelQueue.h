//===- PixelQueue.h - Which pixels a thread renders -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// All threads take pieces of the picture's PixelOrder from one counter. Early
// pieces are large, so that a thread's rays are coherent and it seldom waits
// for the counter; the last ones are single pixels, so that all threads end at
// about the same time. The curve is taken from its end, at the picture's
// bottom, because the longest rays must not come last: what is up is more often
// sky or ceiling.
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_COMMON_PIXELQUEUE_H
#define TP_KERNELS_COMMON_PIXELQUEUE_H

#include "kernels/common/PixelOrder.h"
#include "kernels/common/WorkSchedule.h"
#include "tp/atomic.h"
#include "tp/launch.h"
#include "tp/memory.h"
#include "tp/thread.h"

namespace tp {

/// The pixels of the launch's picture for one thread; all threads have one.
class PixelQueue {
public:
  explicit PixelQueue(const LaunchBlock &Launch)
      : Order(Launch.Width, Launch.Height),
        LastPosition(Launch.Width * Launch.Height - 1),
        Schedule(LastPosition + 1, threadCount()),
        Counter(devicePointer<uint32_t>(Launch.WorkCounter)),
        // The first piece of each thread needs no counter.
        Piece(Schedule.piece(threadId())) {}

  /// The next pixel of this thread; false if there is none left.
  bool take(PixelPlace &Pixel) {
    if (Piece.Begin == Piece.End)
      Piece = Schedule.piece(threadCount() + atomicAdd(Counter, 1));
    if (Piece.Begin == Piece.End)
      return false;
    Pixel = Order.at(LastPosition - Piece.Begin++);
    return true;
  }

private:
  const PixelOrder Order;
  /// Item 0 of the schedule.
  const uint32_t LastPosition;
  WorkSchedule Schedule;
  uint32_t *const Counter;
  /// What is left of the piece that has been taken last.
  WorkSchedule::Piece Piece;
};

} // namespace tp

#endif // TP_KERNELS_COMMON_PIXELQUEUE_H
