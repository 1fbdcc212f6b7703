//===- Segment.cpp - Instructions that are compiled together --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/jit/Segment.h"

#include <algorithm>
#include <bitset>

namespace tp {

namespace {

/// Registers whose values are still on their way from memory.
class LoadedRegisters {
public:
  bool isUsedBy(const Instruction &Decoded) const {
    return std::ranges::any_of(
        Decoded.Source, [this](uint8_t Source) { return Loaded[Source]; });
  }

  void step(const Instruction &Decoded) {
    if (Decoded.Destination != NoRegister)
      Loaded[Decoded.Destination] =
          isLoad(Decoded.Op) && Decoded.Source[0] != StackPointerRegister;
  }

private:
  std::bitset<NumRegisters> Loaded;
};

} // namespace

static bool isCompiled(const CodeSubject &Subject, uint32_t Word) {
  std::span<const Instruction> Text = Subject.Text->instructions();
  return Word < Text.size() && Subject.Interpreter[Word] &&
         flowOf(Text[Word].Op) != Flow::Special;
}

/// Whether more threads take the branch in \p Word than do not.
static bool isMostlyTaken(uint32_t Word, std::span<const uint64_t> ExecutedAt) {
  return Word + 1 < ExecutedAt.size() &&
         ExecutedAt[Word + 1] * 2 < ExecutedAt[Word];
}

Segment formSegment(const CodeSubject &Subject, uint32_t Head,
                    std::span<const uint64_t> ExecutedAt,
                    const std::vector<bool> &IsHead) {
  std::span<const Instruction> Text = Subject.Text->instructions();
  bool FollowsTaken = Subject.Context->BranchLatency == 1;
  Segment Result;
  LoadedRegisters Loaded;
  for (uint32_t Word = Head;
       Result.size() < MaxSegmentSteps && isCompiled(Subject, Word);) {
    const Instruction &Decoded = Text[Word];
    bool IsJoin = Word != Head && IsHead[Word];
    bool IsOtherLine =
        !Subject.LineOf.empty() && Subject.LineOf[Word] != Subject.LineOf[Head];
    if (IsJoin || IsOtherLine || Loaded.isUsedBy(Decoded) ||
        std::ranges::find(Result, Word, &SegmentStep::Word) != Result.end())
      break;
    Loaded.step(Decoded);
    Flow Kind = flowOf(Decoded.Op);
    std::optional<uint32_t> Target;
    if (FollowsTaken &&
        (Kind == Flow::Jump ||
         (Kind == Flow::Branch && isMostlyTaken(Word, ExecutedAt))))
      Target = targetOf(Decoded, Word, uint32_t(Text.size()));
    Result.push_back({Word, Target.has_value()});
    if (Kind == Flow::IndirectJump || (Kind == Flow::Jump && !Target))
      break;
    Word = Target.value_or(Word + 1);
  }
  return Result;
}

std::vector<uint32_t> successorsOf(const CodeSubject &Subject,
                                   const Segment &Steps) {
  std::span<const Instruction> Text = Subject.Text->instructions();
  std::vector<uint32_t> Result;
  for (const SegmentStep &Step : Steps) {
    const Instruction &Decoded = Text[Step.Word];
    Flow Kind = flowOf(Decoded.Op);
    bool IsLast = &Step == &Steps.back();
    bool HasTarget = Kind == Flow::Branch || Kind == Flow::Jump;
    if (HasTarget && (!Step.FollowsTarget || IsLast))
      if (std::optional<uint32_t> Target =
              targetOf(Decoded, Step.Word, uint32_t(Text.size())))
        Result.push_back(*Target);
    bool MayGoOn = Kind == Flow::Next || Kind == Flow::Branch;
    bool GoesOn = MayGoOn && (IsLast || Step.FollowsTarget);
    if ((GoesOn || isCall(Decoded.Op)) && Step.Word + 1 < Text.size())
      Result.push_back(Step.Word + 1);
  }
  return Result;
}

} // namespace tp
