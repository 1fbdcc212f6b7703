//===- LocalStoreTest.cpp - Local stores on the host ----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "runtime/host/HostRuntime.h"
#include "tp/atomic.h"
#include "tp/barrier.h"
#include "tp/local_store.h"
#include "tp/memory.h"
#include "gtest/gtest.h"

#include <cstring>

/// Each thread fills its own store, waits for the others and looks again.
static int fillingKernel() {
  tp::LocalStoreSpace Space = tp::freeLocalStore();
  std::memset(Space.Begin, static_cast<int>(tp::threadId()), Space.Bytes);
  tp::barrier();
  tp::LocalStoreSpace Again = tp::freeLocalStore();
  if (Again.Begin != Space.Begin || Again.Bytes != Space.Bytes)
    return 1;
  for (uint32_t I = 0; I != Space.Bytes; ++I)
    if (Space.Begin[I] != static_cast<char>(tp::threadId()))
      return 2;
  return 0;
}

/// The threads' sum of the argument's letters and of argc.
static int addingKernel(int ArgumentCount, char **Arguments) {
  auto *Sum = tp::devicePointer<uint32_t>(tp::launchBlock().RayCounts);
  if (Arguments[ArgumentCount])
    return 1;
  tp::atomicAdd(Sum, static_cast<uint32_t>(ArgumentCount) +
                         static_cast<uint32_t>(std::strlen(Arguments[1])));
  return 0;
}

namespace {

constexpr uint32_t NumThreads = 4;

/// Sets the size and, at the end of its scope, the default one.
struct LocalStoreBytes {
  explicit LocalStoreBytes(uint32_t Bytes) {
    tp::host::setLocalStoreBytes(Bytes);
  }
  ~LocalStoreBytes() {
    tp::host::setLocalStoreBytes(tp::host::kDefaultLocalStoreBytes);
  }
};

TEST(LocalStore, IsOfTheReportsSizeUnlessSet) {
  EXPECT_EQ(tp::localStoreBytes(), 16u * 1024);
  EXPECT_EQ(tp::freeLocalStore().Bytes, 16u * 1024);
}

TEST(LocalStore, ChangesItsSizeBetweenRuns) {
  for (uint32_t Bytes : {0x100000u, 16u, 0u, 4096u}) {
    LocalStoreBytes Setting(Bytes);
    EXPECT_EQ(tp::localStoreBytes(), Bytes);
    tp::LocalStoreSpace Space = tp::freeLocalStore();
    EXPECT_EQ(Space.Bytes, Bytes);
    EXPECT_EQ(reinterpret_cast<uintptr_t>(Space.Begin) % 16, 0u);
    std::memset(Space.Begin, 0xA5, Space.Bytes);
  }
}

TEST(LocalStore, IsOfItsThreadAlone) {
  LocalStoreBytes Setting(1024);
  EXPECT_EQ(tp::runOnHost(fillingKernel, NumThreads, {}), 0);
}

TEST(HostRuntime, KernelsGetTheLaunchBlocksArguments) {
  tp::host::resetMemory();
  tp::LaunchBlock Launch = {};
  Launch.RayCounts = tp::host::allocate(sizeof(uint32_t));
  Launch.ArgumentCount = 2;
  Launch.Arguments = tp::host::allocate(3 * sizeof(tp::DeviceAddress));
  auto *Addresses = tp::devicePointer<tp::DeviceAddress>(Launch.Arguments);
  for (int I : {0, 1})
    Addresses[I] = tp::host::allocate(8, 1);
  std::memcpy(tp::devicePointer<char>(Addresses[1]), "slots=3", 8);
  EXPECT_EQ(tp::runOnHost(addingKernel, NumThreads, Launch), 0);
  EXPECT_EQ(*tp::devicePointer<uint32_t>(Launch.RayCounts), NumThreads * 9);
}

} // namespace
