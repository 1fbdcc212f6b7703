//===- HostRuntimeTest.cpp - The device API on the host -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "runtime/host/HostRuntime.h"
#include "tp/atomic.h"
#include "tp/barrier.h"
#include "tp/memory.h"
#include "tp/stream.h"
#include "tp/thread.h"
#include "gtest/gtest.h"

namespace {

constexpr uint32_t NumThreads = 8;

/// Shared by the kernels below through LaunchBlock::WorkCounter.
struct Shared {
  uint32_t Sum;
  int32_t Least;
  uint32_t Greatest;
  uint32_t SeenAfterBarrier[NumThreads];
};

int countingKernel() {
  auto *S = tp::devicePointer<Shared>(tp::launchBlock().WorkCounter);
  tp::atomicAdd(&S->Sum, tp::threadId() + 1);
  tp::atomicMin(&S->Least, -static_cast<int32_t>(tp::threadId()));
  tp::atomicMax(&S->Greatest, tp::threadId());
  tp::barrier();
  S->SeenAfterBarrier[tp::threadId()] = tp::atomicLoad(&S->Sum);
  return tp::threadId() >= 5 ? static_cast<int>(tp::threadId()) : 0;
}

TEST(HostRuntime, ThreadsMeetAtBarriersAndReturnTheFirstStatus) {
  tp::host::resetMemory();
  tp::LaunchBlock Launch = {};
  Launch.WorkCounter = tp::host::allocate(sizeof(Shared));
  EXPECT_EQ(tp::runOnHost(countingKernel, NumThreads, Launch), 5);
  auto *S = tp::devicePointer<Shared>(Launch.WorkCounter);
  EXPECT_EQ(S->Sum, 36u);
  EXPECT_EQ(S->Least, -7);
  EXPECT_EQ(S->Greatest, 7u);
  for (uint32_t Seen : S->SeenAfterBarrier)
    EXPECT_EQ(Seen, 36u);
}

/// A thread that has ended does not hold up the barrier.
int earlyEndKernel() {
  if (tp::threadId() != 0)
    return 0;
  tp::barrier();
  return tp::threadCount() == NumThreads && tp::tpCount() == NumThreads &&
                 tp::tmCount() == 1
             ? 0
             : 1;
}

TEST(HostRuntime, EndedThreadsLeaveTheBarrier) {
  EXPECT_EQ(tp::runOnHost(earlyEndKernel, NumThreads, {}), 0);
}

TEST(HostRuntime, OneThreadRunsOnTheCallersThread) {
  static thread_local int Mark;
  Mark = 7;
  EXPECT_EQ(tp::runOnHost([] { return Mark; }, 1, {}), 7);
}

TEST(HostRuntime, AddressesAreAlignedAndReadBackAsZero) {
  tp::host::resetMemory();
  tp::DeviceAddress First = tp::host::allocate(3, 1);
  EXPECT_EQ(First, 0x10000u);
  tp::DeviceAddress Second = tp::host::allocate(100, 4096);
  EXPECT_EQ(Second, 0x11000u);
  auto *Bytes = tp::devicePointer<uint8_t>(Second);
  EXPECT_EQ(Bytes[99], 0);
  Bytes[99] = 1;
  EXPECT_EQ(tp::deviceAddress(Bytes + 99), Second + 99);
  EXPECT_EQ(tp::devicePointer<int>(0), nullptr);
  EXPECT_EQ(tp::deviceAddress(nullptr), 0u);
  tp::host::resetMemory();
  EXPECT_EQ(Bytes[99], 0);
}

TEST(HostRuntime, AtomicsReturnTheOldValue) {
  uint32_t Word = 6;
  EXPECT_EQ(tp::atomicAnd(&Word, 3u), 6u);
  EXPECT_EQ(tp::atomicOr(&Word, 8u), 2u);
  EXPECT_EQ(tp::atomicXor(&Word, 15u), 10u);
  EXPECT_EQ(tp::atomicExchange(&Word, 100u), 5u);
  EXPECT_EQ(tp::atomicCompareExchange(&Word, 99u, 1u), 100u);
  EXPECT_EQ(tp::atomicCompareExchange(&Word, 100u, 1u), 100u);
  EXPECT_EQ(Word, 1u);
}

TEST(HostRuntime, StreamsAreFirstInFirstOut) {
  alignas(16) unsigned char Memory[tp::streamBytes(4)];
  tp::Stream *S = tp::streamCreate(Memory, 4);
  S->Head = S->Tail = 0xFFFFFFFEu;
  EXPECT_EQ(tp::streamPop(S), tp::kStreamEmpty);
  for (uint32_t Value = 1; Value <= 4; ++Value)
    EXPECT_TRUE(tp::streamPush(S, Value));
  EXPECT_FALSE(tp::streamPush(S, 5));
  for (uint32_t Value = 1; Value <= 4; ++Value)
    EXPECT_EQ(tp::streamPop(S), Value);
  EXPECT_EQ(tp::streamPop(S), tp::kStreamEmpty);
}

} // namespace
