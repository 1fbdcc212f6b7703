//===- Guards.cpp - Local static objects, made once ---------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The Itanium C++ ABI. Other threads wait until the object is made.
//
//===----------------------------------------------------------------------===//

#include "tp/atomic.h"
#include "tp/barrier.h"
#include <stdint.h>

namespace {

/// The first byte of a guard is set once the object is made; our second word
/// is set while a thread makes it.
struct Guard {
  uint8_t Done;
  uint8_t Unused[3];
  uint32_t Busy;
};

} // namespace

extern "C" {

int __cxa_guard_acquire(uint64_t *Word) {
  Guard *G = reinterpret_cast<Guard *>(Word);
  for (;;) {
    if (__atomic_load_n(&G->Done, __ATOMIC_ACQUIRE))
      return 0;
    if (tp::atomicExchange(&G->Busy, 1u, __ATOMIC_ACQUIRE) == 0) {
      if (!__atomic_load_n(&G->Done, __ATOMIC_ACQUIRE))
        return 1;
      tp::atomicStore(&G->Busy, 0u, __ATOMIC_RELEASE);
      return 0;
    }
    tp::sleep(64);
  }
}

void __cxa_guard_release(uint64_t *Word) {
  Guard *G = reinterpret_cast<Guard *>(Word);
  __atomic_store_n(&G->Done, uint8_t(1), __ATOMIC_RELEASE);
  tp::atomicStore(&G->Busy, 0u, __ATOMIC_RELEASE);
}

void __cxa_guard_abort(uint64_t *Word) {
  tp::atomicStore(&reinterpret_cast<Guard *>(Word)->Busy, 0u, __ATOMIC_RELEASE);
}

} // extern "C"
