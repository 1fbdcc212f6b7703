//===- CycleReplay.h - A run with timing, forward and backward --*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_REPLAY_CYCLEREPLAY_H
#define TP_SIMULATOR_REPLAY_CYCLEREPLAY_H

#include "simulator/replay/ReplayMoves.h"
#include "simulator/replay/Timeline.h"

namespace tp {

/// See Replay.h and makeCycleReplay().
class CycleReplay final : public ReplayMoves {
public:
  CycleReplay(const ChipConfig &Chip, const Program &Text, Memory &Global,
              ReplayOptions Request);

  const std::string &error() const { return Time.error(); }

  ReplayThread thread(uint32_t Number) const override;
  void setRegister(uint32_t Number, unsigned Register, uint32_t Value) override;
  Statistics statistics() const override { return Time.engine().statistics(); }
  CheckpointUse checkpoints() const override { return Time.use(); }

private:
  SearchResult search(const EventMatcher &Matcher, uint64_t From,
                      uint64_t Limit) override;
  std::optional<ReplayStop> moveTo(Moment Target) override;
  ReplayStop endOf(const RunResult &Result) override;
  uint64_t pointBefore(uint64_t Cycle) const override {
    return Time.pointBefore(Cycle);
  }
  uint64_t nextTime(EventPlace Place) const override { return Place.At.Time; }
  Moment momentOf(uint64_t Cycle, uint32_t Thread) const override {
    return {Cycle, orderOf(Chip, Cycle, Thread)};
  }
  uintptr_t localStoreBias(uint32_t Number) const override {
    return Time.engine().thread(Number).LocalStoreBias;
  }
  GlobalHistory &history() override { return Time.history(); }
  void changeMachine(const std::function<void()> &Function) override {
    Time.change(Function);
  }
  void setNextWord(uint32_t Number, uint32_t Word) override {
    Time.engine().setNextWord(Number, Word);
  }

  ThreadTiming timing(uint32_t Number) const;
  std::vector<RequestUnderWay> underWay(const Thread &T) const;

  const uint64_t MaxCycles;
  Timeline Time;
};

} // namespace tp

#endif // TP_SIMULATOR_REPLAY_CYCLEREPLAY_H
