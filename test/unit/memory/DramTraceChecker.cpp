//===- DramTraceChecker.cpp - DRAM commands against all timing rules -----===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/memory/DramTraceChecker.h"

#include <optional>

using namespace tp;

namespace {

using Kind = DramCommandKind;

class Checker {
public:
  Checker(const DramConfig &Config, const std::vector<DramCommand> &Commands)
      : Config(Config), Commands(Commands) {}

  std::vector<std::string> run() {
    for (Now = 0; Now < Commands.size(); ++Now) {
      checkState();
      checkBuses();
      checkPairs();
      checkFourActivates();
    }
    return std::move(Broken);
  }

private:
  const DramCommand &command() const { return Commands[Now]; }
  static bool isColumn(const DramCommand &C) {
    return C.Kind == Kind::Read || C.Kind == Kind::Write;
  }
  uint32_t groupOf(const DramCommand &C) const {
    return C.Bank / Config.BanksPerGroup;
  }

  void fail(const std::string &Rule) {
    Broken.push_back(Rule + " at tick " + std::to_string(command().Tick));
  }

  /// The row that the commands before leave open in \p Bank.
  std::optional<uint32_t> openRow(uint32_t Bank) const {
    for (size_t I = Now; I-- > 0;) {
      const DramCommand &C = Commands[I];
      if (C.Kind == Kind::PrechargeAll)
        return std::nullopt;
      if (C.Bank != Bank)
        continue;
      if (C.Kind == Kind::Activate)
        return C.Row;
      if (C.Kind == Kind::Precharge)
        return std::nullopt;
    }
    return std::nullopt;
  }

  void checkState() {
    const DramCommand &C = command();
    if (C.Kind == Kind::Activate && openRow(C.Bank))
      fail("activate of an open bank");
    if ((isColumn(C) || C.Kind == Kind::Precharge) && !openRow(C.Bank))
      fail("access or precharge of a closed bank");
    if (C.Kind == Kind::Refresh)
      for (uint32_t B = 0; B < Config.BankGroups * Config.BanksPerGroup; ++B)
        if (openRow(B))
          fail("refresh with an open row");
  }

  void checkBuses() {
    unsigned Others = 0;
    for (size_t I = Now; I-- > 0 && Commands[I].Tick == command().Tick;)
      Others += Config.CommandBuses == 1 ||
                isColumn(Commands[I]) == isColumn(command());
    if (Others != 0)
      fail("two commands on a bus");
    if (Now > 0 && Commands[Now - 1].Tick > command().Tick)
      fail("command out of order");
  }

  /// Ticks that must be between \p First and the command at hand.
  uint64_t distance(const DramCommand &First) const {
    const DramCommand &Next = command();
    bool SameBank = First.Bank == Next.Bank;
    bool SameGroup = groupOf(First) == groupOf(Next);
    switch (Next.Kind) {
    case Kind::Activate:
      if (First.Kind == Kind::Refresh)
        return Config.RfcTicks;
      if (First.Kind == Kind::PrechargeAll)
        return Config.RpTicks;
      if (First.Kind == Kind::Precharge)
        return SameBank ? Config.RpTicks : 0;
      if (First.Kind == Kind::Activate)
        return SameBank    ? Config.RasTicks + Config.RpTicks
               : SameGroup ? Config.RrdLongTicks
                           : Config.RrdShortTicks;
      return 0;
    case Kind::PrechargeAll:
    case Kind::Precharge:
      if (Next.Kind == Kind::Precharge && !SameBank)
        return 0;
      if (First.Kind == Kind::Activate)
        return Config.RasTicks;
      if (First.Kind == Kind::Read)
        return Config.RtpTicks;
      if (First.Kind == Kind::Write)
        return Config.CwlTicks + Config.BurstTicks + Config.WrTicks;
      return 0;
    case Kind::Refresh:
      if (First.Kind == Kind::Precharge || First.Kind == Kind::PrechargeAll)
        return Config.RpTicks;
      return First.Kind == Kind::Refresh ? Config.RfcTicks : 0;
    case Kind::Read:
    case Kind::Write:
      break;
    }
    if (First.Kind == Kind::Activate)
      return !SameBank                 ? 0
             : Next.Kind == Kind::Read ? Config.RcdReadTicks
                                       : Config.RcdWriteTicks;
    if (First.Kind == Next.Kind)
      return SameGroup ? Config.CcdLongTicks : Config.CcdShortTicks;
    if (First.Kind == Kind::Read)
      return Config.RtwTicks;
    if (First.Kind == Kind::Write)
      return Config.CwlTicks + Config.BurstTicks +
             (SameGroup ? Config.WtrLongTicks : Config.WtrShortTicks);
    return 0;
  }

  void checkPairs() {
    constexpr uint64_t LongestRule = 400;
    for (size_t I = Now; I-- > 0;) {
      uint64_t Apart = command().Tick - Commands[I].Tick;
      if (Apart >= LongestRule)
        break;
      if (Apart < distance(Commands[I]))
        fail("command kind " + std::to_string(unsigned(command().Kind)) +
             " too soon after kind " +
             std::to_string(unsigned(Commands[I].Kind)));
    }
  }

  void checkFourActivates() {
    if (command().Kind != Kind::Activate)
      return;
    unsigned Activates = 1;
    for (size_t I = Now;
         I-- > 0 && command().Tick - Commands[I].Tick < Config.FawTicks;)
      Activates += Commands[I].Kind == Kind::Activate;
    if (Activates > 4)
      fail("five activates within tFAW");
  }

  const DramConfig &Config;
  const std::vector<DramCommand> &Commands;
  size_t Now = 0;
  std::vector<std::string> Broken;
};

} // namespace

std::vector<std::string>
tp::brokenRules(const DramConfig &Config,
                const std::vector<DramCommand> &Commands) {
  return Checker(Config, Commands).run();
}
