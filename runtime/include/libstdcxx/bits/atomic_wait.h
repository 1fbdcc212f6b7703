//===- atomic_wait.h - Waiting for an atomic object to change ---*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Takes the place of libstdc++'s header. Nothing can wake a thread of the TP:
// one that waits looks again and again, and sleeps for longer and longer in
// between, so that it leaves the memory to the others.
//
//===----------------------------------------------------------------------===//

#ifndef TP_LIBSTDCXX_ATOMIC_WAIT_H
#define TP_LIBSTDCXX_ATOMIC_WAIT_H

#include <bits/c++config.h>

#define __cpp_lib_atomic_wait 201907L

namespace std {

namespace __detail {
using __platform_wait_t = int;

inline void __thread_relax() noexcept { __builtin_tp_sleep(16); }
} // namespace __detail

template <typename Object, typename Predicate>
void __atomic_wait_address(const Object *, Predicate IsOver) noexcept {
  for (unsigned Pause = 16; !IsOver(); Pause = Pause < 1024 ? Pause * 2 : Pause)
    __builtin_tp_sleep(Pause);
}

template <typename Object, typename Load>
void __atomic_wait_address_v(const Object *Address, Object Old,
                             Load Value) noexcept {
  __atomic_wait_address(Address, [&] {
    Object Now = Value();
    return __builtin_memcmp(&Now, &Old, sizeof(Object)) != 0;
  });
}

template <typename Object>
void __atomic_notify_address(const Object *, bool) noexcept {}

} // namespace std

#endif // TP_LIBSTDCXX_ATOMIC_WAIT_H
