//===- CxxAbi.cpp - What compiled C++ expects of its runtime --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Itanium C++ ABI, without exceptions.
//
//===----------------------------------------------------------------------===//

#include "tp/atomic.h"
#include "tp/barrier.h"
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

namespace std {
enum class align_val_t : size_t {};
struct nothrow_t {
  explicit nothrow_t() = default;
};
extern const nothrow_t nothrow;
const nothrow_t nothrow{};
} // namespace std

namespace {

/// Nearly every program may come here: printf would need much stack.
[[noreturn]] void fail(const char *Message) {
  const char *const Parts[] = {"error: ", Message, "\n"};
  for (const char *Part : Parts)
    fputs(Part, stderr);
  abort();
}

void *allocate(size_t Bytes, size_t Alignment) {
  void *Memory = aligned_alloc(Alignment, Bytes);
  if (!Memory)
    fail("out of memory");
  return Memory;
}

constexpr size_t DefaultAlignment = 8;

/// The first byte of a guard is set once the object is made; our second word
/// is set while a thread makes it.
struct Guard {
  uint8_t Done;
  uint8_t Unused[3];
  uint32_t Busy;
};

} // namespace

extern "C" {

int __cxa_guard_acquire(uint64_t *Word) {
  Guard *G = reinterpret_cast<Guard *>(Word);
  for (;;) {
    if (__atomic_load_n(&G->Done, __ATOMIC_ACQUIRE))
      return 0;
    if (tp::atomicExchange(&G->Busy, 1u, __ATOMIC_ACQUIRE) == 0) {
      if (!__atomic_load_n(&G->Done, __ATOMIC_ACQUIRE))
        return 1;
      tp::atomicStore(&G->Busy, 0u, __ATOMIC_RELEASE);
      return 0;
    }
    tp::sleep(64);
  }
}

void __cxa_guard_release(uint64_t *Word) {
  Guard *G = reinterpret_cast<Guard *>(Word);
  __atomic_store_n(&G->Done, uint8_t(1), __ATOMIC_RELEASE);
  tp::atomicStore(&G->Busy, 0u, __ATOMIC_RELEASE);
}

void __cxa_guard_abort(uint64_t *Word) {
  tp::atomicStore(&reinterpret_cast<Guard *>(Word)->Busy, 0u, __ATOMIC_RELEASE);
}

[[noreturn]] void __cxa_pure_virtual() { fail("pure virtual function called"); }

[[noreturn]] void __cxa_deleted_virtual() {
  fail("deleted virtual function called");
}

} // extern "C"

namespace std {
[[noreturn]] void terminate() noexcept { fail("std::terminate called"); }
void __throw_bad_alloc() { fail("std::bad_alloc"); }
void __throw_bad_array_new_length() { fail("std::bad_array_new_length"); }
void __throw_bad_function_call() { fail("std::bad_function_call"); }
void __throw_length_error(const char *Message) { fail(Message); }
void __throw_logic_error(const char *Message) { fail(Message); }
void __throw_out_of_range(const char *Message) { fail(Message); }
void __throw_out_of_range_fmt(const char *Message, ...) { fail(Message); }
void __throw_invalid_argument(const char *Message) { fail(Message); }
void __glibcxx_assert_fail(const char *, int, const char *,
                           const char *Condition) {
  fail(Condition);
}
} // namespace std

void *operator new(size_t Bytes) { return allocate(Bytes, DefaultAlignment); }
void *operator new[](size_t Bytes) { return allocate(Bytes, DefaultAlignment); }
void *operator new(size_t Bytes, const std::nothrow_t &) noexcept {
  return malloc(Bytes);
}
void *operator new[](size_t Bytes, const std::nothrow_t &) noexcept {
  return malloc(Bytes);
}
void *operator new(size_t Bytes, std::align_val_t Alignment) {
  return allocate(Bytes, static_cast<size_t>(Alignment));
}
void *operator new[](size_t Bytes, std::align_val_t Alignment) {
  return allocate(Bytes, static_cast<size_t>(Alignment));
}
void operator delete(void *Memory) noexcept { free(Memory); }
void operator delete[](void *Memory) noexcept { free(Memory); }
void operator delete(void *Memory, size_t) noexcept { free(Memory); }
void operator delete[](void *Memory, size_t) noexcept { free(Memory); }
void operator delete(void *Memory, std::align_val_t) noexcept { free(Memory); }
void operator delete[](void *Memory, std::align_val_t) noexcept {
  free(Memory);
}
void operator delete(void *Memory, size_t, std::align_val_t) noexcept {
  free(Memory);
}
void operator delete[](void *Memory, size_t, std::align_val_t) noexcept {
  free(Memory);
}
