//===- RequestLedger.h - Whose requests are under way -----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_REQUESTLEDGER_H
#define TP_SIMULATOR_CORE_REQUESTLEDGER_H

#include <cassert>
#include <cstdint>
#include <vector>

namespace tp {

/// The requests of a TM to its memory system that are unanswered, with the
/// instructions that made them.
class RequestLedger {
public:
  struct Entry {
    /// The TP and the ticket.
    uint64_t Key = NoKey;
    /// Cycle of issue.
    uint64_t Cycle = 0;
    /// Of the text.
    uint32_t Word = 0;
    uint32_t Address = 0;
  };

  RequestLedger() : Entries(16) {}

  void add(uint16_t Tp, uint32_t Ticket, uint64_t Cycle, uint32_t Word,
           uint32_t Address) {
    if (++Count * 2 > Entries.size())
      grow();
    insert({keyOf(Tp, Ticket), Cycle, Word, Address});
  }

  /// The request, which is answered now and must be there.
  Entry take(uint16_t Tp, uint32_t Ticket) {
    size_t Place = placeOf(keyOf(Tp, Ticket));
    assert(Entries[Place].Key != NoKey && "an answer without a request");
    Entry Result = Entries[Place];
    --Count;
    close(Place);
    return Result;
  }

private:
  static constexpr uint64_t NoKey = ~uint64_t(0);

  static uint64_t keyOf(uint16_t Tp, uint32_t Ticket) {
    return uint64_t(Tp) << 32 | Ticket;
  }
  size_t mask() const { return Entries.size() - 1; }
  size_t homeOf(uint64_t Key) const {
    return (Key * 0x9E3779B97F4A7C15 >> 40) & mask();
  }
  /// Where the key is, or a free place for it.
  size_t placeOf(uint64_t Key) const {
    size_t Place = homeOf(Key);
    while (Entries[Place].Key != Key && Entries[Place].Key != NoKey)
      Place = (Place + 1) & mask();
    return Place;
  }
  void insert(const Entry &New) { Entries[placeOf(New.Key)] = New; }

  void grow() {
    std::vector<Entry> Old(2 * Entries.size());
    Old.swap(Entries);
    for (const Entry &E : Old)
      if (E.Key != NoKey)
        insert(E);
  }

  /// Frees a place, and moves up those behind it that would not be found any
  /// more.
  void close(size_t Gap) {
    for (size_t Place = (Gap + 1) & mask(); Entries[Place].Key != NoKey;
         Place = (Place + 1) & mask()) {
      size_t Distance = (Place - homeOf(Entries[Place].Key)) & mask();
      if (Distance < ((Place - Gap) & mask()))
        continue;
      Entries[Gap] = Entries[Place];
      Gap = Place;
    }
    Entries[Gap] = Entry();
  }

  size_t Count = 0;
  std::vector<Entry> Entries;
};

} // namespace tp

#endif // TP_SIMULATOR_CORE_REQUESTLEDGER_H
