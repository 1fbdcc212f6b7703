//===- HotSpots.cpp - Where code is worth compiling -----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/jit/HotSpots.h"

#include <algorithm>

namespace tp {

/// Whether many executions of a word do not come from the word before it.
static bool isEntered(std::span<const uint64_t> Interpreted, uint32_t Word) {
  uint64_t Before = Word == 0 ? 0 : Interpreted[Word - 1];
  return Interpreted[Word] > Before + Before / 4;
}

std::vector<Segment> HotSpots::choose(const CodeSubject &Subject,
                                      std::span<const uint64_t> Interpreted,
                                      std::span<const uint64_t> Executed,
                                      uint64_t HotCount) {
  auto NumWords = uint32_t(Subject.Text->instructions().size());
  IsHead.resize(NumWords);
  std::vector<uint32_t> Heads;
  auto AddHead = [&](uint32_t Word) {
    if (IsHead[Word] || Interpreted[Word] < HotCount)
      return;
    IsHead[Word] = true;
    Heads.push_back(Word);
  };
  AddHead((Subject.Text->entry() - Subject.Text->textBegin()) / 4);
  std::span<const Instruction> Text = Subject.Text->instructions();
  for (uint32_t Word = 0; Word != NumWords; ++Word) {
    if (isEntered(Interpreted, Word))
      AddHead(Word);
    Flow Kind = flowOf(Text[Word].Op);
    bool HasTarget = Kind == Flow::Branch || Kind == Flow::Jump;
    if (HasTarget && Interpreted[Word] >= HotCount)
      if (std::optional<uint32_t> Target = targetOf(Text[Word], Word, NumWords))
        AddHead(*Target);
  }

  for (size_t I = 0; I != Heads.size(); ++I) {
    Segment Steps = formSegment(Subject, Heads[I], Executed, IsHead);
    for (uint32_t Next : successorsOf(Subject, Steps))
      AddHead(Next);
    if (Steps.empty() && Heads[I] + 1 < NumWords)
      AddHead(Heads[I] + 1);
  }
  // Now that all are known, none runs into another.
  std::vector<Segment> Result;
  for (uint32_t Head : Heads)
    if (Segment Steps = formSegment(Subject, Head, Executed, IsHead);
        !Steps.empty())
      Result.push_back(std::move(Steps));
  std::ranges::sort(Result, std::greater(), [&](const Segment &Steps) {
    return std::pair(Executed[Steps.front().Word], Steps.front().Word);
  });
  return Result;
}

} // namespace tp
