//===- ReplayMoves.h - What all replays do alike ----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_REPLAY_REPLAYMOVES_H
#define TP_SIMULATOR_REPLAY_REPLAYMOVES_H

#include "simulator/core/AddressSpace.h"
#include "simulator/replay/EventMatcher.h"
#include "simulator/replay/GlobalHistory.h"
#include "simulator/replay/Replay.h"

namespace tp {

/// Finds events in both directions, reads and changes, on a machine that can go
/// to any moment and run from there.
class ReplayMoves : public Replay {
public:
  Moment now() const override { return Now; }
  uint32_t threadCount() const override { return Chip.threadCount(); }
  bool read(uint32_t Number, uint32_t Address,
            std::span<uint8_t> Bytes) const override;

  ReplayStop forward(const Events &Wanted) override;
  ReplayStop backward(const Events &Wanted) override;
  ReplayStop goTo(Moment Target) override;
  void visit(Moment There, const std::function<void()> &Function) override;

  bool write(uint32_t Number, uint32_t Address,
             std::span<const uint8_t> Bytes) override;
  bool setPc(uint32_t Number, uint32_t Pc) override;

  LastWrite lastWrite(uint32_t Number, uint32_t Address,
                      uint32_t Bytes) override;

protected:
  /// The first or last event of a run, and how the run ended.
  struct SearchResult {
    std::optional<FoundEvent> Found;
    RunResult Run;
  };
  static constexpr uint64_t NoLimit = ~uint64_t(0);

  ReplayMoves(const ChipConfig &Chip, const Program &Text, Memory &Global)
      : Chip(Chip), Text(Text), Space(Chip, Text, Global) {}

  /// Runs from the time \p From, or somewhat before, until the matcher's event
  /// has been found, at most to \p Limit. Leaves the machine anywhere.
  virtual SearchResult search(const EventMatcher &Matcher, uint64_t From,
                              uint64_t Limit) = 0;
  /// Sets Now; not Seen. If the run ends before, the stop there.
  virtual std::optional<ReplayStop> moveTo(Moment Target) = 0;
  /// The stop at the end of a run that came to no event. Sets Now and Seen.
  virtual ReplayStop endOf(const RunResult &Result) = 0;
  /// The time of the last checkpoint before \p Time; 0 if there is none.
  virtual uint64_t pointBefore(uint64_t Time) const = 0;
  /// The time of the first event that may come behind \p Place.
  virtual uint64_t nextTime(EventPlace Place) const = 0;
  /// When a thread does something at a time.
  virtual Moment momentOf(uint64_t Time, uint32_t Thread) const = 0;
  virtual uintptr_t localStoreBias(uint32_t Number) const = 0;
  virtual GlobalHistory &history() = 0;
  /// Lets \p Function change the machine or the memory now, and forgets what
  /// was known of later moments.
  virtual void changeMachine(const std::function<void()> &Function) = 0;
  virtual void setNextWord(uint32_t Number, uint32_t Word) = 0;

  void change(const std::function<void()> &Function);

  const ChipConfig Chip;
  const Program &Text;
  const AddressSpace Space;
  Moment Now;
  /// Events up to this one have been seen.
  EventPlace Seen;

private:
  uint8_t *host(uint32_t Number, uint32_t Address, uint64_t Bytes) const;
  /// The stop for an event; nothing if it turns out not to be wanted.
  std::optional<ReplayStop> stopAt(const FoundEvent &Found,
                                   const Events &Wanted, bool IsForward);
  /// Likewise for an access, before which the machine is.
  std::optional<ReplayStop> stopAtAccess(ReplayStop Stop, FoundEvent Found,
                                         const AccessEvents &Event,
                                         bool IsForward);
  std::vector<uint8_t> watchedBytes(const AccessEvents &Event) const;
  /// Goes behind a found access; if the run ends before, the stop there. Finds
  /// out of a stream operation whether it read and wrote bytes of the event.
  std::optional<ReplayStop> moveBehind(FoundEvent &Found,
                                       const AccessEvents &Event);
  /// The last event before \p Before.
  SearchResult findLast(const Events &Wanted, EventPlace Before);
  /// The last write of the program; nothing if the history does not know it.
  std::optional<LastWrite> knownWrite(uint32_t Address, uint32_t Bytes);
  /// Likewise, by going back.
  LastWrite searchWrite(uint32_t Number, uint32_t Address, uint32_t Bytes);
  /// The time of the user's last write that is in memory now.
  std::optional<uint64_t> userWrite(uint32_t Number, uint32_t Address,
                                    uint32_t Bytes) const;

  /// Bytes that the user wrote, in the local store of Thread if they are there.
  struct UserWrite {
    uint64_t Time = 0;
    uint32_t Thread = 0;
    uint32_t Address = 0;
    uint32_t Bytes = 0;
  };
  /// In the order of their times.
  std::vector<UserWrite> UserWrites;
};

} // namespace tp

#endif // TP_SIMULATOR_REPLAY_REPLAYMOVES_H
