//===- EventMatcher.h - Whether an instruction is an event ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_REPLAY_EVENTMATCHER_H
#define TP_SIMULATOR_REPLAY_EVENTMATCHER_H

#include "simulator/chip/ChipConfig.h"
#include "simulator/core/Program.h"
#include "simulator/isa/Access.h"
#include "simulator/replay/Events.h"

#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

namespace tp {

/// The first word from \p Word on that takes time: threads pass over the
/// others.
uint32_t nextTimedWord(const Program &Text, uint32_t Word);

/// Where an event stands among all: an access comes behind the instruction that
/// makes it.
struct EventPlace {
  Moment At;
  bool IsAccess = false;

  auto operator<=>(const EventPlace &) const = default;
};

/// An event that a machine came to.
struct FoundEvent {
  ReplayStop::StopKind Kind = ReplayStop::Instruction;
  /// Before its instruction.
  Moment At;
  EventPlace place() const { return {At, Kind == ReplayStop::Access}; }
  uint32_t Thread = 0;
  uint32_t Pc = 0;
  size_t Event = 0;
  /// Of a stream operation the whole stream: it may have been another word.
  MemoryAccess Access;
};

/// Whether the bytes [Address, Address + Bytes) have some of the event's.
inline bool overlaps(const AccessEvents &Event, uint32_t Address,
                     uint32_t Bytes) {
  return Address < uint64_t(Event.Address) + Event.Bytes &&
         Event.Address < uint64_t(Address) + Bytes;
}

/// The wanted events of a text.
class EventMatcher {
public:
  /// Which of the events that happen is looked for.
  enum Which { First, Last };

  /// Events behind \p After and before \p Before. Everything must outlive it.
  EventMatcher(const ChipConfig &Chip, const Program &Text,
               const Events &Wanted, Which Kept,
               std::optional<EventPlace> After,
               std::optional<EventPlace> Before);

  /// Which words of the text may be events.
  const std::vector<bool> &words() const { return Words; }
  Which kept() const { return Kept; }
  /// Whether an event at this moment may count.
  bool mayMatch(Moment At) const {
    return isWanted({At, false}) || isWanted({At, true});
  }
  /// The event that it is.
  std::optional<FoundEvent> match(const Probe &Place) const;

private:
  bool isWanted(EventPlace Place) const {
    return (!After || Place > *After) && (!Before || Place < *Before);
  }
  std::optional<FoundEvent> findInstruction(const Probe &Place) const;
  std::optional<FoundEvent> findAccess(const Probe &Place) const;
  bool isIn(const AccessEvents &Event, const MemoryAccess &Access,
            uint32_t Thread) const;

  const Program &Text;
  const Events &Wanted;
  const Which Kept;
  const std::optional<EventPlace> After;
  const std::optional<EventPlace> Before;
  const uint32_t LocalBegin;
  std::vector<bool> Words;
  /// Of each instruction event, its words; empty: all.
  std::vector<std::vector<bool>> WordsOf;
};

} // namespace tp

#endif // TP_SIMULATOR_REPLAY_EVENTMATCHER_H
