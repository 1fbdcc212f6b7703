//===- FunctionalReplay.cpp - Without timing, forward and backward --------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/replay/FunctionalReplay.h"

namespace tp {

FunctionalReplay::FunctionalReplay(const ChipConfig &Chip, const Program &Text,
                                   Memory &Global, ReplayOptions Request)
    : ReplayMoves(Chip, Text, Global),
      Time(this->Chip, Text, Global, std::move(Request)) {}

ReplayThread FunctionalReplay::thread(uint32_t Number) const {
  const FunctionalThread &T = Time.machine().thread(Number);
  ReplayThread Result;
  Result.Registers = T.Registers;
  Result.Pc = Text.textBegin() + T.NextWord * 4;
  Result.State = T.State;
  Result.Status = T.Status;
  Result.Instructions = T.TurnEnd;
  return Result;
}

void FunctionalReplay::setRegister(uint32_t Number, unsigned Register,
                                   uint32_t Value) {
  change([&] { Time.machine().setRegister(Number, Register, Value); });
}

FunctionalReplay::SearchResult
FunctionalReplay::search(const EventMatcher &Matcher, uint64_t From,
                         uint64_t Limit) {
  FunctionalCollector Collector(Matcher, Space);
  Time.setControl(StopFlag, Report);
  const RunResult Run = Time.search(Collector, From, Limit);
  return {Collector.found(), Run};
}

ReplayStop FunctionalReplay::endOf(const RunResult &Result) {
  ReplayStop Stop;
  Stop.ExitStatus = Result.ExitStatus;
  Stop.TrapInfo = Result.TrapInfo;
  if (const std::optional<Trap> &Info = Result.TrapInfo) {
    Stop.Thread = Info->Thread;
    Stop.Pc = Info->Pc;
  }
  Now = {Time.time(), 0};
  Seen = {Now, Result.End == RunResult::Halted};
  switch (Result.End) {
  case RunResult::Halted:
    Stop.Kind = ReplayStop::Halted;
    break;
  case RunResult::Trapped:
    Stop.Kind = ReplayStop::Trapped;
    break;
  case RunResult::Stopped:
    Stop.Kind = ReplayStop::Interrupted;
    break;
  case RunResult::CycleLimit:
  case RunResult::Paused:
    Stop.Kind = ReplayStop::CycleLimit;
    break;
  }
  // A machine that trapped is shown as it was before.
  Time.setControl(nullptr, Report);
  Time.goTo(Now.Time);
  Stop.At = Now;
  return Stop;
}

std::optional<ReplayStop> FunctionalReplay::moveTo(Moment Target) {
  Time.setControl(nullptr, Report);
  const RunResult Result = Time.goTo(Target.Time);
  if (Result.End == RunResult::Trapped || Time.time() != Target.Time)
    return endOf(Result);
  Now = {Target.Time, 0};
  return std::nullopt;
}

std::unique_ptr<Replay> makeFunctionalReplay(const ChipConfig &Chip,
                                             const Program &Text,
                                             Memory &Global,
                                             ReplayOptions Request,
                                             std::string &Error) {
  auto Result = std::make_unique<FunctionalReplay>(Chip, Text, Global,
                                                   std::move(Request));
  Error = Result->error();
  if (!Error.empty())
    return nullptr;
  return Result;
}

} // namespace tp
