//===- atomic.h - Atomic operations on 32-bit words -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Each function changes one word of memory in one step and returns what the
// word held before. Order is relaxed unless the caller names another of the
// __ATOMIC_* orders, which must be a constant.
//
//===----------------------------------------------------------------------===//

#ifndef TP_ATOMIC_H
#define TP_ATOMIC_H

#include <stdint.h>

namespace tp {

/// Keeps \p T to the types that the TP has atomic instructions for, and keeps a
/// function's value parameters out of template argument deduction.
template <typename T> struct AtomicWord;
template <> struct AtomicWord<uint32_t> {
  using Type = uint32_t;
};
template <> struct AtomicWord<int32_t> {
  using Type = int32_t;
};

template <typename T>
inline T atomicAdd(T *Address, typename AtomicWord<T>::Type Value,
                   int Order = __ATOMIC_RELAXED) {
  return __atomic_fetch_add(Address, Value, Order);
}

template <typename T>
inline T atomicMin(T *Address, typename AtomicWord<T>::Type Value,
                   int Order = __ATOMIC_RELAXED) {
  return __atomic_fetch_min(Address, Value, Order);
}

template <typename T>
inline T atomicMax(T *Address, typename AtomicWord<T>::Type Value,
                   int Order = __ATOMIC_RELAXED) {
  return __atomic_fetch_max(Address, Value, Order);
}

template <typename T>
inline T atomicAnd(T *Address, typename AtomicWord<T>::Type Value,
                   int Order = __ATOMIC_RELAXED) {
  return __atomic_fetch_and(Address, Value, Order);
}

template <typename T>
inline T atomicOr(T *Address, typename AtomicWord<T>::Type Value,
                  int Order = __ATOMIC_RELAXED) {
  return __atomic_fetch_or(Address, Value, Order);
}

template <typename T>
inline T atomicXor(T *Address, typename AtomicWord<T>::Type Value,
                   int Order = __ATOMIC_RELAXED) {
  return __atomic_fetch_xor(Address, Value, Order);
}

template <typename T>
inline T atomicExchange(T *Address, typename AtomicWord<T>::Type Value,
                        int Order = __ATOMIC_RELAXED) {
  return __atomic_exchange_n(Address, Value, Order);
}

/// Stores \p Desired if the word holds \p Expected: it did so exactly when the
/// result equals \p Expected.
template <typename T>
inline T atomicCompareExchange(T *Address,
                               typename AtomicWord<T>::Type Expected,
                               typename AtomicWord<T>::Type Desired,
                               int Order = __ATOMIC_RELAXED) {
  __atomic_compare_exchange_n(Address, &Expected, Desired, /*weak=*/false,
                              Order, __ATOMIC_RELAXED);
  return Expected;
}

template <typename T>
inline T atomicLoad(const T *Address, int Order = __ATOMIC_RELAXED) {
  return __atomic_load_n(Address, Order);
}

template <typename T>
inline void atomicStore(T *Address, typename AtomicWord<T>::Type Value,
                        int Order = __ATOMIC_RELAXED) {
  __atomic_store_n(Address, Value, Order);
}

} // namespace tp

#endif // TP_ATOMIC_H
