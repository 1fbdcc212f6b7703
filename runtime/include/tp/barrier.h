//===- barrier.h - Waiting for other threads --------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_BARRIER_H
#define TP_BARRIER_H

#include <stdint.h>

namespace tp {

#ifdef __tp__

/// Waits until every thread of the chip that has not ended is here. Stores made
/// before it are visible to all after it.
inline void barrier() { __builtin_tp_barrier(); }

/// Waits until this thread's stores are visible to all threads.
inline void sync() { __builtin_tp_sync(); }

/// Does nothing for \p Cycles clock cycles, for instance while waiting for a
/// lock. On the host it gives way to other threads.
inline void sleep(uint32_t Cycles) { __builtin_tp_sleep(Cycles); }

#else

void barrier();
inline void sync() { __atomic_thread_fence(__ATOMIC_SEQ_CST); }
void sleep(uint32_t Cycles);

#endif

} // namespace tp

#endif // TP_BARRIER_H
