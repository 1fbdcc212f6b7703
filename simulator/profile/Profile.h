//===- Profile.h - Where a run spent its cycles -----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// A profile is all that tables, graphs and comparisons of a run are made from;
// it needs neither the program nor its sources any more. As a file it is JSON:
// docs/profile.schema.json describes the names.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_PROFILE_PROFILE_H
#define TP_SIMULATOR_PROFILE_PROFILE_H

#include "simulator/stats/Statistics.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tp {

/// Thread-cycles: those in which an instruction was issued, and those lost by
/// reason.
struct ProfileCounts {
  uint64_t Instructions = 0;
  LossCounts Lost{};

  uint64_t cycles() const;
  uint64_t lost() const;
  /// Of these, for memory of whatever level or a place in the store buffer.
  uint64_t memoryWaits() const;
  ProfileCounts &operator+=(const ProfileCounts &Other);
  bool operator==(const ProfileCounts &) const = default;
};

/// The accesses that the levels from \p First to \p Last served.
ServedAccesses servedBetween(const MemoryBehaviour &Memory, ServedBy First,
                             ServedBy Last);

/// A file of the program's source.
struct ProfileFile {
  /// As the compiler was told.
  std::string Path;
  /// Nothing if it could not be read.
  std::optional<std::string> Text;
};

/// A function of the source; nothing is known of what is empty or 0.
struct ProfileFunction {
  std::string Name;
  std::optional<uint32_t> File;
  uint32_t Line = 0;
};

/// A place in the source, with the calls through which it was inlined there.
struct ProfileFrame {
  uint32_t Function = 0;
  std::optional<uint32_t> File;
  uint32_t Line = 0;
  uint32_t Column = 0;
  /// The place into which Function was inlined; always an earlier frame.
  std::optional<uint32_t> InlinedInto;
};

/// One instruction of the text with the counts of all threads.
struct ProfileInstruction {
  uint32_t Pc = 0;
  /// As a disassembler shows it.
  std::string Text;
  uint32_t Frame = 0;
  ProfileCounts Counts;
  MemoryBehaviour Memory;
};

/// A function as it was called through one chain of calls; recursion is one
/// node. Inlined functions are in the instructions' frames.
struct CallNode {
  uint32_t Function = 0;
  /// The caller, always an earlier node; nothing for functions that no call was
  /// seen of.
  std::optional<uint32_t> Caller;
  /// The instruction of the caller that called, by number.
  std::optional<uint32_t> CallSite;
  uint64_t Calls = 0;
  /// Without what it called.
  ProfileCounts Self;
};

/// What each TM did over time. Sums over intervals and TMs are those of the
/// run.
struct Utilisation {
  /// The first cycle behind each interval.
  std::vector<uint64_t> Ends;
  /// By interval: of the whole chip.
  std::vector<ProfileCounts> Chip;
  /// By TM and interval: thread-cycles issued, waiting for memory (memory, l1,
  /// l2, dram, store_buffer), and finished.
  std::vector<std::vector<uint64_t>> Issued;
  std::vector<std::vector<uint64_t>> Memory;
  std::vector<std::vector<uint64_t>> Finished;
};

/// What is said of a run and its chip.
struct ProfileRun {
  std::string Program;
  std::string Outcome;
  std::string Chip;
  double ClockGhz = 0;
  uint32_t TmCount = 0;
  uint32_t TpsPerTm = 0;
  uint64_t Cycles = 0;
  /// Thread-cycles of threads that had halted. Together with the counts of all
  /// instructions they are threads times cycles.
  uint64_t Finished = 0;

  uint64_t threads() const { return uint64_t(TmCount) * TpsPerTm; }
  uint64_t threadCycles() const { return threads() * Cycles; }
};

/// Everything of one run.
struct Profile {
  /// The counts of all instructions.
  ProfileCounts total() const;
  /// A frame and those around it, from the inside out.
  std::vector<uint32_t> framesFrom(uint32_t Innermost) const;

  ProfileRun Run;
  std::vector<ProfileFile> Files;
  std::vector<ProfileFunction> Functions;
  std::vector<ProfileFrame> Frames;
  /// Those with a count, in the order of addresses.
  std::vector<ProfileInstruction> Instructions;
  std::vector<CallNode> Calls;
  /// There were so many chains of calls that in the longest ones functions
  /// count for their callers.
  bool IsCallTreeCut = false;
  Utilisation Tms;
  /// What `tpsim --stats` writes of the run, but for counts by address, as
  /// compact JSON; empty if it is not known.
  std::string Statistics;
};

} // namespace tp

#endif // TP_SIMULATOR_PROFILE_PROFILE_H
