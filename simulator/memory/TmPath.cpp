//===- TmPath.cpp - A TM's way to memory ----------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/memory/TmPath.h"

namespace tp {

TmPath::TmPath(const ChipConfig &Chip, uint32_t Granule)
    : Granule(Granule),
      HeaderBytes(Chip.Crossbar ? Chip.Crossbar->HeaderBytes : 0),
      MemoryLatency(Chip.MemoryLatency),
      L1Latency(Chip.L1 ? Chip.L1->Latency : 0),
      L1SectorBytes(Chip.L1 ? Chip.L1->SectorBytes : 0) {
  if (Chip.L1)
    L1 = &OwnL1.emplace(*Chip.L1, ServedBy::L1, /*DoesAtomics=*/false, Pool,
                        static_cast<CacheClient &>(*this));
  if (Chip.Crossbar) {
    RequestPort = &OwnRequestPort.emplace(Chip.Crossbar->RequestBytesPerCycle,
                                          Chip.Crossbar->Latency);
    AnswerPort = &OwnAnswerPort.emplace(Chip.Crossbar->AnswerBytesPerCycle,
                                        Chip.Crossbar->Latency);
  }
}

void TmPath::advance(uint64_t Cycle, std::vector<MemoryAnswer> &Answers) {
  Requests.settle();
  Early = &Answers;
  if (L1)
    L1->advance(Cycle, *this);
  else
    while (Requests.nextCycle() < Cycle)
      take();
  Early = nullptr;
}

uint64_t TmPath::nextEvent() const {
  return std::min(Requests.nextCycle(), L1 ? L1->nextDeadline() : NoCycle);
}

void TmPath::takeAnswers(std::vector<MemoryAnswer> &Answers) {
  Answers.insert(Answers.end(), Late.begin(), Late.end());
  Late.clear();
}

uint32_t TmPath::addToPool(uint32_t Arrival) {
  const MemoryRequest &Request = arrivals()[Arrival];
  Access A;
  A.Cycle = Request.Cycle;
  A.Address = Request.Address;
  A.Tag = Request.Ticket;
  A.Source = Request.Tp;
  A.Bytes = Request.Bytes;
  A.Kind = Request.Kind;
  return Pool.add(A);
}

uint32_t TmPath::take() {
  uint32_t Index = addToPool(0);
  Requests.pop();
  const Access &A = Pool[Index];
  if (L1 && A.Kind != RequestKind::Fetch)
    return Index;
  forward(Index, A.Cycle + L1Latency);
  return NoIndex;
}

void TmPath::answer(uint32_t Index, uint64_t Ready, ServedBy Level) {
  const Access &A = Pool[Index];
  bool IsEarly =
      Early && (A.Kind == RequestKind::Load || A.Kind == RequestKind::Store);
  (IsEarly ? *Early : Late).push_back({Ready, A.Tag, A.Source, Level});
  Pool.release(Index);
}

void TmPath::postpone(uint32_t Index) {
  const Access &A = Pool[Index];
  if (A.Kind == RequestKind::Load || A.Kind == RequestKind::Store)
    Early->push_back({AnsweredLater, A.Tag, A.Source, ServedBy::L1});
}

void TmPath::fetch(uint32_t Register, uint32_t Address, uint64_t Departure) {
  L1->expect(Register, partsOf(Address, L1SectorBytes));
  send(Departure, Address, L1SectorBytes, RequestKind::Load,
       Register | RegisterTag);
}

void TmPath::forward(uint32_t Index, uint64_t Departure) {
  Access &A = Pool[Index];
  A.Remaining = uint16_t(partsOf(A.Address, A.Bytes));
  if (L1 && Granule != 0)
    postpone(Index);
  send(Departure, A.Address, A.Bytes, A.Kind, Index);
}

void TmPath::write(uint32_t Address, uint32_t Bytes, uint64_t Departure) {
  send(Departure, Address, Bytes, RequestKind::Store, NoIndex);
}

uint32_t TmPath::partsOf(uint32_t Address, uint32_t Bytes) const {
  if (Granule == 0)
    return 1;
  return (Address + Bytes - 1) / Granule - Address / Granule + 1;
}

/// Bytes of data that an answer carries.
static uint32_t answerBytes(RequestKind Kind, uint32_t Bytes) {
  return Kind == RequestKind::Store ? 0 : Bytes;
}

void TmPath::send(uint64_t Departure, uint32_t Address, uint32_t Bytes,
                  RequestKind Kind, uint32_t Tag) {
  bool CarriesData = Kind == RequestKind::Store || Kind == RequestKind::Atomic;
  ++Messages;
  uint64_t Arrival = Departure;
  if (RequestPort)
    Arrival =
        RequestPort->send(Departure, HeaderBytes + (CarriesData ? Bytes : 0));
  if (Granule == 0) {
    if (Tag == NoIndex)
      return;
    uint64_t Answered = Arrival + MemoryLatency;
    if (AnswerPort)
      Answered = AnswerPort->send(Answered, answerBytes(Kind, Bytes));
    receive(Tag, Answered, ServedBy::Memory);
    return;
  }
  Access Request;
  Request.Cycle = Arrival;
  Request.Address = Address;
  Request.Tag = Tag;
  Request.Bytes = uint16_t(Bytes);
  Request.Kind = Kind;
  sendParts(Request);
}

void TmPath::sendParts(Access Request) {
  uint32_t Left = Request.Bytes;
  while (Left != 0) {
    uint32_t Bytes = std::min(Left, Granule - Request.Address % Granule);
    Request.Bytes = uint16_t(Bytes);
    Request.Sequence = NextSequence++;
    Outgoing.push_back(Request);
    ++Sent;
    Request.Address += Bytes;
    Left -= Bytes;
  }
}

void TmPath::sendBack(const ReturnMessage &Message) {
  Returns.push_back(Message);
  std::push_heap(Returns.begin(), Returns.end(), later);
}

void TmPath::deliver(uint64_t Limit) {
  while (!Returns.empty() && Returns.front().Cycle < Limit) {
    ReturnMessage Message = Returns.front();
    std::pop_heap(Returns.begin(), Returns.end(), later);
    Returns.pop_back();
    uint64_t Cycle = Message.Cycle;
    if (AnswerPort)
      Cycle = AnswerPort->send(Cycle, Message.Bytes);
    receive(Message.Tag, Cycle, Message.Level);
  }
}

void TmPath::receive(uint32_t Tag, uint64_t Cycle, ServedBy Level) {
  if (L1 && Tag & RegisterTag)
    L1->arrive(Tag & ~RegisterTag, Cycle, Level);
  else
    receivePart(Tag, Cycle, Level);
}

void TmPath::receivePart(uint32_t Index, uint64_t Cycle, ServedBy Level) {
  Access &A = Pool[Index];
  A.Level = A.Cycle == Cycle ? std::max<ServedBy>(A.Level, Level) : Level;
  A.Cycle = Cycle;
  if (--A.Remaining == 0)
    answer(Index, Cycle, A.Level);
}

void TmPath::prefetchObject() const {
  auto *Begin = reinterpret_cast<const char *>(this);
  for (size_t Offset = 0; Offset < sizeof(TmPath); Offset += 64)
    __builtin_prefetch(Begin + Offset, 1);
}

void TmPath::prefetchBuffers() const {
  Requests.prefetch();
  Pool.prefetch();
  if (L1)
    L1->prefetch();
}

void TmPath::addTo(MemoryStatistics &Sum) const {
  if (L1 && Sum.L1) {
    *Sum.L1 += L1->statistics();
    Sum.WaitingAtL1 += L1->queueLength();
  }
  Sum.SentByTms += Sent;
  Sum.SentByTmsUnderWay += Outgoing.size();
  if (!RequestPort || !Sum.Crossbar)
    return;
  CrossbarStatistics &Crossbar = *Sum.Crossbar;
  Crossbar.Requests += Messages;
  Crossbar.RequestBytes += RequestPort->bytes();
  Crossbar.AnswerBytes += AnswerPort->bytes();
  Crossbar.RequestWaitCycles += RequestPort->waitCycles();
  Crossbar.AnswerWaitCycles += AnswerPort->waitCycles();
}

void TmPath::serialize(Archive &A) {
  A(Pool);
  A(Requests);
  if (L1)
    L1->serialize(A);
  if (RequestPort) {
    RequestPort->serialize(A);
    AnswerPort->serialize(A);
  }
  A(Outgoing);
  A(Returns);
  A(Messages);
  A(NextSequence);
  A(Sent);
  A(Late);
}

} // namespace tp
