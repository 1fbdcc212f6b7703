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

TEST(WorkShares, DivideAllItems) {
  for (uint32_t Items : {0u, 1u, 7u, 4096u, 65536u, 268435455u}) {
    const WorkShares Shares(Items, 4096);
    uint32_t Next = 0;
    for (uint32_t Thread = 0; Thread != 4096; ++Thread) {
      ASSERT_EQ(Shares.begin(Thread), Next);
      ASSERT_LE(Shares.size(Thread) - Items / 4096, 1u);
      Next += Shares.size(Thread);
    }
    EXPECT_EQ(Next, Items);
  }
}

/// What the threads below leave.
struct Visits {
  uint32_t OfPixel[40 * 30];
  uint32_t ByFirstThread;
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
    if (threadId() == 0)
      ++Seen->ByFirstThread;
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

/// Runs \p Kernel, which must take every pixel once; how many of them its first
/// thread took.
static uint32_t runQueue(int (*Kernel)(), uint32_t Threads) {
  host::resetMemory();
  LaunchBlock Launch{};
  Launch.Version = kLaunchBlockVersion;
  Launch.Width = 40;
  Launch.Height = 30;
  Launch.Framebuffer = host::allocate(sizeof(Visits));
  Launch.WorkCounters = host::allocate(Threads * sizeof(uint32_t));
  EXPECT_EQ(runOnHost(Kernel, Threads, Launch), 0);
  const auto *Seen = devicePointer<Visits>(Launch.Framebuffer);
  for (uint32_t Count : Seen->OfPixel)
    EXPECT_EQ(Count, 1u);
  return Seen->ByFirstThread;
}

TEST(PixelQueue, ThreadsTakeEveryPixelOnce) {
  for (uint32_t Threads : {1u, 3u, 8u})
    runQueue(takeTogether, Threads);
}

TEST(PixelQueue, ThreadsTakeFromOneThatIsLate) {
  EXPECT_LT(runQueue(takeWithoutTheFirst, 4), 40u * 30 / 4);
}
