//===- TimeQueue.h - What arrives, in the order of time ---------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_MEMORY_TIMEQUEUE_H
#define TP_SIMULATOR_MEMORY_TIMEQUEUE_H

#include "simulator/core/Archive.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tp {

/// No cycle at all, later than any.
inline constexpr uint64_t NoCycle = ~uint64_t(0);

/// A queue of \p T, which has a member Cycle, in the order of \p Before.
/// Entries are added in batches and in any order.
template <class T, class Before> class TimeQueue {
public:
  void add(const T &Entry) { Added.push_back(Entry); }

  /// Puts what was added since the last call into its place.
  void settle() {
    if (Added.empty())
      return;
    sortAdded();
    if (Head == Sorted.size()) {
      Sorted.swap(Added);
      Head = 0;
    } else {
      mergeAdded();
    }
    Added.clear();
  }

  /// Entries, settled or not.
  size_t size() const { return Added.size() + Sorted.size() - Head; }
  /// Of the first settled entry; NoCycle if there is none.
  uint64_t nextCycle() const {
    return Head == Sorted.size() ? NoCycle : Sorted[Head].Cycle;
  }
  const T &front() const { return Sorted[Head]; }
  /// All settled entries.
  std::span<const T> entries() const {
    return std::span<const T>(Sorted).subspan(Head);
  }
  void pop(size_t Count = 1) { Head += Count; }

  /// Brings what the next calls write into the host's cache.
  void prefetch() const {
    for (const std::vector<T> *Buffer : {&Sorted, &Added})
      for (uintptr_t Offset = 0; Offset != 256; Offset += 64)
        __builtin_prefetch(
            reinterpret_cast<const void *>(uintptr_t(Buffer->data()) + Offset),
            1);
  }

  void serialize(Archive &A) {
    settle();
    Sorted.erase(Sorted.begin(), Sorted.begin() + ptrdiff_t(Head));
    Head = 0;
    A(Sorted);
  }

private:
  static constexpr uint64_t MaxSpan = 256;

  /// Entries come from a few cycles: they are counted by cycle and put into
  /// their places; only those of one cycle are then compared.
  void sortAdded() {
    if (std::is_sorted(Added.begin(), Added.end(), Before()))
      return;
    auto [Least, Most] = std::ranges::minmax_element(Added, {}, &T::Cycle);
    uint64_t First = Least->Cycle;
    uint64_t Span = Most->Cycle - First + 1;
    if (Added.size() < 12 || Span > MaxSpan) {
      std::sort(Added.begin(), Added.end(), Before());
      return;
    }
    std::array<uint32_t, MaxSpan + 1> Places;
    std::fill_n(Places.begin(), Span + 1, 0);
    for (const T &Entry : Added)
      ++Places[Entry.Cycle - First + 1];
    for (uint64_t I = 1; I != Span; ++I)
      Places[I] += Places[I - 1];
    size_t Count = Added.size();
    if (Scratch.size() < Count)
      Scratch.resize(Count);
    for (const T &Entry : Added)
      Scratch[Places[Entry.Cycle - First]++] = Entry;
    Added.swap(Scratch);
    Added.resize(Count);
    // Places[I] is now the end of the I-th cycle.
    for (uint64_t I = 0, Begin = 0; I != Span; Begin = Places[I++])
      if (Places[I] - Begin > 1)
        std::sort(Added.begin() + ptrdiff_t(Begin),
                  Added.begin() + ptrdiff_t(Places[I]), Before());
  }

  void mergeAdded() {
    Sorted.erase(Sorted.begin(), Sorted.begin() + ptrdiff_t(Head));
    Head = 0;
    size_t Old = Sorted.size(), New = Added.size();
    Sorted.resize(Old + New);
    // From the back, so that nothing is overwritten that is still to move.
    for (size_t To = Old + New; New != 0; --To)
      if (Old != 0 && Before()(Added[New - 1], Sorted[Old - 1]))
        Sorted[To - 1] = Sorted[--Old];
      else
        Sorted[To - 1] = Added[--New];
  }

  std::vector<T> Sorted;
  size_t Head = 0;
  std::vector<T> Added;
  std::vector<T> Scratch;
};

} // namespace tp

#endif // TP_SIMULATOR_MEMORY_TIMEQUEUE_H
