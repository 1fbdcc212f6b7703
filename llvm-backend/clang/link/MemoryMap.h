//===- MemoryMap.h - Where a program lies in memory -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The TP has one flat 32-bit address space: nothing below GlobalBegin, then
// global memory, and at the top each TP's private local store.
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_LINK_MEMORYMAP_H
#define TP_LLVM_BACKEND_CLANG_LINK_MEMORYMAP_H

#include "runtime/include/tp/memory_map.h"

#include <cstdint>

namespace tp::memorymap {

/// Accesses below trap; a program's text starts here.
inline constexpr uint32_t GlobalBegin = kGlobalMemoryBegin;

/// A program that ends below never meets the local store of any chip.
inline constexpr uint64_t GlobalEnd = 0x100000000 - kLocalStoreBytesMax;

/// thread_local objects end here.
inline constexpr uint32_t ThreadLocalEnd = 0u - kLocalStoreReservedBytes;

/// Thread_local objects take at most what the largest local store has.
inline constexpr uint32_t ThreadLocalBytesMax =
    kLocalStoreBytesMax - kLocalStoreReservedBytes;

/// The stack pointer is a multiple of this at the start.
inline constexpr uint32_t StackAlignment = 16;

/// The end of the program's image is a multiple of this, for the heap.
inline constexpr uint32_t ImageAlignment = 16;

/// Segments of different protection start at multiples of this.
inline constexpr uint32_t SegmentAlignment = 0x1000;

} // namespace tp::memorymap

#endif // TP_LLVM_BACKEND_CLANG_LINK_MEMORYMAP_H
