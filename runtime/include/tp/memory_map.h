//===- memory_map.h - Where memory lies in the address space ----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The numbers that the linker, the simulator and the host twin share.
//
//===----------------------------------------------------------------------===//

#ifndef TP_MEMORY_MAP_H
#define TP_MEMORY_MAP_H

#include <stdint.h>

namespace tp {

/// The first byte of global memory; accesses below it are null dereferences.
inline constexpr uint32_t kGlobalMemoryBegin = 0x10000;

/// Bytes of the largest local store that a chip may have. A TP's local store is
/// the end of the address space.
inline constexpr uint32_t kLocalStoreBytesMax = 0x100000;

/// The last bytes of the address space stay unused, so that a pointer one past
/// the end of a thread_local object does not wrap around to 0.
inline constexpr uint32_t kLocalStoreReservedBytes = 16;

} // namespace tp

#endif // TP_MEMORY_MAP_H
