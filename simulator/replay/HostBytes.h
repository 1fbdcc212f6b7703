//===- HostBytes.h - Simulated memory on the host ---------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_REPLAY_HOSTBYTES_H
#define TP_SIMULATOR_REPLAY_HOSTBYTES_H

#include "simulator/core/AddressSpace.h"

#include <cstdint>

namespace tp {

/// Host address of \p Bytes bytes as the thread with this local store addresses
/// them; null if they are no memory.
inline uint8_t *hostBytes(const AddressSpace &Space, uintptr_t LocalStoreBias,
                          uint32_t Address, uint64_t Bytes) {
  if (Bytes == 0)
    return nullptr;
  if (Space.isLocal(Address) &&
      Bytes <= Space.LocalBytes - (Address - Space.LocalBegin))
    return reinterpret_cast<uint8_t *>(LocalStoreBias + Address);
  if (Space.isGlobal(Address) &&
      Bytes <= Space.GlobalBytes - (Address - kGlobalMemoryBegin))
    return Space.Global + Address;
  return nullptr;
}

/// Whether one of the bytes is an instruction's.
inline bool hasText(const AddressSpace &Space, uint32_t Address,
                    uint64_t Bytes) {
  return Address < uint64_t(Space.TextBegin) + uint64_t(Space.TextWords) * 4 &&
         Address + Bytes > Space.TextBegin;
}

} // namespace tp

#endif // TP_SIMULATOR_REPLAY_HOSTBYTES_H
