//===- Heap.cpp - malloc and its kin --------------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// One heap in global memory for all threads, of blocks side by side. A word
// before each block says its size and whether it and the block before it are
// free; a free block repeats its size in its last word, so that a block that
// becomes free finds both neighbours and joins them (D. E. Knuth, The Art of
// Computer Programming, volume 1, 2.5, boundary tags). Free blocks wait in
// lists by classes of sizes, four to each power of two. A block is taken from
// the first list that has only blocks large enough, and what is too much is
// split off.
//
// Never used memory comes from the launch block's free range by one atomic
// addition, without the lock: threads that allocate at once do not wait for
// each other. Its words are 0 until then, so that a block's header is made by
// an atomic addition, too: the neighbour before it may have become free.
//
// tpsim --check hears of every block, and may ask for room behind blocks and
// that what is given back is not used again at once: then it retires first.
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/crt/SpinLock.h"
#include "tp/check.h"
#include "tp/launch.h"
#include "tp/memory.h"
#include <stdlib.h>
#include <string.h>

extern "C" {
__attribute__((used)) tp::HeapCheckSettings __tp_heap_checks = {};
}

namespace tp {

namespace {

/// A word of memory that the program has used or will use as any other type.
typedef uint32_t __attribute__((may_alias)) Word;

/// Lies 4 bytes below a multiple of 8, where the block's memory starts.
struct __attribute__((may_alias)) Block {
  /// The whole block's bytes, a multiple of 8, and the bits below.
  uint32_t Tag;
  /// In its class's list while this block is free.
  Block *Next;
  Block *Previous;
};

constexpr uint32_t InUse = 1;
constexpr uint32_t PreviousIsFree = 2;
/// In use, but the program has given it back.
constexpr uint32_t IsRetired = 4;
constexpr uint32_t TagBits = 7;

constexpr uint32_t Granule = 8;
constexpr uint32_t HeaderBytes = 4;
/// Room for the links and the size at the end.
constexpr uint32_t MinBytes = 16;
constexpr uint32_t MaxBytes = 0x40000000;
/// Larger blocks of new memory are taken one at a time.
constexpr uint32_t MaxSharedBytes = 0x8000;

constexpr uint32_t MinLog = 4;
constexpr uint32_t NumClasses = 4 * 28;

SpinLock HeapLock;
Block *FreeLists[NumClasses];
/// A bit for each list that is not empty, and one for each word of these bits
/// that is not 0.
uint32_t FreeClasses[NumClasses / 32 + 1];
uint32_t FreeWords = 0;
/// The retired blocks by age, linked by Next, and their bytes.
Block *OldestRetired = nullptr;
Block *YoungestRetired = nullptr;
uint32_t RetiredBytes = 0;
/// Of the free range.
uint32_t UsedBytes = 0;

uint32_t bytesOf(const Block *B) { return B->Tag & ~TagBits; }

Block *behind(Block *B) {
  return reinterpret_cast<Block *>(reinterpret_cast<uintptr_t>(B) + bytesOf(B));
}

Word &lastWord(Block *B) { return reinterpret_cast<Word *>(behind(B))[-1]; }

void *memoryOf(Block *B) {
  return reinterpret_cast<uint32_t *>(B) + HeaderBytes / 4;
}

Block *blockOf(void *Memory) {
  return reinterpret_cast<Block *>(static_cast<uint32_t *>(Memory) -
                                   HeaderBytes / 4);
}

/// Bytes of a block with \p Bytes of memory for the program.
uint32_t blockBytes(uint32_t Bytes) {
  Bytes += __tp_heap_checks.PaddingBytes;
  uint32_t Total = (Bytes + HeaderBytes + Granule - 1) & ~(Granule - 1);
  return Total < MinBytes ? MinBytes : Total;
}

/// The class whose sizes begin at or below \p Bytes.
uint32_t classOf(uint32_t Bytes) {
  uint32_t Log = 31 - __builtin_clz(Bytes);
  return (Log - MinLog) * 4 + (Bytes >> (Log - 2) & 3);
}

/// The first class that has only blocks of \p Bytes or more.
uint32_t classAtLeast(uint32_t Bytes) {
  uint32_t Log = 31 - __builtin_clz(Bytes);
  return classOf(Bytes + (1u << (Log - 2)) - 1);
}

/// The next class from \p Class on that has free blocks, or NumClasses.
uint32_t nonEmptyClass(uint32_t Class) {
  uint32_t Index = Class / 32;
  uint32_t Words = atomicLoad(&FreeWords) & ~0u << Index;
  uint32_t Mask = ~0u << (Class % 32);
  for (; Words != 0; Words &= Words - 1) {
    uint32_t Next = __builtin_ctz(Words);
    uint32_t Bits = atomicLoad(&FreeClasses[Next]);
    if (Next == Index)
      Bits &= Mask;
    if (Bits != 0)
      return Next * 32 + __builtin_ctz(Bits);
  }
  return NumClasses;
}

/// Under the lock; others look without it whether there is anything.
void setBits(uint32_t &Word, uint32_t Bits) { atomicStore(&Word, Word | Bits); }
void clearBits(uint32_t &Word, uint32_t Bits) {
  atomicStore(&Word, Word & ~Bits);
}

void addToList(Block *B) {
  uint32_t Class = classOf(bytesOf(B));
  B->Previous = nullptr;
  B->Next = FreeLists[Class];
  if (B->Next)
    B->Next->Previous = B;
  FreeLists[Class] = B;
  setBits(FreeClasses[Class / 32], 1u << Class % 32);
  setBits(FreeWords, 1u << Class / 32);
}

void removeFromList(Block *B) {
  if (B->Next)
    B->Next->Previous = B->Previous;
  if (B->Previous) {
    B->Previous->Next = B->Next;
    return;
  }
  uint32_t Class = classOf(bytesOf(B));
  FreeLists[Class] = B->Next;
  if (B->Next)
    return;
  clearBits(FreeClasses[Class / 32], 1u << Class % 32);
  if (FreeClasses[Class / 32] == 0)
    clearBits(FreeWords, 1u << Class / 32);
}

/// Makes \p B free, joined with its free neighbours.
void release(Block *B) {
  uint32_t Bytes = bytesOf(B);
  Block *Behind = behind(B);
  uint32_t TagBehind = atomicLoad(&Behind->Tag);
  if (TagBehind & ~TagBits && !(TagBehind & InUse)) {
    removeFromList(Behind);
    Bytes += bytesOf(Behind);
  } else {
    atomicOr(&Behind->Tag, PreviousIsFree);
  }
  uint32_t Flags = B->Tag & PreviousIsFree;
  if (Flags) {
    uint32_t BytesBefore = reinterpret_cast<Word *>(B)[-1];
    B = reinterpret_cast<Block *>(reinterpret_cast<uintptr_t>(B) - BytesBefore);
    removeFromList(B);
    Bytes += BytesBefore;
    Flags = 0;
  }
  B->Tag = Bytes | Flags;
  lastWord(B) = Bytes;
  addToList(B);
}

/// Makes \p B unused, and free those that have been so for long enough.
void retire(Block *B) {
  B->Tag |= IsRetired;
  B->Next = nullptr;
  if (YoungestRetired)
    YoungestRetired->Next = B;
  else
    OldestRetired = B;
  YoungestRetired = B;
  RetiredBytes += bytesOf(B);
  while (RetiredBytes > __tp_heap_checks.RetiredBytes) {
    Block *Oldest = OldestRetired;
    OldestRetired = Oldest->Next;
    if (!OldestRetired)
      YoungestRetired = nullptr;
    RetiredBytes -= bytesOf(Oldest);
    Oldest->Tag &= ~IsRetired;
    release(Oldest);
  }
}

/// Cuts \p B, which is in use, down to \p Bytes if the rest makes a block.
void trim(Block *B, uint32_t Bytes) {
  uint32_t Rest = bytesOf(B) - Bytes;
  if (Rest < MinBytes)
    return;
  B->Tag -= Rest;
  Block *Tail = behind(B);
  Tail->Tag = Rest | InUse;
  release(Tail);
}

/// Takes \p B, which is free, off its list.
void use(Block *B) {
  removeFromList(B);
  B->Tag |= InUse;
  atomicAnd(&behind(B)->Tag, ~PreviousIsFree);
}

/// A free block of \p Bytes or more out of the lists. If \p Last is set there
/// is no other memory: then the one list is searched where sizes lie on both
/// sides.
Block *reuse(uint32_t Bytes, bool Last) {
  uint32_t Class = classAtLeast(Bytes);
  // Whoever sees empty lists may as well take new memory.
  if (!Last && nonEmptyClass(Class) == NumClasses)
    return nullptr;
  LockGuard Guard(HeapLock);
  Class = nonEmptyClass(Class);
  Block *B = nullptr;
  if (Class != NumClasses)
    B = FreeLists[Class];
  else if (Last)
    for (B = FreeLists[classOf(Bytes)]; B && bytesOf(B) < Bytes; B = B->Next)
      ;
  if (!B)
    return nullptr;
  use(B);
  trim(B, Bytes);
  return B;
}

/// \p Bytes of the free range; 0 when it is used up.
DeviceAddress take(uint32_t Bytes) {
  const LaunchBlock &Launch = launchBlock();
  DeviceAddress Begin =
      ((Launch.HeapBegin + Granule - 1) & ~(Granule - 1)) + HeaderBytes;
  // The last block has a header behind it like any other.
  DeviceAddress End = (Launch.HeapEnd & ~(Granule - 1)) - HeaderBytes;
  if (Begin >= End || End > Launch.HeapEnd)
    return 0;
  // Sums of what is used and what all threads ask for at once stay in 32 bits.
  uint32_t Size = End - Begin;
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

/// A block in use of \p Bytes or a little more, or null.
Block *allocate(uint32_t Bytes) {
  if (Block *B = reuse(Bytes, /*Last=*/false))
    return B;
  DeviceAddress Address = take(Bytes);
  if (Address == 0)
    return reuse(Bytes, /*Last=*/true);
  Block *B = devicePointer<Block>(Address);
  atomicAdd(&B->Tag, Bytes | InUse);
  return B;
}

/// The block of memory that the program gives back. A message would need stack
/// and could come back here: a trap names the reason.
Block *checkedBlock(void *Memory) {
  Block *B = blockOf(Memory);
  if (deviceAddress(Memory) % Granule != 0 ||
      (atomicLoad(&B->Tag) & (InUse | (TagBits & ~PreviousIsFree))) != InUse)
    __builtin_verbose_trap(
        "heap", "memory given back is not in use, or was written past its end");
  return B;
}

/// Whether \p B could take in free memory behind it up to \p Bytes.
bool grow(Block *B, uint32_t Bytes) {
  LockGuard Guard(HeapLock);
  Block *Behind = behind(B);
  uint32_t TagBehind = atomicLoad(&Behind->Tag);
  uint32_t Total = bytesOf(B) + (TagBehind & ~TagBits);
  if (TagBehind & InUse || Total < Bytes)
    return false;
  use(Behind);
  B->Tag += bytesOf(Behind);
  trim(B, Bytes);
  return true;
}

} // namespace

} // namespace tp

using namespace tp;

extern "C" {

void *malloc(size_t Bytes) {
  if (Bytes > MaxBytes)
    return nullptr;
  allocatorEntered(Bytes);
  Block *B = allocate(blockBytes(Bytes));
  return allocated(B ? memoryOf(B) : nullptr);
}

void free(void *Memory) {
  if (!Memory)
    return;
  freeing(Memory);
  allocatorEntered(0);
  {
    LockGuard Guard(HeapLock);
    Block *B = checkedBlock(Memory);
    if (__tp_heap_checks.RetiredBytes != 0)
      retire(B);
    else
      release(B);
  }
  allocatorLeft();
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
  if (Bytes > MaxBytes)
    return nullptr;
  allocatorEntered(Bytes);
  Block *B = checkedBlock(Memory);
  uint32_t Old = bytesOf(B), New = blockBytes(Bytes);
  if (New <= Old) {
    // What is cut off may be another thread's at once.
    resized(Memory);
    allocatorEntered(0);
    if (Old - New >= MinBytes) {
      LockGuard Guard(HeapLock);
      trim(B, New);
    }
    allocatorLeft();
    return Memory;
  }
  if (grow(B, New))
    return resized(Memory);
  void *Copy = malloc(Bytes);
  if (Copy) {
    memcpy(Copy, Memory, Old - HeaderBytes);
    free(Memory);
  }
  allocatorLeft();
  return Copy;
}

void *aligned_alloc(size_t Alignment, size_t Bytes) {
  if (Alignment == 0 || (Alignment & (Alignment - 1)) != 0)
    return nullptr;
  if (Alignment <= Granule)
    return malloc(Bytes);
  if (Bytes > MaxBytes || Alignment > MaxBytes)
    return nullptr;
  allocatorEntered(Bytes);
  // Room for a block of its own before the aligned address.
  uint32_t Needed = blockBytes(Bytes);
  Block *B = allocate(Needed + Alignment + MinBytes);
  if (!B)
    return allocated(nullptr);
  uint32_t Address = deviceAddress(memoryOf(B));
  uint32_t Aligned = (Address + Alignment - 1) & ~(Alignment - 1);
  uint32_t Before = Aligned - Address;
  if (Before != 0 && Before < MinBytes)
    Before += Alignment;
  {
    LockGuard Guard(HeapLock);
    if (Before != 0) {
      Block *Front = B;
      B = devicePointer<Block>(deviceAddress(Front) + Before);
      B->Tag = (bytesOf(Front) - Before) | InUse;
      Front->Tag -= bytesOf(B);
      release(Front);
    }
    trim(B, Needed);
  }
  return allocated(memoryOf(B));
}

} // extern "C"
