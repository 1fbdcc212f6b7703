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

static std::new_handler Handler = nullptr;

static void *allocateOrNull(size_t Bytes, align_val_t Alignment) {
  for (;;) {
    if (void *Memory = aligned_alloc(static_cast<size_t>(Alignment), Bytes))
      return Memory;
    std::new_handler Current = std::get_new_handler();
    if (!Current)
      return nullptr;
    Current();
  }
}

static void *allocate(size_t Bytes, align_val_t Alignment) {
  void *Memory = allocateOrNull(Bytes, Alignment);
  if (!Memory)
    tp::fail("out of memory");
  return Memory;
}

constexpr align_val_t DefaultAlignment{__STDCPP_DEFAULT_NEW_ALIGNMENT__};

const nothrow_t std::nothrow{};

std::new_handler std::set_new_handler(new_handler Function) noexcept {
  return __atomic_exchange_n(&Handler, Function, __ATOMIC_ACQ_REL);
}

std::new_handler std::get_new_handler() noexcept {
  return __atomic_load_n(&Handler, __ATOMIC_ACQUIRE);
}

void *operator new(size_t Bytes) { return allocate(Bytes, DefaultAlignment); }
void *operator new[](size_t Bytes) { return allocate(Bytes, DefaultAlignment); }
void *operator new(size_t Bytes, const nothrow_t &) noexcept {
  return allocateOrNull(Bytes, DefaultAlignment);
}
void *operator new[](size_t Bytes, const nothrow_t &) noexcept {
  return allocateOrNull(Bytes, DefaultAlignment);
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
