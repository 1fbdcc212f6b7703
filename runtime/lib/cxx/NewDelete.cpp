//===- NewDelete.cpp - Memory by operators ------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/cxx/Failure.h"
#include <new>
#include <stddef.h>
#include <stdlib.h>

using std::align_val_t;
using std::nothrow_t;

static void *allocate(size_t Bytes) {
  void *Memory = malloc(Bytes);
  if (!Memory)
    tp::fail("out of memory");
  return Memory;
}

static void *allocateOrNull(size_t Bytes, align_val_t Alignment) {
  return aligned_alloc(static_cast<size_t>(Alignment), Bytes);
}

static void *allocate(size_t Bytes, align_val_t Alignment) {
  void *Memory = allocateOrNull(Bytes, Alignment);
  if (!Memory)
    tp::fail("out of memory");
  return Memory;
}

const nothrow_t std::nothrow{};

void *operator new(size_t Bytes) { return allocate(Bytes); }
void *operator new[](size_t Bytes) { return allocate(Bytes); }
void *operator new(size_t Bytes, const nothrow_t &) noexcept {
  return malloc(Bytes);
}
void *operator new[](size_t Bytes, const nothrow_t &) noexcept {
  return malloc(Bytes);
}
void *operator new(size_t Bytes, align_val_t Alignment) {
  return allocate(Bytes, Alignment);
}
void *operator new[](size_t Bytes, align_val_t Alignment) {
  return allocate(Bytes, Alignment);
}
void *operator new(size_t Bytes, align_val_t Alignment,
                   const nothrow_t &) noexcept {
  return allocateOrNull(Bytes, Alignment);
}
void *operator new[](size_t Bytes, align_val_t Alignment,
                     const nothrow_t &) noexcept {
  return allocateOrNull(Bytes, Alignment);
}

void operator delete(void *Memory) noexcept { free(Memory); }
void operator delete[](void *Memory) noexcept { free(Memory); }
void operator delete(void *Memory, size_t) noexcept { free(Memory); }
void operator delete[](void *Memory, size_t) noexcept { free(Memory); }
void operator delete(void *Memory, const nothrow_t &) noexcept { free(Memory); }
void operator delete[](void *Memory, const nothrow_t &) noexcept {
  free(Memory);
}
void operator delete(void *Memory, align_val_t) noexcept { free(Memory); }
void operator delete[](void *Memory, align_val_t) noexcept { free(Memory); }
void operator delete(void *Memory, size_t, align_val_t) noexcept {
  free(Memory);
}
void operator delete[](void *Memory, size_t, align_val_t) noexcept {
  free(Memory);
}
void operator delete(void *Memory, align_val_t, const nothrow_t &) noexcept {
  free(Memory);
}
void operator delete[](void *Memory, align_val_t, const nothrow_t &) noexcept {
  free(Memory);
}
