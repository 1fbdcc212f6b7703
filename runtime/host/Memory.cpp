//===- Memory.cpp - The arena that stands for global memory ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "runtime/host/HostRuntime.h"
#include "tp/memory_map.h"
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>

namespace tp::host {

constexpr uint64_t ArenaBytes = uint64_t(1) << 32;

[[noreturn]] static void fail(const char *Message) {
  fprintf(stderr, "error: %s\n", Message);
  exit(1);
}

namespace {

struct Arena {
  char *Base;
  uint64_t Next = kGlobalMemoryBegin;

  Arena() {
    void *Memory = mmap(nullptr, ArenaBytes, PROT_READ | PROT_WRITE,
                        MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (Memory == MAP_FAILED)
      fail("cannot reserve 4 GiB of address space for the kernel's memory");
    Base = static_cast<char *>(Memory);
  }
};

} // namespace

static Arena &arena() {
  static Arena TheArena;
  return TheArena;
}

DeviceAddress allocate(uint32_t Bytes, uint32_t Alignment) {
  Arena &A = arena();
  uint64_t Begin = (A.Next + Alignment - 1) & ~uint64_t(Alignment - 1);
  if (Begin + Bytes > ArenaBytes)
    fail("the kernel's memory is used up: a TP addresses at most 4 GiB");
  A.Next = Begin + Bytes;
  return static_cast<DeviceAddress>(Begin);
}

void *hostPointer(DeviceAddress Address) {
  return Address ? arena().Base + Address : nullptr;
}

DeviceAddress deviceAddress(const void *Pointer) {
  return Pointer ? static_cast<DeviceAddress>(
                       static_cast<const char *>(Pointer) - arena().Base)
                 : 0;
}

void resetMemory() {
  Arena &A = arena();
  madvise(A.Base, A.Next, MADV_DONTNEED);
  A.Next = kGlobalMemoryBegin;
}

} // namespace tp::host
