//===- thread.h - Which thread this is, and what it costs -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// A chip has tmCount() thread multiprocessors (TM) of tpCount() thread
// processors (TP) each, and every TP runs one thread.
//
//===----------------------------------------------------------------------===//

#ifndef TP_THREAD_H
#define TP_THREAD_H

#include <stdint.h>

namespace tp {

#ifdef __tp__

/// Number of this thread in the chip, from 0.
inline uint32_t threadId() { return __builtin_tp_thread_id(); }
/// Number of this thread's TP in its TM, from 0.
inline uint32_t tpId() { return __builtin_tp_tp_id(); }
/// Number of this thread's TM in the chip, from 0.
inline uint32_t tmId() { return __builtin_tp_tm_id(); }
/// Threads of the chip.
inline uint32_t threadCount() { return __builtin_tp_thread_count(); }
/// TPs of each TM.
inline uint32_t tpCount() { return __builtin_tp_tp_count(); }
/// TMs of the chip.
inline uint32_t tmCount() { return __builtin_tp_tm_count(); }
/// Bytes of each TP's local store, which holds its stack and thread_local
/// objects. On the host: bytes of what freeLocalStore() gives.
inline uint32_t localStoreBytes() { return __builtin_tp_local_store_bytes(); }

/// Clock cycles since the start of the run. On the host: nanoseconds.
inline uint64_t cycleCount() {
  uint32_t High = __builtin_tp_cycle_high();
  for (;;) {
    uint32_t Low = __builtin_tp_cycle();
    uint32_t HighAgain = __builtin_tp_cycle_high();
    if (High == HighAgain)
      return static_cast<uint64_t>(High) << 32 | Low;
    High = HighAgain;
  }
}

/// Instructions that this thread has completed. 0 on the host.
inline uint64_t instructionCount() {
  uint32_t High = __builtin_tp_instret_high();
  for (;;) {
    uint32_t Low = __builtin_tp_instret();
    uint32_t HighAgain = __builtin_tp_instret_high();
    if (High == HighAgain)
      return static_cast<uint64_t>(High) << 32 | Low;
    High = HighAgain;
  }
}

#else

uint32_t threadId();
uint32_t tpId();
uint32_t tmId();
uint32_t threadCount();
uint32_t tpCount();
uint32_t tmCount();
uint32_t localStoreBytes();
uint64_t cycleCount();
inline uint64_t instructionCount() { return 0; }

#endif

} // namespace tp

#endif // TP_THREAD_H
