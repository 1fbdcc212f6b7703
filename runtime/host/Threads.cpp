//===- Threads.cpp - The device API's threads on the host -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "runtime/host/HostRuntime.h"
#include "tp/barrier.h"
#include "tp/memory.h"
#include "tp/profile.h"
#include "tp/stream.h"
#include "tp/thread.h"
#include <barrier>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace tp {

namespace {

LaunchBlock CurrentLaunch = {};
uint32_t CurrentThreadCount = 1;
std::unique_ptr<std::barrier<>> CurrentBarrier;
std::mutex StreamMutex;
thread_local uint32_t CurrentThreadId = 0;

} // namespace

ProfileObserver *CurrentProfileObserver = nullptr;

const LaunchBlock &launchBlock() { return CurrentLaunch; }

uint32_t threadId() { return CurrentThreadId; }
uint32_t tpId() { return CurrentThreadId; }
uint32_t tmId() { return 0; }
uint32_t threadCount() { return CurrentThreadCount; }
uint32_t tpCount() { return CurrentThreadCount; }
uint32_t tmCount() { return 1; }

uint64_t cycleCount() {
  using namespace std::chrono;
  return duration_cast<nanoseconds>(steady_clock::now().time_since_epoch())
      .count();
}

void barrier() {
  if (CurrentBarrier)
    CurrentBarrier->arrive_and_wait();
}

void sleep(uint32_t) { std::this_thread::yield(); }

bool streamPush(Stream *S, uint32_t Value) {
  std::lock_guard<std::mutex> Lock(StreamMutex);
  if (S->Tail - S->Head == S->Capacity)
    return false;
  S->data()[S->Tail & (S->Capacity - 1)] = Value;
  ++S->Tail;
  return true;
}

uint32_t streamPop(Stream *S) {
  std::lock_guard<std::mutex> Lock(StreamMutex);
  if (S->Tail == S->Head)
    return kStreamEmpty;
  uint32_t Value = S->data()[S->Head & (S->Capacity - 1)];
  ++S->Head;
  return Value;
}

static int runOnThreads(const std::function<int()> &Kernel, unsigned Threads,
                        const LaunchBlock &Launch) {
  CurrentLaunch = Launch;
  CurrentThreadCount = Threads;
  CurrentThreadId = 0;
  if (Threads == 1)
    return Kernel();

  CurrentBarrier = std::make_unique<std::barrier<>>(Threads);
  std::vector<int> Statuses(Threads, 0);
  std::vector<std::thread> Workers;
  for (unsigned Id = 0; Id != Threads; ++Id)
    Workers.emplace_back([&Statuses, &Kernel, Id] {
      CurrentThreadId = Id;
      Statuses[Id] = Kernel();
      CurrentBarrier->arrive_and_drop();
    });
  for (std::thread &Worker : Workers)
    Worker.join();
  CurrentBarrier.reset();
  CurrentThreadCount = 1;
  for (int Status : Statuses)
    if (Status)
      return Status;
  return 0;
}

int runOnHost(int (*KernelMain)(int, char **), unsigned Threads,
              const LaunchBlock &Launch) {
  const auto *Addresses = devicePointer<const DeviceAddress>(Launch.Arguments);
  std::vector<char *> Arguments;
  for (uint32_t I = 0; I != Launch.ArgumentCount; ++I)
    Arguments.push_back(devicePointer<char>(Addresses[I]));
  Arguments.push_back(nullptr);
  return runOnThreads(
      [&] {
        return KernelMain(static_cast<int>(Launch.ArgumentCount),
                          Arguments.data());
      },
      Threads, Launch);
}

int runOnHost(int (*KernelMain)(), unsigned Threads,
              const LaunchBlock &Launch) {
  return runOnThreads(KernelMain, Threads, Launch);
}

} // namespace tp
