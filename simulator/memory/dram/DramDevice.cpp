//===- DramDevice.cpp - Banks of a channel and their timing --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/memory/dram/DramDevice.h"

using namespace tp;

static void delay(uint64_t &Earliest, uint64_t Tick) {
  Earliest = std::max(Earliest, Tick);
}

DramDevice::DramDevice(const DramConfig &Config)
    : Config(Config), Banks(Config.BankGroups * Config.BanksPerGroup),
      Groups(Config.BankGroups) {}

uint64_t DramDevice::earliestPrechargeAll() const {
  uint64_t Tick = 0;
  for (const BankState &Bank : Banks)
    if (Bank.OpenRow != NoRow)
      delay(Tick, Bank.Precharge);
  return Tick;
}

uint64_t DramDevice::earliestRefresh() const {
  uint64_t Tick = 0;
  for (const BankState &Bank : Banks)
    delay(Tick, Bank.Activate);
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
  delay(State.Read, Tick + Config.RcdReadTicks);
  delay(State.Write, Tick + Config.RcdWriteTicks);
  delay(State.Precharge, Tick + Config.RasTicks);
  delay(groupOf(Bank).Activate, Tick + Config.RrdLongTicks);
  delay(Channel.Activate, Tick + Config.RrdShortTicks);
  FourActivates[NextActivate] = Tick + Config.FawTicks;
  NextActivate = (NextActivate + 1) % FourActivates.size();
}

void DramDevice::precharge(uint64_t Tick, uint32_t Bank) {
  Banks[Bank].OpenRow = NoRow;
  delay(Banks[Bank].Activate, Tick + Config.RpTicks);
}

void DramDevice::prechargeAll(uint64_t Tick) {
  for (uint32_t Bank = 0; Bank < banks(); ++Bank)
    if (Banks[Bank].OpenRow != NoRow)
      precharge(Tick, Bank);
}

void DramDevice::read(uint64_t Tick, uint32_t Bank) {
  delay(Banks[Bank].Precharge, Tick + Config.RtpTicks);
  delay(groupOf(Bank).Read, Tick + Config.CcdLongTicks);
  delay(Channel.Read, Tick + Config.CcdShortTicks);
  delay(Channel.Write, Tick + Config.RtwTicks);
}

void DramDevice::write(uint64_t Tick, uint32_t Bank) {
  uint64_t DataEnd = Tick + Config.CwlTicks + Config.BurstTicks;
  delay(Banks[Bank].Precharge, DataEnd + Config.WrTicks);
  delay(groupOf(Bank).Write, Tick + Config.CcdLongTicks);
  delay(groupOf(Bank).Read, DataEnd + Config.WtrLongTicks);
  delay(Channel.Write, Tick + Config.CcdShortTicks);
  delay(Channel.Read, DataEnd + Config.WtrShortTicks);
}

void DramDevice::refresh(uint64_t Tick) {
  for (BankState &Bank : Banks)
    delay(Bank.Activate, Tick + Config.RfcTicks);
}

void DramDevice::serialize(Archive &A) {
  A(Banks);
  A(Groups);
  A(Channel);
  A(FourActivates);
  A(NextActivate);
}
