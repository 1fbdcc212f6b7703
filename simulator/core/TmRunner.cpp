//===- TmRunner.cpp - What one host thread works on -----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/core/TmRunner.h"
#include "simulator/core/ThreadRequests.h"

#include <algorithm>
#include <utility>

namespace tp {

/// The bytes of [Address, Address + Bytes) that [Other, Other + OtherBytes)
/// covers, as a bit mask from the lowest address on.
static unsigned overlap(uint32_t Address, unsigned Bytes, uint32_t Other,
                        unsigned OtherBytes) {
  unsigned Mask = 0;
  for (unsigned I = 0; I != Bytes; ++I)
    Mask |= unsigned(Address + I - Other < OtherBytes) << I;
  return Mask;
}

void TmRunnerState::growLog() {
  Log.reserve(std::max<size_t>(256, 2 * Log.capacity()));
}

static void moveCounts(std::vector<uint64_t> &From, std::vector<uint64_t> &To) {
  To.resize(std::max(From.size(), To.size()));
  for (size_t I = 0; I != From.size(); ++I)
    To[I] += std::exchange(From[I], 0);
}

void TmRunnerState::moveCountersTo(TmRunnerState &Other) {
  for (size_t I = 0; I != IssuedAt.size(); ++I) {
    Other.IssuedAt[I].Executed += std::exchange(IssuedAt[I].Executed, 0);
    Other.IssuedAt[I].Global += std::exchange(IssuedAt[I].Global, 0);
  }
  for (size_t I = 0; I != LostAt.size(); ++I)
    for (unsigned Reason = 0; Reason != NumLosses; ++Reason)
      Other.LostAt[I][Reason] += std::exchange(LostAt[I][Reason], 0);
  for (unsigned I = 0; I != NumOpcodes; ++I)
    Other.DataStall[I] += std::exchange(DataStall[I], 0);
  moveCounts(Markers, Other.Markers);
}

void TmRunnerState::countMarker(uint32_t Number) {
  if (Number >= Markers.size())
    Markers.resize(Number + 1);
  ++Markers[Number];
}

MemoryRequest TmRunnerState::request(const Thread &T, RequestKind Kind,
                                     uint64_t Cycle, uint32_t Address,
                                     unsigned Bytes, uint32_t Ticket) const {
  MemoryRequest Result;
  Result.Cycle = Epoch + Cycle;
  Result.Address = Address;
  Result.Ticket = Ticket;
  Result.Priority = priorityOf(OwnOrder);
  Result.Tp = uint16_t(T.Number % Chip.Chip->TpsPerTm);
  Result.Bytes = uint16_t(Bytes);
  Result.Kind = Kind;
  return Result;
}

ReadyWord TmRunnerState::requestLoad(Thread &T, uint32_t Word,
                                     uint8_t Destination, Opcode Op,
                                     uint64_t Cycle, uint32_t Address,
                                     unsigned Bytes) {
  uint32_t Ticket = T.Requests->addRegister(Destination, Epoch + Cycle, false);
  ask(request(T, RequestKind::Load, Cycle, Address, Bytes, Ticket), T, Word);
  return ready::pending(Op);
}

ReadyWord TmRunnerState::requestAtomic(Thread &T, uint32_t Word,
                                       uint8_t Destination, Opcode Op,
                                       uint64_t Cycle, uint32_t Address) {
  uint32_t Ticket = T.Requests->addRegister(Destination, Epoch + Cycle, true);
  ask(request(T, RequestKind::Atomic, Cycle, Address, 4, Ticket), T, Word);
  return ready::pending(Op);
}

bool TmRunnerState::requestStore(Thread &T, uint32_t Word, uint64_t Cycle,
                                 uint32_t Address, unsigned Bytes) {
  if (T.Requests->oldestStore().FreeFrom > Epoch + Cycle)
    return false;
  ask(request(T, RequestKind::Store, Cycle, Address, Bytes,
              T.Requests->addStore()),
      T, Word);
  return true;
}

void TmRunnerState::requestLine(const InstructionCache::Miss &Missed) {
  uint32_t LineBytes = Chip.Chip->IcacheLineBytes;
  ask({.Cycle = Missed.Cycle,
       .Address = Missed.Line * LineBytes,
       .Ticket = ThreadRequests::ticketOfLine(Missed.Line),
       .Priority = Missed.Priority,
       .Tp = Missed.Tp,
       .Bytes = uint16_t(LineBytes),
       .Kind = RequestKind::Fetch});
}

void TmRunnerState::awaitStores(Thread &T) {
  ThreadRequests &Requests = *T.Requests;
  if (Requests.unansweredStores() != 0) {
    Requests.suspend(Awaited::AllStores, NextCycle);
    NextCycle = NeverCycle;
  } else if (uint64_t Answered = Requests.lastStoreAnswer();
             Answered > NextCycle) {
    charge(T, T.LastWord, Loss::Sync, Answered - NextCycle);
    NextCycle = Answered;
  }
}

std::optional<Opcode> TmRunnerState::forwardOwn(uint32_t Address,
                                                unsigned Bytes,
                                                uint32_t &Value) const {
  unsigned Missing = (1u << Bytes) - 1;
  for (size_t I = Log.size(); I != OwnLogBegin && Missing != 0; --I) {
    const GlobalAccess &Access = Log[I - 1];
    switch (Access.Kind) {
    case GlobalAccess::HostCall:
      break;
    case GlobalAccess::Stream:
      return ready::producerOf(Access.Ready);
    case GlobalAccess::Atomic:
      if (overlap(Address, Bytes, Access.Address, 4) & Missing)
        return ready::producerOf(Access.Ready);
      break;
    case GlobalAccess::Store: {
      unsigned Found =
          overlap(Address, Bytes, Access.Address, Access.Bytes) & Missing;
      for (unsigned Byte = 0; Byte != Bytes; ++Byte) {
        if (!(Found >> Byte & 1))
          continue;
        uint32_t From = (Address + Byte - Access.Address) * 8;
        uint32_t Stored = Access.Value >> From & 0xFF;
        Value = (Value & ~(0xFFu << Byte * 8)) | Stored << Byte * 8;
      }
      Missing &= ~Found;
      break;
    }
    }
  }
  return std::nullopt;
}

} // namespace tp
