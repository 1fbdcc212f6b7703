//===- Heap.cpp - malloc and its kin --------------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// One heap in global memory for all threads. Sizes are rounded up to classes,
// four to each power of two; a free block waits in its class's list and is
// never split or joined, so that every call takes a handful of steps under the
// lock. Memory for new blocks comes from the launch block's free range.
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
constexpr uint32_t NumClasses = 4 * 28 + 1;

SpinLock HeapLock;
Header *FreeLists[NumClasses];
/// 0 before the first allocation.
DeviceAddress NextAddress = 0;

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

} // namespace

} // namespace tp

using namespace tp;

extern "C" {

void *malloc(size_t Bytes) {
  if (Bytes > MaxBytes)
    return nullptr;
  uint32_t ClassBytes;
  uint32_t Class = classOf(Bytes, ClassBytes);
  LockGuard Guard(HeapLock);
  Header *Block = FreeLists[Class];
  if (Block) {
    FreeLists[Class] = Block->Next;
    return Block + 1;
  }
  const LaunchBlock &Launch = launchBlock();
  if (NextAddress == 0)
    NextAddress = (Launch.HeapBegin + 7) & ~7u;
  uint32_t Total = ClassBytes + sizeof(Header);
  if (NextAddress > Launch.HeapEnd || Launch.HeapEnd - NextAddress < Total)
    return nullptr;
  Block = devicePointer<Header>(NextAddress);
  NextAddress += Total;
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
