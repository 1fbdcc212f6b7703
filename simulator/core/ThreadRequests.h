//===- ThreadRequests.h - A thread's accesses under way ---------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// On a chip with a memory system it is not known at issue when a result of
// global memory is ready. Its ready word is then pending, and a thread that
// needs it is suspended until the memory system has answered.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_THREADREQUESTS_H
#define TP_SIMULATOR_CORE_THREADREQUESTS_H

#include "simulator/core/Archive.h"
#include "simulator/core/Thread.h"
#include "simulator/isa/Instructions.h"
#include "simulator/memory/MemoryRequest.h"

#include <array>
#include <cstdint>
#include <vector>

namespace tp {

/// What a suspended thread waits for.
enum class Awaited : uint8_t {
  /// It is not suspended.
  Nothing,
  /// Sources of its next instruction.
  Sources,
  /// The oldest entry of its store buffer.
  StoreEntry,
  /// All its stores: it has executed `sync` or `hostcall`.
  AllStores,
  /// The line of its next instruction.
  Line,
};

/// What a thread has asked of the memory system. All cycles are absolute.
class ThreadRequests {
public:
  /// The last load or atomic whose result goes to a register. There are many:
  /// it is kept small.
  struct RegisterRequest {
    /// Low bits of the cycle of issue.
    uint32_t IssuedLow = 0;
    /// Of its ticket.
    uint32_t Number : 24 = 0;
    /// It has gone beyond the L1.
    uint32_t GoneOn : 1 = false;
    /// Who had it, once it is answered.
    uint32_t LevelBits : 3 = 0;

    ServedBy level() const { return ServedBy(LevelBits); }
    /// The cycle of issue, which was less than 2^32 cycles before \p Cycle.
    uint64_t issuedBefore(uint64_t Cycle) const {
      return Cycle - uint32_t(uint32_t(Cycle) - IssuedLow);
    }
  };

  /// An entry of the store buffer.
  struct StoreEntry {
    /// The first cycle in which another store may take it; NeverFree while its
    /// store is unanswered.
    uint64_t FreeFrom = 0;
    bool GoneOn = false;
  };
  static constexpr uint64_t NeverFree = ~uint64_t(0);

  explicit ThreadRequests(uint32_t StoreBufferEntries)
      : Stores(StoreBufferEntries) {}

  /// The ticket of a new load or atomic.
  uint32_t addRegister(uint8_t Register, uint64_t Cycle, bool GoneOn) {
    RegisterRequest &Request = Registers[Register];
    Request.IssuedLow = uint32_t(Cycle);
    Request.Number = NextNumber++;
    Request.GoneOn = GoneOn;
    return uint32_t(Request.Number) << RegisterBits | Register;
  }
  /// The ticket of a new store: it takes the oldest entry.
  uint32_t addStore();
  const StoreEntry &oldestStore() const { return Stores[NextStore]; }

  /// The register that a ticket is for, NumRegisters of a store.
  static uint8_t registerOf(uint32_t Ticket) {
    return uint8_t(Ticket & RegisterMask);
  }
  /// Tickets for lines of the text.
  static uint32_t ticketOfLine(uint32_t Line) {
    return Line << RegisterBits | LineMark;
  }
  /// NoLine of other tickets.
  static uint32_t lineOf(uint32_t Ticket) {
    return registerOf(Ticket) == LineMark ? Ticket >> RegisterBits : NoLine;
  }
  /// Notes an answer about a register, and whether the register still belongs
  /// to that request.
  bool noteRegister(const MemoryAnswer &Answer) {
    RegisterRequest &Request = Registers[registerOf(Answer.Ticket)];
    if (Request.Number != Answer.Ticket >> RegisterBits)
      return false;
    if (Answer.ReadyCycle == AnsweredLater)
      Request.GoneOn = true;
    else
      Request.LevelBits = uint32_t(Answer.Level);
    return true;
  }
  void noteStore(const MemoryAnswer &Answer);

  /// Where a request comes from: its word of the text and its cycle of issue.
  struct Origin {
    uint32_t Word = 0;
    uint64_t Cycle = 0;
  };
  /// Keeps the origin of a request until it is answered.
  void addOrigin(uint32_t Ticket, Origin From);
  /// The origin of a request that is answered, which must have been added.
  Origin takeOrigin(uint32_t Ticket);

  const RegisterRequest &request(uint8_t Register) const {
    return Registers[Register];
  }
  uint32_t unansweredStores() const { return Unanswered; }
  /// Whether one of the unanswered stores has gone beyond the L1.
  bool hasStoreGoneOn() const { return StoresGoneOn != 0; }
  /// The latest answer of a store so far.
  uint64_t lastStoreAnswer() const { return LastStoreAnswer; }

  void suspend(Awaited What, uint64_t Cycle) {
    Waiting = What;
    SuspendedAt = Cycle;
  }
  void resume() { Waiting = Awaited::Nothing; }
  Awaited waitsFor() const { return Waiting; }
  /// The cycle from which on a suspended thread waits, uncharged as yet.
  uint64_t suspendedAt() const { return SuspendedAt; }

  void serialize(Archive &A);

private:
  /// A ticket is a register and a number, NumRegisters and a place in the store
  /// buffer, or LineMark and a line of the text.
  static constexpr unsigned RegisterBits = 7;
  static constexpr uint32_t RegisterMask = (1 << RegisterBits) - 1;
  static constexpr uint32_t LineMark = NumRegisters + 1;
  static_assert(LineMark <= RegisterMask);
  static_assert(NumServedBy <= 8);

  uint64_t SuspendedAt = 0;
  Awaited Waiting = Awaited::Nothing;
  uint32_t NextNumber = 0;
  uint32_t NextStore = 0;
  uint32_t Unanswered = 0;
  uint32_t StoresGoneOn = 0;
  uint64_t LastStoreAnswer = 0;
  struct TicketOrigin {
    uint32_t Ticket = 0;
    Origin From;
  };

  /// Of the unanswered requests, if a recorder wants them.
  std::vector<TicketOrigin> Origins;
  std::vector<StoreEntry> Stores;
  std::array<RegisterRequest, NumRegisters> Registers{};
};

} // namespace tp

#endif // TP_SIMULATOR_CORE_THREADREQUESTS_H
