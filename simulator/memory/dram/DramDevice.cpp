//===- DramDevice.cpp - Banks of a channel and their timing --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/memory/dram/DramDevice.h"

using namespace tp;

using Kind = DramCommandKind;

DramDevice::DramDevice(const DramConfig &Config)
    : Config(Config), Banks(Config.BankGroups * Config.BanksPerGroup),
      Groups(Config.BankGroups) {
  for (uint32_t Bank = 0; Bank < banks(); ++Bank)
    Banks[Bank].Group = Bank / Config.BanksPerGroup;
}

uint64_t DramDevice::earliestPrechargeAll() const {
  uint64_t Tick = 0;
  for (const BankState &Bank : Banks)
    if (Bank.OpenRow != NoRow)
      Tick = std::max(Tick, Bank[Kind::Precharge]);
  return Tick;
}

uint64_t DramDevice::earliestRefresh() const {
  uint64_t Tick = 0;
  for (const BankState &Bank : Banks)
    Tick = std::max(Tick, Bank[Kind::Activate]);
  return Tick;
}

bool DramDevice::hasOpenRow() const {
  return std::any_of(Banks.begin(), Banks.end(), [](const BankState &Bank) {
    return Bank.OpenRow != NoRow;
  });
}

void DramDevice::activate(uint64_t Tick, uint32_t Bank, uint32_t Row) {
  BankState &State = Banks[Bank];
  State.OpenRow = Row;
  State.delay(Kind::Read, Tick + Config.RcdReadTicks);
  State.delay(Kind::Write, Tick + Config.RcdWriteTicks);
  State.delay(Kind::Precharge, Tick + Config.RasTicks);
  groupOf(Bank).delay(Kind::Activate, Tick + Config.RrdLongTicks);
  Channel.delay(Kind::Activate, Tick + Config.RrdShortTicks);
  FourActivates[NextActivate] = Tick + Config.FawTicks;
  NextActivate = (NextActivate + 1) % FourActivates.size();
  Channel.delay(Kind::Activate, FourActivates[NextActivate]);
}

void DramDevice::precharge(uint64_t Tick, uint32_t Bank) {
  Banks[Bank].OpenRow = NoRow;
  Banks[Bank].delay(Kind::Activate, Tick + Config.RpTicks);
}

void DramDevice::prechargeAll(uint64_t Tick) {
  for (uint32_t Bank = 0; Bank < banks(); ++Bank)
    if (Banks[Bank].OpenRow != NoRow)
      precharge(Tick, Bank);
}

void DramDevice::read(uint64_t Tick, uint32_t Bank) {
  Banks[Bank].delay(Kind::Precharge, Tick + Config.RtpTicks);
  groupOf(Bank).delay(Kind::Read, Tick + Config.CcdLongTicks);
  Channel.delay(Kind::Read, Tick + Config.CcdShortTicks);
  Channel.delay(Kind::Write, Tick + Config.RtwTicks);
}

void DramDevice::write(uint64_t Tick, uint32_t Bank) {
  uint64_t DataEnd = Tick + Config.CwlTicks + Config.BurstTicks;
  Banks[Bank].delay(Kind::Precharge, DataEnd + Config.WrTicks);
  groupOf(Bank).delay(Kind::Write, Tick + Config.CcdLongTicks);
  groupOf(Bank).delay(Kind::Read, DataEnd + Config.WtrLongTicks);
  Channel.delay(Kind::Write, Tick + Config.CcdShortTicks);
  Channel.delay(Kind::Read, DataEnd + Config.WtrShortTicks);
}

void DramDevice::refresh(uint64_t Tick) {
  for (BankState &Bank : Banks)
    Bank.delay(Kind::Activate, Tick + Config.RfcTicks);
}

void DramDevice::serialize(Archive &A) {
  A(Banks);
  A(Groups);
  A(Channel);
  A(FourActivates);
  A(NextActivate);
}
