//===- HostThreadPool.cpp - Host threads for one short job ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/core/HostThreadPool.h"

namespace tp {

/// Waits while the value is \p Value: about 20 microseconds awake, then asleep.
static void waitWhile(std::atomic<uint32_t> &Atomic, uint32_t Value) {
  for (unsigned Spin = 0; Spin != 1000; ++Spin) {
    if (Atomic.load(std::memory_order_acquire) != Value)
      return;
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
  }
  Atomic.wait(Value, std::memory_order_acquire);
}

HostThreadPool::HostThreadPool(unsigned Count) {
  for (unsigned I = 1; I < Count; ++I)
    Helpers.emplace_back([this, I] { help(I); });
}

HostThreadPool::~HostThreadPool() {
  Ending = true;
  ++Started;
  Started.notify_all();
  for (std::thread &Helper : Helpers)
    Helper.join();
}

void HostThreadPool::run(const Job &ToDo) {
  if (Helpers.empty())
    return ToDo(0);
  Current = &ToDo;
  Busy.store(uint32_t(Helpers.size()), std::memory_order_relaxed);
  Started.fetch_add(1, std::memory_order_release);
  Started.notify_all();
  ToDo(0);
  while (uint32_t Left = Busy.load(std::memory_order_acquire))
    waitWhile(Busy, Left);
}

void HostThreadPool::help(unsigned Number) {
  for (uint32_t Seen = 0;; ++Seen) {
    waitWhile(Started, Seen);
    if (Ending)
      return;
    (*Current)(Number);
    if (Busy.fetch_sub(1, std::memory_order_acq_rel) == 1)
      Busy.notify_one();
  }
}

} // namespace tp
