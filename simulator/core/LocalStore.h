//===- LocalStore.h - Where a TP's local store is ---------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_LOCALSTORE_H
#define TP_SIMULATOR_CORE_LOCALSTORE_H

#include "runtime/include/tp/memory_map.h"

#include <cstdint>

namespace tp {

/// Cycles from the issue of a load or atomic on the local store to its result.
inline constexpr uint32_t LocalStoreLatency = 1;

/// The addresses of each TP's local store: the last Bytes of the address
/// space without the reserved ones.
struct LocalStoreRange {
  uint32_t Begin;
  uint32_t Size;

  explicit LocalStoreRange(uint32_t Bytes)
      : Begin(0 - Bytes),
        Size(Bytes > kLocalStoreReservedBytes ? Bytes - kLocalStoreReservedBytes
                                              : 0) {}

  bool contains(uint32_t Address, uint32_t Bytes) const {
    return Bytes <= Size && Address - Begin <= Size - Bytes;
  }
};

} // namespace tp

#endif // TP_SIMULATOR_CORE_LOCALSTORE_H
