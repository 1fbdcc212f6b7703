//===- InstructionCache.cpp - Which instructions a TM has at hand --------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/core/InstructionCache.h"

#include <algorithm>
#include <tuple>

namespace tp {

std::vector<uint32_t> linesOfText(const Program &Text, const ChipConfig &Chip) {
  std::vector<uint32_t> Lines;
  uint32_t Address = Text.textBegin();
  for (const Instruction &Decoded : Text.instructions()) {
    if (Decoded.Op != IllegalOpcode && !takesTime(Decoded.Op)) {
      Lines.push_back(NoLine);
      continue;
    }
    Lines.push_back(Address / Chip.IcacheLineBytes);
    Address += 4;
  }
  return Lines;
}

InstructionCache::InstructionCache(const ChipConfig &Chip)
    : Sets(Chip.IcacheBytes / (Chip.IcacheLineBytes * Chip.IcacheWays),
           Set(Chip.IcacheWays, NoLine)) {}

bool InstructionCache::holds(const Set &Lines, uint32_t Line) {
  return std::find(Lines.begin(), Lines.end(), Line) != Lines.end();
}

void InstructionCache::put(Set &Lines, uint32_t Line) {
  Lines.erase(Lines.begin());
  Lines.push_back(Line);
}

void InstructionCache::beginWindow(uint64_t Start) {
  auto End = std::find_if(Fills.begin(), Fills.end(),
                          [&](const Fill &F) { return F.Cycle > Start; });
  for (auto Next = Fills.begin(); Next != End; ++Next)
    put(setOf(Next->Line), Next->Line);
  Fills.erase(Fills.begin(), End);
}

uint64_t InstructionCache::lookUp(uint32_t Line, uint64_t Cycle) {
  ++Counts.Lookups;
  bool IsThere = holds(setOf(Line), Line);
  uint64_t Comes = Unknown;
  if (!Fills.empty()) {
    Set Lines = setOf(Line);
    for (const Fill &Next : Fills) {
      if (Next.Line % Sets.size() != Line % Sets.size())
        continue;
      if (Next.Cycle <= Cycle)
        put(Lines, Next.Line);
      else if (Next.Line == Line)
        Comes = Next.Cycle;
    }
    IsThere = holds(Lines, Line);
  }
  if (IsThere)
    return Cycle;
  if (Comes != Unknown)
    ++Counts.Merged;
  return Comes;
}

std::vector<InstructionCache::Miss>
InstructionCache::takeMisses(uint64_t Limit) {
  auto Rest = std::partition(Misses.begin(), Misses.end(),
                             [&](const Miss &M) { return M.Cycle < Limit; });
  std::vector<Miss> Taken(Misses.begin(), Rest);
  Misses.erase(Misses.begin(), Rest);
  std::sort(Taken.begin(), Taken.end(), [](const Miss &A, const Miss &B) {
    return std::tie(A.Cycle, A.Priority) < std::tie(B.Cycle, B.Priority);
  });
  return Taken;
}

bool InstructionCache::isAskedFor(uint32_t Line, uint64_t Cycle) {
  if (holds(AskedFor, Line) || arrivalOf(Line, Cycle) != Unknown) {
    ++Counts.Merged;
    return true;
  }
  ++Counts.Misses;
  AskedFor.push_back(Line);
  return false;
}

void InstructionCache::arrives(uint32_t Line, uint64_t Cycle) {
  std::erase(AskedFor, Line);
  auto Place = std::find_if(Fills.begin(), Fills.end(), [&](const Fill &F) {
    return std::tie(F.Cycle, F.Line) > std::tie(Cycle, Line);
  });
  Fills.insert(Place, {Cycle, Line});
}

uint64_t InstructionCache::arrivalOf(uint32_t Line, uint64_t Cycle) const {
  for (const Fill &Next : Fills)
    if (Next.Line == Line && Next.Cycle > Cycle)
      return Next.Cycle;
  return Unknown;
}

void InstructionCache::serialize(Archive &A) {
  A(Sets);
  A(Fills);
  A(AskedFor);
  A(Counts);
}

} // namespace tp
