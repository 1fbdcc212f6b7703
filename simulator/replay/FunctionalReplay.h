//===- FunctionalReplay.h - Without timing, forward and back ----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_REPLAY_FUNCTIONALREPLAY_H
#define TP_SIMULATOR_REPLAY_FUNCTIONALREPLAY_H

#include "simulator/replay/FunctionalTimeline.h"
#include "simulator/replay/ReplayMoves.h"

namespace tp {

/// See Replay.h and makeFunctionalReplay().
class FunctionalReplay final : public ReplayMoves {
public:
  FunctionalReplay(const ChipConfig &Chip, const Program &Text, Memory &Global,
                   ReplayOptions Request);

  const std::string &error() const { return Time.error(); }

  ReplayThread thread(uint32_t Number) const override;
  void setRegister(uint32_t Number, unsigned Register, uint32_t Value) override;
  Statistics statistics() const override { return Time.machine().statistics(); }
  CheckpointUse checkpoints() const override { return Time.use(); }

private:
  SearchResult search(const EventMatcher &Matcher, uint64_t From,
                      uint64_t Limit) override;
  std::optional<ReplayStop> moveTo(Moment Target) override;
  ReplayStop endOf(const RunResult &Result) override;
  uint64_t pointBefore(uint64_t At) const override {
    return Time.pointBefore(At);
  }
  uint64_t nextTime(EventPlace Place) const override {
    return Place.At.Time + Place.IsAccess;
  }
  Moment momentOf(uint64_t At, uint32_t) const override { return {At, 0}; }
  uintptr_t localStoreBias(uint32_t Number) const override {
    return Time.machine().thread(Number).LocalStoreBias;
  }
  GlobalHistory &history() override { return Time.history(); }
  void changeMachine(const std::function<void()> &Function) override {
    Time.change(Function);
  }
  void setNextWord(uint32_t Number, uint32_t Word) override {
    Time.machine().setNextWord(Number, Word);
  }

  FunctionalTimeline Time;
};

} // namespace tp

#endif // TP_SIMULATOR_REPLAY_FUNCTIONALREPLAY_H
