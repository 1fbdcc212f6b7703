//===- HostPrefetch.h - Simulated state in the host's cache -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The state of 65,536 TPs is larger than the host's caches, but the order in
// which it is used is known.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_HOSTPREFETCH_H
#define TP_SIMULATOR_CORE_HOSTPREFETCH_H

#include "simulator/core/LocalStore.h"
#include "simulator/core/Thread.h"
#include "simulator/core/ThreadRequests.h"

#include <cstddef>

namespace tp {

inline constexpr size_t HostCacheLine = 64;

inline void prefetch(const void *From, size_t Bytes) {
  for (size_t At = 0; At < Bytes; At += HostCacheLine)
    __builtin_prefetch(static_cast<const char *>(From) + At);
}

inline void prefetchThread(const Thread &T) { prefetch(&T, sizeof(T)); }

/// The local store from the stack pointer on, and the requests. The thread
/// itself should be in the cache.
inline void prefetchStack(const Thread &T, const ChipConfig &Chip) {
  constexpr uint32_t Bytes = 2 * HostCacheLine;
  uint32_t Top = T.Registers[StackPointerRegister];
  if (LocalStoreRange(Chip.LocalStoreBytes).contains(Top, Bytes))
    prefetch(reinterpret_cast<const void *>(T.LocalStoreBias + Top), Bytes);
  if (T.Requests)
    prefetch(T.Requests, sizeof(ThreadRequests));
}

} // namespace tp

#endif // TP_SIMULATOR_CORE_HOSTPREFETCH_H
