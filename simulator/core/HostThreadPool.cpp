//===- HostThreadPool.cpp - Host threads for one short job ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/core/HostThreadPool.h"

namespace tp {

static void pauseBriefly() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

HostThreadPool::HostThreadPool(unsigned Count) {
  // Some tens of microseconds, if each thread has a processor for itself.
  Patience = Count <= std::thread::hardware_concurrency() ? 2000 : 50;
  for (unsigned I = 1; I < Count; ++I)
    Helpers.emplace_back([this, I] { help(I); });
}

HostThreadPool::~HostThreadPool() {
  Ending = true;
  State.fetch_add(1 << NumberShift);
  State.notify_all();
  for (std::thread &Helper : Helpers)
    Helper.join();
}

void HostThreadPool::run(const Job &ToDo) {
  if (Helpers.empty())
    return ToDo(0);
  Current = &ToDo;
  // Nobody is active between jobs, and the last job is closed.
  State.fetch_add((1 << NumberShift) | Open, std::memory_order_release);
  State.notify_all();
  ToDo(0);
  State.fetch_sub(Open, std::memory_order_acq_rel);
  for (unsigned Spin = 0;
       (State.load(std::memory_order_acquire) & ActiveMask) != 0; ++Spin) {
    if (Spin < Patience)
      pauseBriefly();
    else
      std::this_thread::yield();
  }
}

bool HostThreadPool::enter(uint32_t Number) {
  uint32_t Seen = State.load(std::memory_order_relaxed);
  while (Seen >> NumberShift == Number && (Seen & Open) != 0)
    if (State.compare_exchange_weak(Seen, Seen + 1, std::memory_order_acquire,
                                    std::memory_order_relaxed))
      return true;
  return false;
}

uint32_t HostThreadPool::awaitJob(uint32_t Seen) {
  for (unsigned Spin = 0;; ++Spin) {
    uint32_t Now = State.load(std::memory_order_acquire);
    if (Now >> NumberShift != Seen)
      return Now >> NumberShift;
    if (Spin < Patience)
      pauseBriefly();
    else
      State.wait(Now, std::memory_order_acquire);
  }
}

void HostThreadPool::help(unsigned Number) {
  for (uint32_t Seen = 0;;) {
    Seen = awaitJob(Seen);
    if (Ending)
      return;
    if (!enter(Seen))
      continue;
    (*Current)(Number);
    State.fetch_sub(1, std::memory_order_release);
  }
}

} // namespace tp
