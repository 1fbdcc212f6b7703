//===- NaiveMemory.cpp - The rules of memory, literally -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/memory/NaiveMemory.h"

#include "simulator/memory/dram/DramClock.h"

#include <algorithm>
#include <memory>

namespace tp::test {

NaiveMemory::NaiveMemory(const ChipConfig &Chip) : Chip(Chip) {
  uint32_t L2Count =
      Chip.L2 ? (Chip.TmCount + Chip.TmsPerL2 - 1) / Chip.TmsPerL2 : 0;
  for (uint32_t Number = 0; Number != Chip.TmCount; ++Number) {
    Tm New;
    if (Chip.L1)
      New.L1.emplace(*Chip.L1, ServedBy::L1,
                     [this, Number](uint64_t Cycle, const NaiveAccess &Access) {
                       Departures.insert(
                           {{Cycle, Number, NextSequence++},
                            [=, this] { leaveTm(Number, Access); }});
                     });
    if (const std::optional<CrossbarConfig> &Crossbar = Chip.Crossbar) {
      New.Requests.emplace(Crossbar->RequestBytesPerCycle, Crossbar->Latency);
      New.Answers.emplace(Crossbar->AnswerBytesPerCycle, Crossbar->Latency);
    }
    Tms.push_back(std::move(New));
  }
  for (uint32_t Number = 0; Number != L2Count; ++Number)
    L2s.emplace_back(*Chip.L2, ServedBy::L2,
                     [this, Number](uint64_t Cycle, const NaiveAccess &Access) {
                       arriveMemory(Cycle, Access, Number);
                     });
  if (!Chip.Dram)
    return;
  Mapping.emplace(*Chip.Dram);
  for (uint32_t I = 0; I != Chip.Dram->Channels; ++I)
    Channels.emplace_back(*Chip.Dram, clockKHz(Chip.ClockGHz));
}

void NaiveMemory::runDue(Agenda &Agenda) {
  while (!Agenda.empty() && Agenda.begin()->first.Cycle == Now) {
    auto Action = std::move(Agenda.begin()->second);
    Agenda.erase(Agenda.begin());
    Action();
  }
}

void NaiveMemory::tick(std::vector<TmRequest> Issued) {
  std::sort(Issued.begin(), Issued.end(),
            [](const TmRequest &A, const TmRequest &B) {
              return std::pair(A.Tm, A.Request.Priority) <
                     std::pair(B.Tm, B.Request.Priority);
            });
  runDue(Returns);
  for (Tm &T : Tms)
    if (T.Answers)
      T.Answers->tick(Now);
  runDue(Deliveries);
  for (Tm &T : Tms)
    if (T.L1)
      T.L1->fillArrived(Now);
  for (const TmRequest &Request : Issued) {
    const MemoryRequest &R = Request.Request;
    uint32_t Ticket = R.Ticket;
    NaiveAccess Access{R.Kind, R.Address, R.Bytes,
                       [this, Ticket](uint64_t Cycle, ServedBy Level) {
                         Answered[Ticket] = {Cycle, Level};
                       },
                       Now};
    std::optional<NaiveCache> &L1 = Tms[Request.Tm].L1;
    if (L1 && R.Kind != RequestKind::Fetch)
      L1->arrive(Access);
    else
      Departures.insert(
          {{Now + (Chip.L1 ? Chip.L1->Latency : 0), Request.Tm, NextSequence++},
           [=, this] { leaveTm(Request.Tm, Access); }});
  }
  for (Tm &T : Tms)
    if (T.L1)
      T.L1->serve(Now);
  runDue(Departures);
  for (Tm &T : Tms)
    if (T.Requests)
      T.Requests->tick(Now);
  runDue(SharedArrivals);
  for (NaiveCache &L2 : L2s) {
    L2.fillArrived(Now);
    L2.serve(Now);
  }
  tickDram();
  ++Now;
}

void NaiveMemory::leaveTm(uint32_t Number, const NaiveAccess &Access) {
  uint64_t Sequence = NextSequence++;
  auto Arrive = [=, this](uint64_t Cycle) {
    SharedArrivals.insert({{Cycle, Number, Sequence},
                           [=, this] { arriveShared(Number, Cycle, Access); }});
  };
  bool HasData =
      Access.Kind == RequestKind::Store || Access.Kind == RequestKind::Atomic;
  if (Chip.Crossbar)
    Tms[Number].Requests->put(
        Now, Chip.Crossbar->HeaderBytes + (HasData ? Access.Bytes : 0), Arrive);
  else
    Arrive(Now);
}

void NaiveMemory::arriveShared(uint32_t Number, uint64_t Cycle,
                               const NaiveAccess &Access) {
  uint32_t Granule = Chip.L2     ? Chip.L2->SectorBytes
                     : Chip.Dram ? Chip.Dram->BurstBytes
                                 : 1 << 16;
  unsigned *Parts = &PartsLeft.emplace_back(0);
  auto Latest = std::make_shared<Outcome>();
  uint32_t End = Access.Address + Access.Bytes;
  for (uint32_t Begin = Access.Address; Begin != End;) {
    uint32_t PartEnd = std::min(End, (Begin / Granule + 1) * Granule);
    uint32_t Bytes = PartEnd - Begin;
    uint64_t Sequence = NextSequence++;
    ++*Parts;
    NaiveAccess Part{Access.Kind, Begin, Bytes, nullptr, Cycle};
    if (Access.Done)
      Part.Done = [=, this](uint64_t Departure, ServedBy Level) {
        auto Done = [=](uint64_t Arrival, ServedBy From) {
          *Latest = std::max(*Latest, {Arrival, From});
          if (--*Parts == 0)
            Access.Done(Latest->ReadyCycle, Latest->Level);
        };
        answerTm(Number, Departure, Sequence,
                 Access.Kind == RequestKind::Store ? 0 : Bytes, Done, Level);
      };
    if (Chip.L2) {
      L2s[Number / Chip.TmsPerL2].arrive(Part);
    } else {
      arriveMemory(Cycle, Part, Number);
      if (Access.Kind == RequestKind::Atomic && Chip.Dram)
        arriveMemory(Cycle, {RequestKind::Store, Begin, Bytes, nullptr},
                     Number);
    }
    Begin = PartEnd;
  }
}

void NaiveMemory::answerTm(uint32_t Number, uint64_t Cycle, uint64_t Sequence,
                           uint32_t Bytes, const NaiveAnswer &Done,
                           ServedBy Level) {
  auto Kept = std::make_shared<const NaiveAnswer>(Done);
  auto Deliver = [=, this](uint64_t Arrival) {
    Deliveries.insert(
        {{Arrival, Number, NextSequence++}, [=] { (*Kept)(Arrival, Level); }});
  };
  std::function<void()> Return = [=, this] {
    if (Chip.Crossbar)
      Tms[Number].Answers->put(Now, Bytes, Deliver);
    else
      Deliver(Now);
  };
  Returns.emplace(Key{Cycle, Number, Sequence}, Return);
}

void NaiveMemory::arriveMemory(uint64_t Cycle, const NaiveAccess &Access,
                               uint32_t Source) {
  if (!Chip.Dram) {
    if (Access.Done)
      Access.Done(Cycle + Chip.MemoryLatency, ServedBy::Memory);
    return;
  }
  uint32_t Burst = Chip.Dram->BurstBytes;
  bool IsWrite = Access.Kind == RequestKind::Store;
  uint64_t ChipKHz = clockKHz(Chip.ClockGHz);
  uint64_t Later = IsWrite ? minimumDramReadCycles(*Chip.Dram, ChipKHz) -
                                 minimumDramWriteCycles(*Chip.Dram)
                           : 0;
  uint32_t First = Access.Address / Burst;
  uint32_t Last = (Access.Address + Access.Bytes - 1) / Burst;
  auto Left = std::make_shared<unsigned>(Last - First + 1);
  auto Latest = std::make_shared<Outcome>();
  for (uint32_t I = First; I <= Last; ++I)
    DramArrivals.insert(
        {{Cycle, Source, NextSequence++}, [=, this] {
           uint64_t Tag = NextDramTag++;
           DramWaiting[Tag] = [=](const DramAnswer &Answer) {
             *Latest =
                 std::max(*Latest, {Answer.ReadyCycle + Later, Answer.Level});
             if (--*Left == 0 && Access.Done)
               Access.Done(Latest->ReadyCycle, Latest->Level);
           };
           uint32_t Address = I * Burst;
           Channels[Mapping->channelOf(Address)].enqueue(
               {Now, Address, Tag, IsWrite});
         }});
}

void NaiveMemory::tickDram() {
  runDue(DramArrivals);
  for (DramChannel &Channel : Channels) {
    std::vector<DramAnswer> Answers;
    Channel.advance(Now + 1, Answers);
    for (const DramAnswer &Answer : Answers)
      DramWaiting.extract(Answer.Tag).mapped()(Answer);
  }
}

MemoryStatistics NaiveMemory::statistics() const {
  MemoryStatistics Sum;
  if (Chip.L1)
    Sum.L1.emplace();
  for (const Tm &T : Tms)
    if (T.L1)
      *Sum.L1 += T.L1->Counts;
  if (Chip.L2)
    Sum.L2.emplace();
  for (const NaiveCache &L2 : L2s)
    *Sum.L2 += L2.Counts;
  for (const DramChannel &Channel : Channels)
    Sum.DramChannels.push_back(Channel.statistics(Now));
  return Sum;
}

} // namespace tp::test
