//===- std_thread.h - Which thread this is ----------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Takes the place of libstdc++'s header: the part of std::thread that <barrier>
// needs.
//
//===----------------------------------------------------------------------===//

#ifndef TP_LIBSTDCXX_STD_THREAD_H
#define TP_LIBSTDCXX_STD_THREAD_H

#include <bits/functional_hash.h>

namespace std {

class thread {
public:
  class id {
  public:
    explicit id(unsigned Number) : Number(Number) {}

  private:
    friend struct hash<id>;
    unsigned Number;
  };
};

template <> struct hash<thread::id> {
  size_t operator()(thread::id Id) const noexcept { return Id.Number; }
};

namespace this_thread {
inline thread::id get_id() noexcept {
  return thread::id(__builtin_tp_thread_id());
}
} // namespace this_thread

} // namespace std

#endif // TP_LIBSTDCXX_STD_THREAD_H
