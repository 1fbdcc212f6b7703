//===- ProfileReader.cpp - Runs from their profiles -----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/compare/RunReader.h"
#include "simulator/profile/ProfileJson.h"
#include "simulator/profile/ProfileNames.h"

#include "llvm/ADT/StringExtras.h"

using namespace llvm;

namespace tp {

static CycleCounts countsOf(const ProfileCounts &Counts) {
  CycleCounts Result{int64_t(Counts.Instructions)};
  for (unsigned Reason = 0; Reason != NumLosses; ++Reason)
    Result[useOf(Loss(Reason))] = int64_t(Counts.Lost[Reason]);
  return Result;
}

/// The source line of each frame.
static std::vector<SourceLine> linesOf(const Profile &Data) {
  std::vector<SourceLine> Lines;
  Lines.reserve(Data.Frames.size());
  for (const ProfileFrame &Frame : Data.Frames)
    Lines.push_back({Data.Functions[Frame.Function].Name,
                     Frame.File ? Data.Files[*Frame.File].Path : "",
                     Frame.Line});
  return Lines;
}

static void addFigures(const MemoryBehaviour &Memory, ComparedRun &Run) {
  static constexpr struct {
    const char *Name;
    ServedBy First;
    ServedBy Last;
  } Levels[] = {
      {"l1", ServedBy::L1, ServedBy::L1},
      {"l2", ServedBy::L2, ServedBy::L2},
      {"dram", ServedBy::DramQueue, ServedBy::DramRowConflict},
      {"memory", ServedBy::Memory, ServedBy::Memory},
  };
  for (const auto &[Level, First, Last] : Levels) {
    ServedAccesses Served = servedBetween(Memory, First, Last);
    if (Served.Accesses == 0)
      continue;
    std::string Name = Level;
    Run.Figures.push_back(
        {"served by " + Name, Figure::Count, double(Served.Accesses)});
    Run.Figures.push_back({"cycles to " + Name, Figure::Number,
                           double(Served.Cycles) / double(Served.Accesses)});
  }
}

Expected<ComparedRun> readProfileRun(StringRef Text, StringRef Path) {
  Expected<Profile> Data = parseProfile(Text, Path);
  if (!Data)
    return Data.takeError();
  ComparedRun Run;
  Run.IsProfile = true;
  Run.Outcome = Data->Run.Outcome;
  Run.Chip = Data->Run.Chip;
  Run.TmCount = Data->Run.TmCount;
  Run.TpsPerTm = Data->Run.TpsPerTm;
  Run.Cycles = Data->Run.Cycles;
  Run.Counts[useOf(Loss::Finished)] = int64_t(Data->Run.Finished);
  Run.Lines.emplace();
  std::vector<SourceLine> Lines = linesOf(*Data);
  MemoryBehaviour Memory;
  for (const ProfileInstruction &Entry : Data->Instructions) {
    CycleCounts Counts = countsOf(Entry.Counts);
    add((*Run.Lines)[Lines[Entry.Frame]], Counts);
    add(Run.Counts, Counts);
    Run.Opcodes[StringRef(Entry.Text).take_until(isSpace).str()] += Counts[0];
    Memory += Entry.Memory;
  }
  if (!Data->Statistics.empty())
    readFigures(*cantFail(json::parse(Data->Statistics)).getAsObject(), Run);
  addFigures(Memory, Run);
  return Run;
}

} // namespace tp
