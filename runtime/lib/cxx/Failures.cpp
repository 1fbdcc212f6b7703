//===- Failures.cpp - What would be an exception ------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// libstdc++ calls a function for each kind. The program ends with its message.
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/cxx/Failure.h"
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <memory>

using tp::fail;

namespace tp {

/// Nearly every program may come here: printf would need much stack.
void fail(const char *Message) {
  for (const char *Part : {"error: ", Message, "\n"})
    fputs(Part, stderr);
  abort();
}

} // namespace tp

extern "C" {

[[noreturn]] void __cxa_pure_virtual() { fail("pure virtual function called"); }

[[noreturn]] void __cxa_deleted_virtual() {
  fail("deleted virtual function called");
}

} // extern "C"

namespace std {

static terminate_handler Handler = nullptr;

void terminate() noexcept {
  if (terminate_handler Current = get_terminate())
    Current();
  fail("std::terminate called");
}
terminate_handler set_terminate(terminate_handler Function) noexcept {
  return __atomic_exchange_n(&Handler, Function, __ATOMIC_ACQ_REL);
}
terminate_handler get_terminate() noexcept {
  return __atomic_load_n(&Handler, __ATOMIC_ACQUIRE);
}
bool uncaught_exception() noexcept { return false; }
int uncaught_exceptions() noexcept { return 0; }

void __throw_bad_exception() { fail("std::bad_exception"); }
void __throw_bad_alloc() { fail("std::bad_alloc"); }
void __throw_bad_array_new_length() { fail("std::bad_array_new_length"); }
void __throw_bad_cast() { fail("std::bad_cast"); }
void __throw_bad_typeid() { fail("std::bad_typeid"); }
void __throw_bad_function_call() { fail("std::bad_function_call"); }
void __throw_logic_error(const char *Message) { fail(Message); }
void __throw_domain_error(const char *Message) { fail(Message); }
void __throw_invalid_argument(const char *Message) { fail(Message); }
void __throw_length_error(const char *Message) { fail(Message); }
void __throw_out_of_range(const char *Message) { fail(Message); }
void __throw_runtime_error(const char *Message) { fail(Message); }
void __throw_range_error(const char *Message) { fail(Message); }
void __throw_overflow_error(const char *Message) { fail(Message); }
void __throw_underflow_error(const char *Message) { fail(Message); }
void __throw_ios_failure(const char *Message) { fail(Message); }
void __throw_system_error(int) { fail("std::system_error"); }
void __throw_future_error(int) { fail("std::future_error"); }
void __throw_out_of_range_fmt(const char *Message, ...) { fail(Message); }
void __glibcxx_assert_fail(const char *, int, const char *,
                           const char *Condition) noexcept {
  fail(Condition);
}

exception::~exception() noexcept = default;
const char *exception::what() const noexcept { return "std::exception"; }

/// Without type information every deleter is some other type.
bool _Sp_make_shared_tag::_S_eq(const type_info &) noexcept { return false; }

} // namespace std
