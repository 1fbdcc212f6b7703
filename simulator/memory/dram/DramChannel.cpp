//===- DramChannel.cpp - A channel of DRAM and its controller ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/memory/dram/DramChannel.h"

#include <algorithm>
#include <bit>
#include <cassert>

using namespace tp;

static constexpr uint64_t Never = ~uint64_t(0);

uint64_t tp::minimumDramReadCycles(const DramConfig &Config, uint64_t ChipKHz) {
  return DramClock(Config.ClockKHz, ChipKHz)
             .cycleAtOrAfter(Config.ClTicks + Config.BurstTicks) +
         Config.ControllerCycles;
}

uint64_t tp::minimumDramWriteCycles(const DramConfig &Config) {
  return Config.ControllerCycles;
}

DramChannel::DramChannel(const DramConfig &Config, uint64_t ChipKHz)
    : Config(Config), Clock(Config.ClockKHz, ChipKHz), Mapping(Config),
      Device(Config), NextRefresh(Config.RefiTicks ? Config.RefiTicks : Never),
      Reads(DramCommandKind::Read, Device.banks(), Config.RowHitLimit),
      Writes(DramCommandKind::Write, Device.banks(), Config.RowHitLimit) {}

void DramChannel::enqueue(const DramRequest &Request) {
  uint64_t ArrivalTick = Clock.tickAtOrAfter(Request.Cycle);
  assert(ArrivalTick >= Tick && "request for a tick that has been decided");
  assert((Arrivals.empty() || Arrivals.back().Tick <= ArrivalTick) &&
         "requests out of order");
  NextReady = std::min(NextReady, ArrivalTick);
  Arrivals.push_back({ArrivalTick, Request});
}

void DramChannel::advance(uint64_t Horizon, std::vector<DramAnswer> &Answers) {
  uint64_t End = Clock.tickAtOrAfter(Horizon);
  while (Tick < End) {
    admitArrivals(Answers);
    if (turns()) {
      Writing = !Writing;
      BurstsOfPhase = 0;
      Counts.WriteDrains += Writing;
    }
    uint64_t Bursts = BurstsOfPhase;
    NextReady = Tick >= NextRefresh ? refreshStep() : schedule(Answers);
    bool HasLeft = BurstsOfPhase != Bursts;
    if (!Arrivals.empty() && (Arrivals.front().Tick > Tick || HasLeft))
      NextReady =
          std::min(NextReady, std::max(Arrivals.front().Tick, Tick + 1));
    if (HasLeft && turns())
      NextReady = Tick + 1;
    moveTo(std::min(NextReady, End));
  }
}

uint64_t DramChannel::nextEvent() const {
  return hasRequests() ? Clock.cycleAtOrBefore(std::max(NextReady, Tick))
                       : Never;
}

DramChannelStatistics DramChannel::statistics(uint64_t Cycle) const {
  DramChannel Copy(*this);
  Copy.Observer = nullptr;
  std::vector<DramAnswer> Answers;
  Copy.advance(Cycle, Answers);
  Copy.Counts.Ticks = Copy.Tick;
  Copy.Counts.Pending =
      Copy.Arrivals.size() + Copy.Reads.size() + Copy.Writes.size();
  return Copy.Counts;
}

void DramChannel::admitArrivals(std::vector<DramAnswer> &Answers) {
  while (!Arrivals.empty() && Arrivals.front().Tick <= Tick &&
         admit(Arrivals.front().Request, Answers))
    Arrivals.pop_front();
}

/// Whether there was room for it.
bool DramChannel::admit(const DramRequest &Request,
                        std::vector<DramAnswer> &Answers) {
  DramLocation Place = Mapping.locate(Request.Address);
  bool InWriteQueue = Writes.contains(Place.Bank, Place.Row, Place.Column);
  DramQueueEntry Entry{
      NextAge, Request.Cycle, Request.Tag, Place.Row, Place.Column, 0, 0};
  uint32_t OpenRow = Device.openRow(Place.Bank);
  if (Request.IsWrite) {
    if (InWriteQueue)
      ++Counts.MergedWrites;
    else if (Writes.size() == Config.WriteQueueEntries)
      return false;
    else
      Writes.add(Entry, Place.Bank, OpenRow);
    Answers.push_back({Clock.cycleAtOrAfter(Tick) + Config.ControllerCycles,
                       Request.Tag, true, ServedBy::DramQueue});
    Counts.MaxWriteQueue = std::max(Counts.MaxWriteQueue, Writes.size());
  } else {
    if (InWriteQueue) {
      ++Counts.ForwardedReads;
      answerRead(Request.Cycle, Request.Tag, ServedBy::DramQueue, Answers);
    } else if (Reads.size() == Config.ReadQueueEntries) {
      return false;
    } else {
      Reads.add(Entry, Place.Bank, OpenRow);
    }
    Counts.MaxReadQueue = std::max(Counts.MaxReadQueue, Reads.size());
  }
  ++NextAge;
  return true;
}

bool DramChannel::turns() const {
  uint64_t Turn = Config.WriteHighMark - Config.WriteLowMark;
  if (Writing)
    return Writes.empty() ||
           (!Reads.empty() &&
            (Writes.size() <= Config.WriteLowMark || BurstsOfPhase >= Turn));
  return !Writes.empty() &&
         (Reads.empty() ||
          (Writes.size() >= Config.WriteHighMark && BurstsOfPhase >= Turn));
}

uint64_t DramChannel::refreshStep() {
  if (Device.hasOpenRow()) {
    uint64_t Earliest = Device.earliestPrechargeAll();
    if (Tick < Earliest)
      return Earliest;
    note(DramCommandKind::PrechargeAll);
    for (uint32_t Bank = 0; Bank < Device.banks(); ++Bank)
      Counts.Precharges += Device.openRow(Bank) != DramDevice::NoRow;
    Device.prechargeAll(Tick);
    for (uint32_t Bank = 0; Bank < Device.banks(); ++Bank) {
      Reads.rowChanged(Bank, DramDevice::NoRow);
      Writes.rowChanged(Bank, DramDevice::NoRow);
    }
    return Tick + 1;
  }
  uint64_t Earliest = Device.earliestRefresh();
  if (Tick < Earliest)
    return Earliest;
  note(DramCommandKind::Refresh);
  Device.refresh(Tick);
  NextRefresh += Config.RefiTicks;
  ++Counts.Refreshes;
  Counts.RefreshTicks += Config.RfcTicks;
  return Tick + 1;
}

uint64_t DramChannel::earliest(uint32_t Bank) const {
  return queue().wants(Bank)
             ? Device.earliest(queue().candidate(Bank).Wants, Bank)
             : Never;
}

uint64_t DramChannel::schedule(std::vector<DramAnswer> &Answers) {
  struct {
    uint64_t Age = Never;
    uint32_t Bank = 0;
  } Column, Row;
  uint64_t Next = NextRefresh;
  unsigned Ready = 0;
  for (uint64_t Banks = queue().wantingBanks(); Banks; Banks &= Banks - 1) {
    uint32_t Bank = std::countr_zero(Banks);
    const DramQueue::Candidate &Candidate = queue().candidate(Bank);
    uint64_t Earliest = Device.earliest(Candidate.Wants, Bank);
    if (Earliest > Tick) {
      Next = std::min(Next, Earliest);
      continue;
    }
    ++Ready;
    auto &Best = isColumnCommand(Candidate.Wants) ? Column : Row;
    if (Candidate.Age < Best.Age)
      Best = {Candidate.Age, Bank};
  }
  // Commands only make others later, but those of their own bank.
  bool HasColumn = Column.Age != Never;
  if (HasColumn) {
    issueColumn(Column.Bank, Answers);
    Next = std::min(Next, earliest(Column.Bank));
    --Ready;
  }
  if (Row.Age != Never && (!HasColumn || Config.CommandBuses == 2)) {
    issueRow(Row.Bank);
    Next = std::min(Next, earliest(Row.Bank));
    --Ready;
  }
  return Ready != 0 ? Tick + 1 : std::max(Next, Tick + 1);
}

void DramChannel::issueColumn(uint32_t Bank, std::vector<DramAnswer> &Answers) {
  note(Writing ? DramCommandKind::Write : DramCommandKind::Read, Bank);
  DramQueueEntry Entry = queue().take(Bank, Device.openRow(Bank));
  ServedBy Level = Entry.Precharges  ? ServedBy::DramRowConflict
                   : Entry.Activates ? ServedBy::DramRowMiss
                                     : ServedBy::DramRowHit;
  if (Writing) {
    Device.write(Tick, Bank);
    ++Counts.Writes;
  } else {
    Device.read(Tick, Bank);
    ++Counts.Reads;
    answerRead(Entry.ArrivalCycle, Entry.Tag, Level, Answers);
  }
  ++BurstsOfPhase;
  Counts.BusBusyTicks += Config.BurstTicks;
  ++(Level == ServedBy::DramRowConflict ? Counts.RowConflicts
     : Level == ServedBy::DramRowMiss   ? Counts.RowMisses
                                        : Counts.RowHits);
}

void DramChannel::issueRow(uint32_t Bank) {
  DramQueue &Other = Writing ? Reads : Writes;
  const DramQueue::Candidate &Candidate = queue().candidate(Bank);
  if (Candidate.Wants == DramCommandKind::Activate) {
    uint32_t Row = queue().oldest(Bank).Row;
    note(DramCommandKind::Activate, Bank, Row);
    Device.activate(Tick, Bank, Row);
    queue().noteActivate(Bank, Row);
    Other.rowChanged(Bank, Row);
    ++Counts.Activates;
  } else {
    note(DramCommandKind::Precharge, Bank);
    Device.precharge(Tick, Bank);
    queue().notePrecharge(Bank);
    Other.rowChanged(Bank, DramDevice::NoRow);
    ++Counts.Precharges;
  }
}

void DramChannel::answerRead(uint64_t ArrivalCycle, uint64_t Tag,
                             ServedBy Level, std::vector<DramAnswer> &Answers) {
  uint64_t DataEnd = Tick + Config.ClTicks + Config.BurstTicks;
  uint64_t Ready = Clock.cycleAtOrAfter(DataEnd) + Config.ControllerCycles;
  uint64_t Latency = Ready - ArrivalCycle;
  Counts.ReadLatencySum += Latency;
  ++Counts.ReadLatency[std::min<size_t>(std::bit_width(Latency),
                                        Counts.ReadLatency.size() - 1)];
  Answers.push_back({Ready, Tag, false, Level});
}

void DramChannel::moveTo(uint64_t NewTick) {
  Counts.ReadQueueTicks += (NewTick - Tick) * Reads.size();
  Counts.WriteQueueTicks += (NewTick - Tick) * Writes.size();
  Tick = NewTick;
}

void DramChannel::note(DramCommandKind Kind, uint32_t Bank, uint32_t Row) {
  if (Observer)
    Observer({Tick, Kind, Bank, Row});
}

void DramChannel::serialize(Archive &A) {
  A(Device);
  A(Tick);
  A(NextReady);
  A(NextRefresh);
  A(NextAge);
  A(BurstsOfPhase);
  A(Writing);
  A(Arrivals);
  A(Reads);
  A(Writes);
  A(Counts);
}
