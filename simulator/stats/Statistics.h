//===- Statistics.h - What a simulation counts ------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_STATS_STATISTICS_H
#define TP_SIMULATOR_STATS_STATISTICS_H

#include "simulator/isa/Instructions.h"
#include "simulator/memory/MemoryRequest.h"
#include "simulator/memory/MemoryStatistics.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace tp {

/// Why a thread did not issue in a cycle. Every thread-cycle is either an
/// issue or exactly one of these.
enum class Loss : uint8_t {
  /// Waited for the result of a unit or of the local store.
  Data,
  /// Waited for the result of a load or atomic from global memory of fixed
  /// latency, or that is still on its way at the end.
  Memory,
  /// Waited for a load or atomic that this level served.
  L1,
  L2,
  Dram,
  /// Its next store found its store buffer full.
  StoreBuffer,
  /// The functional unit had no issue slot left in this cycle.
  UnitConflict,
  /// The instruction cache bank had no port left in this cycle.
  IcacheConflict,
  /// Waited for a line of the instruction cache.
  IcacheMiss,
  /// A taken branch whose target is fetched later than the next cycle.
  Branch,
  /// Waited at a barrier.
  Barrier,
  /// Waited in `sync` for its own stores to become visible.
  Sync,
  /// Slept.
  Sleep,
  /// Halted, while other threads still ran.
  Finished,
};
inline constexpr unsigned NumLosses = unsigned(Loss::Finished) + 1;

/// Cycles lost by reason.
using LossCounts = std::array<uint64_t, NumLosses>;

/// Whether the loss has an instruction whose result was waited for.
constexpr bool isWaitForResult(Loss Reason) {
  return Reason <= Loss::StoreBuffer;
}

/// What one thread did.
struct ThreadStatistics {
  uint64_t Instructions = 0;
  /// Cycle after the thread's last instruction; 0 while it has not halted.
  uint64_t FinishCycle = 0;
  /// Instructions plus the sum of these is the chip's cycles.
  LossCounts Lost{};
};

/// What happened at one instruction word of the text, over all threads.
struct PcStatistics {
  uint64_t Executed = 0;
  /// Thread-cycles lost at it: to Loss::Branch, Barrier, Sync and Sleep behind
  /// this instruction, to all others while it was the next to issue. A halted
  /// thread is nowhere: Loss::Finished is 0.
  LossCounts Lost{};
  /// Accesses to global memory.
  uint64_t Global = 0;
};

/// Accesses that one level of memory served, and the cycles from their issues
/// to their answers.
struct ServedAccesses {
  uint64_t Accesses = 0;
  uint64_t Cycles = 0;

  bool operator==(const ServedAccesses &) const = default;
};

/// What became of an instruction's accesses to memory.
struct MemoryBehaviour {
  /// Those that went to global memory; of the others the local store had all.
  uint64_t Global = 0;
  /// By ServedBy. What was under way when the run ended is not there.
  std::array<ServedAccesses, NumServedBy> Served{};

  MemoryBehaviour &operator+=(const MemoryBehaviour &Other) {
    Global += Other.Global;
    for (unsigned I = 0; I != NumServedBy; ++I) {
      Served[I].Accesses += Other.Served[I].Accesses;
      Served[I].Cycles += Other.Served[I].Cycles;
    }
    return *this;
  }
  bool operator==(const MemoryBehaviour &) const = default;
};

/// Of the instruction caches of all TMs, if they can miss: lookups, lines that
/// were fetched, and lookups that joined such a fetch.
struct IcacheStatistics {
  uint64_t Lookups = 0;
  uint64_t Misses = 0;
  uint64_t Merged = 0;

  IcacheStatistics &operator+=(const IcacheStatistics &Other) {
    Lookups += Other.Lookups;
    Misses += Other.Misses;
    Merged += Other.Merged;
    return *this;
  }
  IcacheStatistics &operator-=(const IcacheStatistics &Other) {
    Lookups -= Other.Lookups;
    Misses -= Other.Misses;
    Merged -= Other.Merged;
    return *this;
  }
};

/// Sums over the chip. Thread-cycles unless stated otherwise.
struct Statistics {
  /// Cycles from the start to the last thread's halt (or to the stop).
  uint64_t Cycles = 0;
  /// Instructions issued, by opcode.
  std::array<uint64_t, NumOpcodes> Executed{};
  /// Cycles lost waiting for a result (isWaitForResult()), by the opcode that
  /// produces it.
  std::array<uint64_t, NumOpcodes> DataStall{};
  /// Cycles lost to Loss::UnitConflict, by the opcode that had to wait.
  std::array<uint64_t, NumOpcodes> UnitConflict{};
  /// Passes of the profile marker instruction, by its immediate.
  std::vector<uint64_t> Markers;
  /// One entry per thread; the thread number is TM * TPs per TM + TP.
  std::vector<ThreadStatistics> Threads;
  /// One entry per word of the program's text, in the order of addresses.
  std::vector<PcStatistics> Pcs;
  /// Loads, stores, atomics and stream operations that went to global memory:
  /// the sum of Pcs.
  uint64_t GlobalAccesses = 0;
  IcacheStatistics Icache;
  /// Nothing if the chip has neither caches nor DRAM.
  std::optional<MemoryStatistics> Memory;

  /// Sum of Executed.
  uint64_t instructions() const;
  /// Sum over the threads of one loss.
  uint64_t lost(Loss Reason) const;

  /// What was counted between \p Earlier, a pause of the same run (or nothing
  /// at all, for its start), and now.
  /// ThreadStatistics::FinishCycle stays a cycle of the run, and maxima stay
  /// those since its start. On a chip with a memory system waits for what is
  /// still on its way count as Loss::Memory until it is known which level
  /// serves them: their difference may be negative, modulo 2^64.
  Statistics since(const Statistics &Earlier) const;
  /// Appends the counts of a later part of the same run; to nothing at all,
  /// for a sum of parts.
  Statistics &operator+=(const Statistics &Later);

  /// Saves or restores (core/Archive.h).
  template <class Archive> void serialize(Archive &A) {
    A(Cycles);
    A(Executed);
    A(DataStall);
    A(UnitConflict);
    A(Markers);
    A(Threads);
    A(Pcs);
    A(GlobalAccesses);
    A(Icache);
    A(Memory);
  }
};

} // namespace tp

#endif // TP_SIMULATOR_STATS_STATISTICS_H
