//===- SumCheck.cpp - Whether a run's counts add up -----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/stats/SumCheck.h"

#include "simulator/stats/MemoryCounts.h"
#include "simulator/stats/RunSummary.h"

#include "llvm/ADT/Twine.h"

#include <numeric>

using namespace llvm;

namespace tp {
namespace {

template <class Range> uint64_t sumOf(const Range &Counts) {
  return std::accumulate(Counts.begin(), Counts.end(), uint64_t(0));
}

/// Keeps the first sum that is wrong.
class SumChecker {
public:
  void check(const Twine &What, uint64_t Sum, uint64_t Expected) {
    if (Sum != Expected && Message.empty())
      Message = ("internal error: " + What + " add up to " + Twine(Sum) +
                 " instead of " + Twine(Expected))
                    .str();
  }

  void checkThreads(const Statistics &Stats) {
    uint64_t Instructions = 0;
    for (size_t I = 0; I != Stats.Threads.size(); ++I) {
      const ThreadStatistics &Thread = Stats.Threads[I];
      Instructions += Thread.Instructions;
      check("instructions and losses of thread " + Twine(I),
            Thread.Instructions + sumOf(Thread.Lost), Stats.Cycles);
    }
    check("instructions by opcode", sumOf(Stats.Executed), Instructions);
  }

  void checkOpcodes(const Statistics &Stats) {
    uint64_t Waits = 0;
    for (unsigned I = 0; I != NumLosses; ++I)
      if (isWaitForResult(Loss(I)))
        Waits += Stats.lost(Loss(I));
    check("data stalls by opcode", sumOf(Stats.DataStall), Waits);
    check("unit conflicts by opcode", sumOf(Stats.UnitConflict),
          Stats.lost(Loss::UnitConflict));
  }

  void checkPcs(const Statistics &Stats, ArrayRef<Opcode> Opcodes) {
    check("the instruction words with statistics", Stats.Pcs.size(),
          Opcodes.size());
    if (Stats.Pcs.size() != Opcodes.size())
      return;
    std::array<uint64_t, NumOpcodes> Executed{}, UnitConflict{};
    LossCounts Lost{};
    for (size_t Word = 0; Word != Opcodes.size(); ++Word) {
      const PcStatistics &Counts = Stats.Pcs[Word];
      for (unsigned I = 0; I != NumLosses; ++I)
        Lost[I] += Counts.Lost[I];
      if (Opcodes[Word] == IllegalOpcode) {
        check("issues of what is no instruction", Counts.Executed, 0);
        continue;
      }
      auto Op = unsigned(Opcodes[Word]);
      Executed[Op] += Counts.Executed;
      UnitConflict[Op] += Counts.Lost[unsigned(Loss::UnitConflict)];
    }
    for (unsigned I = 0; I != NumOpcodes; ++I) {
      check("issues by instruction of " + Twine(mnemonic(Opcode(I))),
            Executed[I], Stats.Executed[I]);
      check("unit conflicts by instruction of " + Twine(mnemonic(Opcode(I))),
            UnitConflict[I], Stats.UnitConflict[I]);
    }
    for (unsigned I = 0; I != NumLosses; ++I)
      if (Loss(I) != Loss::Finished)
        check(Twine("losses by instruction to ") + lossName(Loss(I)), Lost[I],
              Stats.lost(Loss(I)));
  }

  void checkCache(const char *Level, const CacheStatistics &Counts,
                  uint64_t Lookups) {
    check(Twine("hits, misses and merged requests of the ") + Level,
          Counts.Hits + Counts.Misses + Counts.Merged, Lookups);
  }

  void checkDram(const DramChannelStatistics &Counts, size_t Channel) {
    check("row hits, misses and conflicts of DRAM channel " + Twine(Channel),
          Counts.RowHits + Counts.RowMisses + Counts.RowConflicts,
          Counts.Reads + Counts.Writes);
    check("latencies of reads from DRAM channel " + Twine(Channel),
          sumOf(Counts.ReadLatency), Counts.Reads + Counts.ForwardedReads);
  }

  /// What one level sends arrives at the next.
  void checkFlow(const MemoryStatistics &Memory) {
    DramChannelStatistics Sum = sumOfChannels(Memory.DramChannels);
    uint64_t AtDram = Sum.Reads + Sum.Writes + Sum.ForwardedReads +
                      Sum.MergedWrites + Sum.Pending;
    bool HasDram = !Memory.DramChannels.empty();
    if (const std::optional<CacheStatistics> &L2 = Memory.L2)
      check("requests from TMs at the L2s",
            L2->Loads + L2->Stores + L2->Atomics + L2->Fetches +
                Memory.SentByTmsUnderWay,
            Memory.SentByTms);
    if (HasDram && Memory.L2)
      check("requests from L2s at the DRAM", AtDram + Memory.SentByL2sUnderWay,
            Memory.SentByL2s);
    if (HasDram && !Memory.L2)
      check("requests from TMs at the DRAM", AtDram + Memory.SentByTmsUnderWay,
            Memory.SentByTms);
  }

  void checkMemory(const MemoryStatistics &Memory, uint64_t GlobalAccesses) {
    if (const std::optional<CacheStatistics> &L1 = Memory.L1) {
      checkCache("L1", *L1, L1->Loads);
      check("global accesses at the L1s",
            L1->Loads + L1->Stores + L1->Atomics + Memory.WaitingAtL1,
            GlobalAccesses);
    }
    if (Memory.L2)
      checkCache("L2", *Memory.L2,
                 Memory.L2->Loads + Memory.L2->Fetches + Memory.L2->Atomics);
    for (size_t I = 0; I != Memory.DramChannels.size(); ++I)
      checkDram(Memory.DramChannels[I], I);
    checkFlow(Memory);
  }

  llvm::Error result() const {
    return Message.empty() ? llvm::Error::success()
                           : createStringError(Message);
  }

private:
  std::string Message;
};

} // namespace

llvm::Error checkSums(const ChipConfig &Chip, const Statistics &Stats,
                      ArrayRef<Opcode> Opcodes) {
  SumChecker Checker;
  Checker.check("the threads with statistics", Stats.Threads.size(),
                Chip.threadCount());
  Checker.checkThreads(Stats);
  Checker.checkOpcodes(Stats);
  Checker.checkPcs(Stats, Opcodes);
  if (Stats.Memory)
    Checker.checkMemory(*Stats.Memory, Stats.GlobalAccesses);
  return Checker.result();
}

} // namespace tp
