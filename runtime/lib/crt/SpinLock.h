//===- SpinLock.h - Mutual exclusion of threads -----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_RUNTIME_LIB_CRT_SPINLOCK_H
#define TP_RUNTIME_LIB_CRT_SPINLOCK_H

#include "tp/atomic.h"
#include "tp/barrier.h"

namespace tp {

/// One word in shared memory, 0 when free. Waiting threads sleep for longer and
/// longer so that they leave the memory to the holder.
class SpinLock {
public:
  void lock() {
    for (uint32_t Pause = 16; atomicExchange(&Held, 1u, __ATOMIC_ACQUIRE) != 0;
         Pause = Pause < 1024 ? Pause * 2 : Pause)
      sleep(Pause);
  }

  void unlock() { atomicStore(&Held, 0u, __ATOMIC_RELEASE); }

private:
  uint32_t Held = 0;
};

/// Holds a lock until the end of its scope.
class LockGuard {
public:
  explicit LockGuard(SpinLock &Lock) : Lock(Lock) { Lock.lock(); }
  ~LockGuard() { Lock.unlock(); }
  LockGuard(const LockGuard &) = delete;
  LockGuard &operator=(const LockGuard &) = delete;

private:
  SpinLock &Lock;
};

} // namespace tp

#endif // TP_RUNTIME_LIB_CRT_SPINLOCK_H
