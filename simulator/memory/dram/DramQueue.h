//===- DramQueue.h - Requests that wait for their bursts --------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_MEMORY_DRAM_DRAMQUEUE_H
#define TP_SIMULATOR_MEMORY_DRAM_DRAMQUEUE_H

#include "simulator/core/Archive.h"
#include "simulator/memory/dram/DramDevice.h"

#include <cstdint>
#include <vector>

namespace tp {

/// A request that waits for its burst.
struct DramQueueEntry {
  /// Smaller is older, over all banks and both queues.
  uint64_t Age;
  uint64_t ArrivalCycle;
  uint64_t Tag;
  uint32_t Row;
  uint32_t Column;
  /// Commands that its row has cost.
  uint32_t Activates;
  uint32_t Precharges;
};

/// The read or the write queue of a channel: what each bank wants next.
class DramQueue {
public:
  /// Of a bank: the command it wants, and for which of its entries.
  struct Candidate {
    uint64_t Age = 0;
    DramCommandKind Wants = DramCommandKind::Activate;
    uint32_t Index = 0;
  };

  /// \p Column is the command that serves an entry, Read or Write.
  DramQueue(DramCommandKind Column, uint32_t Banks, uint32_t RowHitLimit)
      : Column(Column), RowHitLimit(RowHitLimit), Entries(Banks),
        HitsPassed(Banks), Candidates(Banks) {}

  bool empty() const { return Size == 0; }
  uint64_t size() const { return Size; }
  bool contains(uint32_t Bank, uint32_t Row, uint32_t Column) const;
  /// Of a bank that wants anything.
  const DramQueueEntry &oldest(uint32_t Bank) const {
    return Entries[Bank].front();
  }
  /// Bit b is set if bank b wants anything.
  uint64_t wantingBanks() const { return WantingBanks; }
  bool wants(uint32_t Bank) const { return WantingBanks >> Bank & 1; }
  /// Of a bank that wants anything.
  const Candidate &candidate(uint32_t Bank) const { return Candidates[Bank]; }

  void add(const DramQueueEntry &Entry, uint32_t Bank, uint32_t OpenRow);
  /// Takes out the entry whose column command is issued.
  DramQueueEntry take(uint32_t Bank, uint32_t OpenRow);
  /// A bank's row has been opened or closed for the bank's oldest entry.
  void noteActivate(uint32_t Bank, uint32_t OpenRow);
  void notePrecharge(uint32_t Bank);
  /// A row has been opened or closed for another reason.
  void rowChanged(uint32_t Bank, uint32_t OpenRow);

  void serialize(Archive &A);

private:
  void choose(uint32_t Bank, uint32_t OpenRow);

  DramCommandKind Column;
  uint32_t RowHitLimit;
  uint64_t Size = 0;
  uint64_t WantingBanks = 0;
  /// Per bank, the oldest first.
  std::vector<std::vector<DramQueueEntry>> Entries;
  /// Per bank: bursts from its open row that passed an older entry.
  std::vector<uint32_t> HitsPassed;
  std::vector<Candidate> Candidates;
};

} // namespace tp

#endif // TP_SIMULATOR_MEMORY_DRAM_DRAMQUEUE_H
