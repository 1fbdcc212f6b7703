//===- Comparison.cpp - What changed between two runs ---------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/compare/Comparison.h"

#include "llvm/ADT/STLExtras.h"

using namespace llvm;

namespace tp {

/// Puts what changed most first; what changed equally is ordered by name.
template <typename Change>
static void sortByChange(std::vector<Change> &Changes) {
  sort(Changes, [](const Change &A, const Change &B) {
    int64_t First = std::abs(A.change()), Second = std::abs(B.change());
    return First != Second ? First > Second : A.Name < B.Name;
  });
}

using PlaceMap = std::map<SourceLine, ComparedCounts>;

static std::vector<ComparedPlace> largestFirst(const PlaceMap &Places) {
  std::vector<ComparedPlace> Sorted;
  for (const auto &[Place, Counts] : Places)
    Sorted.push_back({Place, Counts});
  sortByChange(Sorted);
  return Sorted;
}

static void comparePlaces(Comparison &Runs) {
  PlaceMap Lines, Functions;
  auto Add = [&](const ComparedRun &Run, CycleCounts ComparedCounts::*Side) {
    for (const auto &[Place, Counts] : *Run.Lines) {
      add(Lines[Place].*Side, Counts);
      add(Functions[{Place.Function, Place.File, 0}].*Side, Counts);
    }
  };
  Add(Runs.Before, &ComparedCounts::Before);
  Add(Runs.After, &ComparedCounts::After);
  Runs.Lines = largestFirst(Lines);
  Runs.Functions = largestFirst(Functions);
}

static void compareOpcodes(Comparison &Runs) {
  std::map<std::string, ComparedOpcode> Opcodes;
  for (const auto &[Name, Count] : Runs.Before.Opcodes)
    Opcodes[Name].Before = Count;
  for (const auto &[Name, Count] : Runs.After.Opcodes)
    Opcodes[Name].After = Count;
  for (auto &[Name, Opcode] : Opcodes) {
    Opcode.Name = Name;
    Runs.Opcodes.push_back(Opcode);
  }
  sortByChange(Runs.Opcodes);
}

Expected<Comparison> compare(const ComparedRun &Before,
                             const ComparedRun &After) {
  if (Before.HasCycles != After.HasCycles) {
    const ComparedRun &Functional = Before.HasCycles ? After : Before;
    const ComparedRun &Timed = Before.HasCycles ? Before : After;
    return createStringError(
        Functional.Path + " is of a functional run, without cycles, but " +
        Timed.Path + " has them; compare runs of the same mode");
  }
  Comparison Runs{Before, After, {Before.Counts, After.Counts}, false, {},
                  {},     {}};
  Runs.HasPlaces =
      Before.Lines && After.Lines && Before.IsProfile == After.IsProfile;
  if (Runs.HasPlaces)
    comparePlaces(Runs);
  compareOpcodes(Runs);
  return Runs;
}

} // namespace tp
