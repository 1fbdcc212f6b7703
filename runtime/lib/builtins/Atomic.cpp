//===- Atomic.cpp - Atomic operations wider than a word -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// LLVM's __atomic_* library interface for the sizes that no instruction does.
// Locks, chosen by the object's address, keep each operation whole; every
// operation is sequentially consistent whatever order it asks for.
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/crt/SpinLock.h"
#include <stddef.h>
#include <stdint.h>
#include <string.h>

namespace {

constexpr uint32_t NumLocks = 16;
tp::SpinLock Locks[NumLocks];

tp::SpinLock &lockOf(const volatile void *Object) {
  return Locks[reinterpret_cast<uintptr_t>(Object) / 8 % NumLocks];
}

template <typename Operation>
uint64_t change(volatile uint64_t *Object, Operation NewValue) {
  tp::LockGuard Guard(lockOf(Object));
  uint64_t Old = *Object;
  *Object = NewValue(Old);
  return Old;
}

} // namespace

// Clang knows the generic functions by name and does not let them be defined.
extern "C" {
void genericLoad(size_t Bytes, const void *Object, void *Result,
                 int Order) __asm__("__atomic_load");
void genericStore(size_t Bytes, void *Object, const void *Value,
                  int Order) __asm__("__atomic_store");
void genericExchange(size_t Bytes, void *Object, const void *Value,
                     void *Result, int Order) __asm__("__atomic_exchange");
bool genericCompareExchange(size_t Bytes, void *Object, void *Expected,
                            const void *Desired, int Success,
                            int Failure) __asm__("__atomic_compare_exchange");
bool isLockFree(size_t Bytes,
                const void *Object) __asm__("__atomic_is_lock_free");
uint64_t load8(const volatile uint64_t *Object,
               int Order) __asm__("__atomic_load_8");
void store8(volatile uint64_t *Object, uint64_t Value,
            int Order) __asm__("__atomic_store_8");
uint64_t exchange8(volatile uint64_t *Object, uint64_t Value,
                   int Order) __asm__("__atomic_exchange_8");
bool compareExchange8(volatile uint64_t *Object, uint64_t *Expected,
                      uint64_t Desired, int Success,
                      int Failure) __asm__("__atomic_compare_exchange_8");
uint64_t fetchAdd8(volatile uint64_t *Object, uint64_t Value,
                   int Order) __asm__("__atomic_fetch_add_8");
uint64_t fetchSub8(volatile uint64_t *Object, uint64_t Value,
                   int Order) __asm__("__atomic_fetch_sub_8");
uint64_t fetchAnd8(volatile uint64_t *Object, uint64_t Value,
                   int Order) __asm__("__atomic_fetch_and_8");
uint64_t fetchOr8(volatile uint64_t *Object, uint64_t Value,
                  int Order) __asm__("__atomic_fetch_or_8");
uint64_t fetchXor8(volatile uint64_t *Object, uint64_t Value,
                   int Order) __asm__("__atomic_fetch_xor_8");
uint64_t fetchNand8(volatile uint64_t *Object, uint64_t Value,
                    int Order) __asm__("__atomic_fetch_nand_8");
}

void genericLoad(size_t Bytes, const void *Object, void *Result, int) {
  tp::LockGuard Guard(lockOf(Object));
  memcpy(Result, Object, Bytes);
}

void genericStore(size_t Bytes, void *Object, const void *Value, int) {
  tp::LockGuard Guard(lockOf(Object));
  memcpy(Object, Value, Bytes);
}

void genericExchange(size_t Bytes, void *Object, const void *Value,
                     void *Result, int) {
  tp::LockGuard Guard(lockOf(Object));
  memcpy(Result, Object, Bytes);
  memcpy(Object, Value, Bytes);
}

bool genericCompareExchange(size_t Bytes, void *Object, void *Expected,
                            const void *Desired, int, int) {
  tp::LockGuard Guard(lockOf(Object));
  bool Equal = memcmp(Object, Expected, Bytes) == 0;
  if (Equal)
    memcpy(Object, Desired, Bytes);
  else
    memcpy(Expected, Object, Bytes);
  return Equal;
}

bool isLockFree(size_t Bytes, const void *) { return Bytes <= 4; }

uint64_t load8(const volatile uint64_t *Object, int) {
  tp::LockGuard Guard(lockOf(Object));
  return *Object;
}

void store8(volatile uint64_t *Object, uint64_t Value, int) {
  change(Object, [=](uint64_t) { return Value; });
}

uint64_t exchange8(volatile uint64_t *Object, uint64_t Value, int) {
  return change(Object, [=](uint64_t) { return Value; });
}

bool compareExchange8(volatile uint64_t *Object, uint64_t *Expected,
                      uint64_t Desired, int, int) {
  uint64_t Wanted = *Expected;
  uint64_t Old = change(Object, [=](uint64_t Value) {
    return Value == Wanted ? Desired : Value;
  });
  *Expected = Old;
  return Old == Wanted;
}

uint64_t fetchAdd8(volatile uint64_t *Object, uint64_t Value, int) {
  return change(Object, [=](uint64_t Old) { return Old + Value; });
}

uint64_t fetchSub8(volatile uint64_t *Object, uint64_t Value, int) {
  return change(Object, [=](uint64_t Old) { return Old - Value; });
}

uint64_t fetchAnd8(volatile uint64_t *Object, uint64_t Value, int) {
  return change(Object, [=](uint64_t Old) { return Old & Value; });
}

uint64_t fetchOr8(volatile uint64_t *Object, uint64_t Value, int) {
  return change(Object, [=](uint64_t Old) { return Old | Value; });
}

uint64_t fetchXor8(volatile uint64_t *Object, uint64_t Value, int) {
  return change(Object, [=](uint64_t Old) { return Old ^ Value; });
}

uint64_t fetchNand8(volatile uint64_t *Object, uint64_t Value, int) {
  return change(Object, [=](uint64_t Old) { return ~(Old & Value); });
}
