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

#include <cstdint>

namespace tp::memorymap {

/// Accesses below trap; a program's text starts here.
inline constexpr uint32_t GlobalBegin = 0x10000;

/// The largest local store of any chip is 1 MiB: a program that ends below
/// never meets it.
inline constexpr uint64_t GlobalEnd = 0x100000000 - 0x100000;

/// thread_local objects end here. The 16 bytes above are reserved, so that a
/// pointer past the end of an object does not wrap around to 0.
inline constexpr uint32_t ThreadLocalEnd = 0xFFFFFFF0;

/// Thread_local objects take at most what the largest local store has.
inline constexpr uint32_t ThreadLocalBytesMax = 0x100000 - 16;

/// The stack pointer is a multiple of this at the start.
inline constexpr uint32_t StackAlignment = 16;

/// The end of the program's image is a multiple of this, for the heap.
inline constexpr uint32_t ImageAlignment = 16;

/// Segments of different protection start at multiples of this.
inline constexpr uint32_t SegmentAlignment = 0x1000;

} // namespace tp::memorymap

#endif // TP_LLVM_BACKEND_CLANG_LINK_MEMORYMAP_H
