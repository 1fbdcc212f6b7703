//===- EventCollector.h - Finds events while an engine runs -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_REPLAY_EVENTCOLLECTOR_H
#define TP_SIMULATOR_REPLAY_EVENTCOLLECTOR_H

#include "simulator/chip/ChipConfig.h"
#include "simulator/core/EngineObservers.h"
#include "simulator/core/Program.h"
#include "simulator/replay/EventMatcher.h"

#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

namespace tp {

/// The place of a thread in the order of those that issue in a cycle.
uint32_t orderOf(const ChipConfig &Chip, uint64_t Cycle, uint32_t Thread);

/// Finds the first event behind a moment, or the last one before another.
class EventCollector final : public IssueObserver {
public:
  /// Everything must outlive it.
  EventCollector(const ChipConfig &Chip, const Program &Text,
                 const EventMatcher &Matcher)
      : Chip(Chip), Text(Text), Matcher(Matcher),
        Tentative(Chip.threadCount()) {}

  /// Which words of the text it must see.
  const std::vector<bool> &words() const { return Matcher.words(); }
  /// Sets \p Flag as soon as the first event may have been found.
  void setFlag(std::atomic<bool> *Flag) { StopFlag = Flag; }
  /// Whether the first event was found up to the end of a run.
  bool hasStopped() const {
    return Matcher.kept() == EventMatcher::First && found();
  }
  /// What was found up to the end of a run.
  std::optional<FoundEvent> found() const;

  void issuing(const Thread &T, uint32_t Word, uint64_t Cycle,
               const TmRunnerState &Runner) override;
  void postponed(const Thread &T) override;

private:
  /// Keeps \p Candidate if it is the better one.
  void keep(std::optional<FoundEvent> &Kept, const FoundEvent &Candidate) const;

  const ChipConfig &Chip;
  const Program &Text;
  const EventMatcher &Matcher;
  std::mutex Lock;
  /// Of each thread, what its last issue was, if an event.
  std::vector<std::optional<FoundEvent>> Tentative;
  std::optional<FoundEvent> Best;
  std::atomic<bool> *StopFlag = nullptr;
};

} // namespace tp

#endif // TP_SIMULATOR_REPLAY_EVENTCOLLECTOR_H
