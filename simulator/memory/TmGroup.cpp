//===- TmGroup.cpp - TMs with what they share alone -----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/memory/TmGroup.h"

namespace tp {

TmGroup::TmGroup(const ChipConfig &Chip, uint32_t Number, uint32_t FirstTm,
                 std::span<const std::unique_ptr<TmPath>> Tms)
    : Number(Number), FirstTm(FirstTm),
      BurstBytes(Chip.Dram ? Chip.Dram->BurstBytes : 0),
      SectorBytes(Chip.L2 ? Chip.L2->SectorBytes : 0),
      MemoryLatency(Chip.MemoryLatency),
      HasUnawaited(Chip.L1 && Chip.L1->Writes == WritePolicy::Back), Tms(Tms) {
  if (Chip.L2)
    L2 = &OwnL2.emplace(*Chip.L2, ServedBy::L2, /*DoesAtomics=*/true, Pool,
                        static_cast<CacheClient &>(*this));
}

void TmGroup::advance(uint64_t Limit) {
  for (uint32_t Tm = 0; Tm != Tms.size(); ++Tm) {
    std::vector<Access> &Sent = Tms[Tm]->Outgoing;
    for (Access &Request : Sent) {
      Request.Source = uint16_t(Tm);
      if (L2) {
        L2->prefetch(Request.Address);
        Requests.add(Request);
      } else {
        passOn(Request);
      }
    }
    Sent.clear();
  }
  if (!L2)
    return;
  Requests.settle();
  L2->advance(Limit, *this);
}

void TmGroup::passOn(const Access &Request) {
  bool IsAwaited = Request.Tag != NoIndex;
  BurstRequest Burst{Request.Cycle,
                     Request.Address,
                     Number,
                     IsAwaited ? Pool.add(Request) : DramChannels::NoAnswer,
                     FirstTm + Request.Source,
                     Request.Sequence,
                     Request.Kind == RequestKind::Store};
  Outgoing.push_back(Burst);
  if (Request.Kind != RequestKind::Atomic)
    return;
  Burst.Tag = DramChannels::NoAnswer;
  Burst.IsWrite = true;
  Outgoing.push_back(Burst);
  ++Sent;
}

void TmGroup::deliver(uint64_t Limit) {
  for (const BurstAnswer &Answer : Answers)
    receive(Answer);
  Answers.clear();
  NextReturn = NoCycle;
  for (const std::unique_ptr<TmPath> &Tm : Tms) {
    Tm->deliver(Limit);
    NextReturn = std::min(NextReturn, Tm->nextReturn());
  }
}

uint64_t TmGroup::nextAdvance() const {
  uint64_t Next =
      L2 ? std::min(Requests.nextCycle(), L2->nextDeadline()) : NoCycle;
  if (HasUnawaited)
    for (const std::unique_ptr<TmPath> &Tm : Tms)
      if (!Tm->Outgoing.empty())
        Next = std::min(Next, Tm->Outgoing.front().Cycle);
  return Next;
}

void TmGroup::answer(uint32_t Index, uint64_t Ready, ServedBy Level) {
  sendBack(Pool[Index], Ready, Level);
  Pool.release(Index);
}

void TmGroup::sendBack(const Access &A, uint64_t Departure, ServedBy Level) {
  uint32_t Bytes = A.Kind == RequestKind::Store ? 0 : A.Bytes;
  if (A.Tag != NoIndex)
    Tms[A.Source]->sendBack({Departure, A.Sequence, A.Tag, Bytes, Level});
}

void TmGroup::fetch(uint32_t Register, uint32_t Address, uint64_t Departure) {
  if (BurstBytes == 0) {
    L2->expect(Register, 1);
    L2->arrive(Register, Departure + MemoryLatency, ServedBy::Memory);
    return;
  }
  L2->expect(Register, burstsOf(Address, SectorBytes));
  sendBursts(Departure, Address, SectorBytes, false, Register | RegisterTag);
}

void TmGroup::forward(uint32_t Index, uint64_t Departure) {
  Access &A = Pool[Index];
  if (BurstBytes == 0) {
    answer(Index, Departure + MemoryLatency, ServedBy::Memory);
    return;
  }
  A.Remaining = uint16_t(burstsOf(A.Address, A.Bytes));
  A.Cycle = 0;
  sendBursts(Departure, A.Address, A.Bytes, true, Index);
}

void TmGroup::write(uint32_t Address, uint32_t Bytes, uint64_t Departure) {
  if (BurstBytes != 0)
    sendBursts(Departure, Address, Bytes, true, DramChannels::NoAnswer);
}

uint32_t TmGroup::burstsOf(uint32_t Address, uint32_t Bytes) const {
  return (Address + Bytes - 1) / BurstBytes - Address / BurstBytes + 1;
}

void TmGroup::sendBursts(uint64_t Cycle, uint32_t Address, uint32_t Bytes,
                         bool IsWrite, uint32_t Tag) {
  uint32_t Count = burstsOf(Address, Bytes);
  uint32_t Burst = Address / BurstBytes * BurstBytes;
  for (uint32_t I = 0; I != Count; ++I, Burst += BurstBytes)
    Outgoing.push_back(
        {Cycle, Burst, Number, Tag, Number, NextSequence++, IsWrite});
  Sent += Count;
}

void TmGroup::receive(const BurstAnswer &Answer) {
  if (L2 && Answer.Tag & RegisterTag) {
    L2->arrive(Answer.Tag & ~RegisterTag, Answer.Cycle, Answer.Level);
    return;
  }
  Access &A = Pool[Answer.Tag];
  if (!L2) {
    answer(Answer.Tag, Answer.Cycle, Answer.Level);
    return;
  }
  A.Cycle = std::max(A.Cycle, Answer.Cycle);
  if (--A.Remaining == 0)
    answer(Answer.Tag, A.Cycle, Answer.Level);
}

void TmGroup::addTo(MemoryStatistics &Sum) const {
  if (!L2) {
    Sum.SentByTms += Sent;
    return;
  }
  if (Sum.L2)
    *Sum.L2 += L2->statistics();
  Sum.SentByTmsUnderWay += Requests.size() + L2->queueLength();
  Sum.SentByL2s += Sent;
}

void TmGroup::serialize(Archive &A) {
  A(Pool);
  A(Requests);
  if (L2)
    L2->serialize(A);
  A(NextSequence);
  A(Sent);
  A(NextReturn);
}

} // namespace tp
