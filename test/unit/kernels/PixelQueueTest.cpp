//===- PixelQueueTest.cpp - Every pixel once, near ones together ----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/common/PixelQueue.h"
#include "runtime/host/HostRuntime.h"
#include "tp/barrier.h"

#include <cstdlib>
#include <gtest/gtest.h>
#include <vector>

using namespace tp;

namespace {

struct Size {
  uint32_t Width, Height;
};

} // namespace

/// How often the curve visits each pixel of the picture.
static std::vector<unsigned> countVisits(Size Picture) {
  const PixelOrder Order(Picture.Width, Picture.Height);
  std::vector<unsigned> Visits(size_t(Picture.Width) * Picture.Height);
  for (uint32_t Position = 0; Position != Visits.size(); ++Position) {
    const PixelPlace Place = Order.at(Position);
    EXPECT_LT(Place.X, Picture.Width);
    EXPECT_LT(Place.Y, Picture.Height);
    ++Visits.at(Place.Y * Picture.Width + Place.X);
  }
  return Visits;
}

TEST(PixelOrder, VisitsEveryPixelOnce) {
  for (Size Picture : {Size{1, 1}, Size{16, 16}, Size{256, 256}, Size{17, 1},
                       Size{1, 50}, Size{33, 47}, Size{15, 16}, Size{100, 3}})
    for (unsigned Visits : countVisits(Picture))
      ASSERT_EQ(Visits, 1u) << Picture.Width << "x" << Picture.Height;
}

TEST(PixelOrder, SixteenPositionsAreASquare) {
  const PixelOrder Order(256, 256);
  for (uint32_t Position = 0; Position != 256 * 256; ++Position) {
    const PixelPlace First = Order.at(Position / 16 * 16);
    const PixelPlace Place = Order.at(Position);
    ASSERT_EQ(Place.X / 4, First.X / 4);
    ASSERT_EQ(Place.Y / 4, First.Y / 4);
  }
}

TEST(WorkSchedule, DividesAllItemsIntoSmallerAndSmallerPieces) {
  for (uint32_t Items : {0u, 1u, 7u, 4096u, 65536u, 1000003u})
    for (uint32_t Threads : {1u, 3u, 4096u}) {
      WorkSchedule Schedule(Items, Threads);
      uint32_t Next = 0, Size = Items, Number = 0;
      for (; Next != Items; ++Number) {
        const WorkSchedule::Piece Piece = Schedule.piece(Number);
        ASSERT_EQ(Piece.Begin, Next);
        ASSERT_GT(Piece.End, Piece.Begin);
        ASSERT_LE(Piece.End - Piece.Begin, Size);
        Next = Piece.End;
        Size = Piece.End - Piece.Begin;
      }
      EXPECT_LE(Size, 1u);
      const WorkSchedule::Piece Empty = Schedule.piece(Number + 2 * Threads);
      EXPECT_EQ(Empty.Begin, Items);
      EXPECT_EQ(Empty.End, Items);
    }
}

TEST(WorkSchedule, PiecesMayBeSkipped) {
  WorkSchedule Every(65536, 100), Some(65536, 100);
  for (uint32_t Number = 0; Number != 5000; ++Number) {
    const WorkSchedule::Piece Piece = Every.piece(Number);
    if (Number % 137 == 0) {
      EXPECT_EQ(Some.piece(Number).Begin, Piece.Begin);
    }
  }
}

/// What the threads below leave.
struct Visits {
  uint32_t OfPixel[40 * 30];
  uint32_t ByFirstThread;
  /// The rows of the first thread's first and last pixel.
  uint32_t FirstRow;
  uint32_t LastRow;
};

/// Takes all pixels; thread 0, if asked to, only after all others are done.
static void takePixels(bool FirstWaits) {
  const LaunchBlock &Launch = launchBlock();
  if (FirstWaits && threadId() == 0)
    barrier();
  auto *Seen = devicePointer<Visits>(Launch.Framebuffer);
  PixelQueue Queue(Launch);
  for (PixelPlace Place; Queue.take(Place);) {
    atomicAdd(&Seen->OfPixel[Place.Y * Launch.Width + Place.X], 1);
    if (threadId() == 0) {
      if (Seen->ByFirstThread++ == 0)
        Seen->FirstRow = Place.Y;
      Seen->LastRow = Place.Y;
    }
  }
  if (FirstWaits && threadId() != 0)
    barrier();
}

static int takeTogether() {
  takePixels(false);
  return 0;
}
static int takeWithoutTheFirst() {
  takePixels(true);
  return 0;
}

/// Runs \p Kernel, which must take every pixel once.
static Visits runQueue(int (*Kernel)(), uint32_t Threads) {
  host::resetMemory();
  LaunchBlock Launch{};
  Launch.Version = kLaunchBlockVersion;
  Launch.Width = 40;
  Launch.Height = 30;
  Launch.Framebuffer = host::allocate(sizeof(Visits));
  Launch.WorkCounter = host::allocate(sizeof(uint32_t));
  EXPECT_EQ(runOnHost(Kernel, Threads, Launch), 0);
  const auto *Seen = devicePointer<Visits>(Launch.Framebuffer);
  for (uint32_t Count : Seen->OfPixel)
    EXPECT_EQ(Count, 1u);
  return *Seen;
}

TEST(PixelQueue, ThreadsTakeEveryPixelOnce) {
  for (uint32_t Threads : {1u, 3u, 8u})
    runQueue(takeTogether, Threads);
}

TEST(PixelQueue, ThreadsTakeFromOneThatIsLate) {
  EXPECT_LT(runQueue(takeWithoutTheFirst, 4).ByFirstThread, 40u * 30 / 4);
}

TEST(PixelQueue, PicturesAreTakenFromTheBottomUp) {
  const Visits Seen = runQueue(takeTogether, 1);
  EXPECT_EQ(Seen.FirstRow, 29u);
  EXPECT_EQ(Seen.LastRow, 0u);
}
