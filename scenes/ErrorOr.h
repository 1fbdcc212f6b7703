//===- ErrorOr.h - A value or the message why there is none -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SCENES_ERROROR_H
#define TP_SCENES_ERROROR_H

#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace tp {

/// Why something failed, in words for the user: which file, which element of
/// it, what is wrong. Without a trailing full stop or line end.
struct Error {
  std::string Message;
};

/// The result of a function that may fail.
template <typename T> class [[nodiscard]] ErrorOr {
public:
  ErrorOr(T Value) : State(std::in_place_index<0>, std::move(Value)) {}
  ErrorOr(Error Failure) : State(std::in_place_index<1>, std::move(Failure)) {}

  /// Whether there is a value.
  explicit operator bool() const { return State.index() == 0; }

  /// The value; only if there is one.
  T &operator*() {
    assert(*this && "the value of a failure");
    return *std::get_if<0>(&State);
  }
  const T &operator*() const {
    assert(*this && "the value of a failure");
    return *std::get_if<0>(&State);
  }
  T *operator->() { return &**this; }
  const T *operator->() const { return &**this; }

  /// The message of the failure; only if there is no value.
  const std::string &message() const {
    assert(!*this && "the message of a success");
    return std::get_if<1>(&State)->Message;
  }
  Error takeError() {
    assert(!*this && "the error of a success");
    return std::move(*std::get_if<1>(&State));
  }

private:
  std::variant<T, Error> State;
};

/// The result of a function that has nothing to return but may fail.
using Status = ErrorOr<std::monostate>;

/// A Status that says that all is well.
inline Status success() { return std::monostate(); }

} // namespace tp

#endif // TP_SCENES_ERROROR_H
