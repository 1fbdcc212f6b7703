//===- Archive.h - State to and from a checkpoint ---------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// A class with state that a checkpoint holds has one function
//
//   void serialize(Archive &A) { A(First); A(Second); }
//
// that both saves and restores: what it names is written, or read over what is
// there, in the same order.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_ARCHIVE_H
#define TP_SIMULATOR_CORE_ARCHIVE_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace tp {

class Archive;

template <class T>
concept HasSerialize = requires(T &Value, Archive &A) { Value.serialize(A); };

/// Where state goes to or comes from.
class Archive {
public:
  virtual ~Archive() = default;
  /// Whether state is restored; else it is saved.
  virtual bool isRestoring() const = 0;
  /// Writes \p Bytes bytes, or reads over them; zeros are read once a
  /// checkpoint has ended too early, which it remembers as an error.
  virtual void bytes(void *Data, size_t Bytes) = 0;
  /// At most this many bytes can still be read; bounds the lengths of
  /// containers in a damaged checkpoint.
  virtual uint64_t remaining() const = 0;

  template <class T> void operator()(T &Value) {
    if constexpr (HasSerialize<T>) {
      Value.serialize(*this);
    } else {
      static_assert(std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>);
      bytes(&Value, sizeof(Value));
    }
  }

  template <class T, size_t N> void operator()(std::array<T, N> &Values) {
    if constexpr (std::is_trivially_copyable_v<T>)
      bytes(Values.data(), sizeof(T) * N);
    else
      for (T &Value : Values)
        (*this)(Value);
  }

  template <class T> void operator()(std::vector<T> &Values) {
    resize(Values);
    if constexpr (std::is_trivially_copyable_v<T> && !HasSerialize<T>)
      bytes(Values.data(), sizeof(T) * Values.size());
    else
      for (T &Value : Values)
        (*this)(Value);
  }

  void operator()(std::string &Text) {
    resize(Text);
    bytes(Text.data(), Text.size());
  }

  template <class T> void operator()(std::deque<T> &Values) {
    resize(Values);
    for (T &Value : Values)
      (*this)(Value);
  }

  template <class T> void operator()(std::optional<T> &Value) {
    bool Present = Value.has_value();
    (*this)(Present);
    if (!Present)
      Value.reset();
    else if (!Value)
      Value.emplace();
    if (Present)
      (*this)(*Value);
  }

private:
  template <class Container> void resize(Container &Values) {
    uint64_t Size = Values.size();
    (*this)(Size);
    Values.resize(isRestoring() && Size > remaining() ? 0 : Size);
  }
};

} // namespace tp

#endif // TP_SIMULATOR_CORE_ARCHIVE_H
