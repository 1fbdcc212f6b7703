//===- Heap.cpp - malloc and its kin --------------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// One heap in global memory for all threads. Sizes are rounded up to classes,
// four to each power of two; a free block waits in its class's list and is
// never split or joined, so that every call takes a handful of steps. Memory
// for new blocks comes from the launch block's free range by one atomic
// addition, so that threads that allocate at once do not wait for each other;
// only reusing and freeing take the lock.
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/crt/SpinLock.h"
#include "tp/launch.h"
#include "tp/memory.h"
#include <stdlib.h>
#include <string.h>

namespace tp {

namespace {

/// Lies before each block. Its size keeps the block's alignment.
struct alignas(8) Header {
  uint32_t Class;
  /// The next free block while this one is free.
  Header *Next;
};

constexpr uint32_t MinBytes = 8;
constexpr uint32_t MaxBytes = 0x40000000;
/// Larger blocks are taken one at a time.
constexpr uint32_t MaxSharedBytes = 0x8000;
constexpr uint32_t NumClasses = 4 * 28 + 1;

SpinLock HeapLock;
Header *FreeLists[NumClasses];
/// Of the free range.
uint32_t UsedBytes = 0;

/// Number of the smallest class that holds \p Bytes, and its size.
uint32_t classOf(uint32_t Bytes, uint32_t &ClassBytes) {
  if (Bytes <= MinBytes) {
    ClassBytes = MinBytes;
    return 0;
  }
  uint32_t Log = 31 - __builtin_clz(Bytes - 1);
  uint32_t Quarter = Log < 5 ? 8 : 1u << (Log - 2);
  uint32_t Start = 1u << Log;
  uint32_t Step = (Bytes - Start + Quarter - 1) / Quarter;
  ClassBytes = Start + Step * Quarter;
  return (Log - 3) * 4 + Step;
}

/// A free block of \p Class, or null.
Header *reuse(uint32_t Class) {
  // Whoever sees an empty list may as well take new memory.
  if (!__atomic_load_n(&FreeLists[Class], __ATOMIC_RELAXED))
    return nullptr;
  LockGuard Guard(HeapLock);
  Header *Block = FreeLists[Class];
  if (Block)
    FreeLists[Class] = Block->Next;
  return Block;
}

/// \p Bytes, a multiple of 8, of the free range; 0 when it is used up. While
/// another thread finds that out, this one may do so a little early.
DeviceAddress take(uint32_t Bytes) {
  const LaunchBlock &Launch = launchBlock();
  DeviceAddress Begin = (Launch.HeapBegin + 7) & ~7u;
  if (Begin >= Launch.HeapEnd)
    return 0;
  // Sums of what is used and what all threads ask for at once stay in 32 bits.
  uint32_t Size = Launch.HeapEnd - Begin;
  if (Size > 0xC0000000u)
    Size = 0xC0000000u;
  if (Bytes <= MaxSharedBytes) {
    uint32_t Used = atomicAdd(&UsedBytes, Bytes);
    if (Used < Size && Size - Used >= Bytes)
      return Begin + Used;
    atomicAdd(&UsedBytes, -Bytes);
    return 0;
  }
  uint32_t Used = atomicLoad(&UsedBytes);
  for (;;) {
    if (Used >= Size || Size - Used < Bytes)
      return 0;
    uint32_t Seen = atomicCompareExchange(&UsedBytes, Used, Used + Bytes);
    if (Seen == Used)
      return Begin + Used;
    Used = Seen;
  }
}

} // namespace

} // namespace tp

using namespace tp;

extern "C" {

void *malloc(size_t Bytes) {
  if (Bytes > MaxBytes)
    return nullptr;
  uint32_t ClassBytes;
  uint32_t Class = classOf(Bytes, ClassBytes);
  Header *Block = reuse(Class);
  if (Block)
    return Block + 1;
  DeviceAddress Address = take(ClassBytes + sizeof(Header));
  if (Address == 0)
    return nullptr;
  Block = devicePointer<Header>(Address);
  Block->Class = Class;
  return Block + 1;
}

void free(void *Memory) {
  if (!Memory)
    return;
  Header *Block = static_cast<Header *>(Memory) - 1;
  LockGuard Guard(HeapLock);
  Block->Next = FreeLists[Block->Class];
  FreeLists[Block->Class] = Block;
}

void *calloc(size_t Count, size_t Bytes) {
  uint32_t Total;
  if (__builtin_mul_overflow(Count, Bytes, &Total))
    return nullptr;
  void *Memory = malloc(Total);
  return Memory ? memset(Memory, 0, Total) : nullptr;
}

void *realloc(void *Memory, size_t Bytes) {
  if (!Memory)
    return malloc(Bytes);
  Header *Block = static_cast<Header *>(Memory) - 1;
  uint32_t ClassBytes;
  if (Bytes <= MaxBytes && classOf(Bytes, ClassBytes) == Block->Class)
    return Memory;
  void *Copy = malloc(Bytes);
  if (!Copy)
    return nullptr;
  uint32_t OldBytes = MinBytes;
  if (Block->Class != 0) {
    uint32_t Log = (Block->Class - 1) / 4 + 3;
    uint32_t Quarter = Log < 5 ? 8 : 1u << (Log - 2);
    OldBytes = (1u << Log) + (Block->Class - (Log - 3) * 4) * Quarter;
  }
  memcpy(Copy, Memory, OldBytes < Bytes ? OldBytes : Bytes);
  free(Memory);
  return Copy;
}

void *aligned_alloc(size_t Alignment, size_t Bytes) {
  if (Alignment <= 8)
    return malloc(Bytes);
  // A header of its own lies right before the aligned address, so that free()
  // needs no special case: what is cut off in front is lost.
  if (Bytes > MaxBytes || Alignment > MaxBytes)
    return nullptr;
  uint32_t ClassBytes;
  uint32_t Class = classOf(Bytes, ClassBytes);
  void *Memory = malloc(ClassBytes + Alignment);
  if (!Memory)
    return nullptr;
  uint32_t Address = deviceAddress(Memory);
  uint32_t Aligned = (Address + Alignment - 1) & ~(Alignment - 1);
  if (Aligned == Address)
    return Memory;
  Header *Block = devicePointer<Header>(Aligned) - 1;
  Block->Class = Class;
  return Block + 1;
}

} // extern "C"
