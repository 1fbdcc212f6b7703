//===- Trace.cpp - Instructions that are compiled together ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/functional/Trace.h"

#include "simulator/jit/ControlFlow.h"

#include <algorithm>
#include <span>

namespace tp {

/// Long enough for the bodies of most loops, short enough to compile quickly.
static constexpr size_t MaxTraceSteps = 64;

static bool isCompiled(std::span<const Instruction> Text, uint32_t Word) {
  if (Word >= Text.size())
    return false;
  Opcode Op = Text[Word].Op;
  return flowOf(Op) != Flow::Special && takesTime(Op) && Op != Opcode::MFSR;
}

/// Whether more threads take the branch in \p Word than do not. Every taken
/// one ends a block there.
static bool isMostlyTaken(const FunctionalSubject &Subject, uint32_t Word,
                          uint64_t Executed) {
  return Subject.Runner->Slots[Word + 1].Ended * 2 > Executed;
}

Trace formTrace(const FunctionalSubject &Subject, uint32_t Head,
                std::span<const uint64_t> Executed) {
  std::span<const Instruction> Text = Subject.Text->instructions();
  Trace Result;
  std::vector<uint32_t> Callers;
  for (uint32_t Word = Head;
       Result.size() < MaxTraceSteps && isCompiled(Text, Word);) {
    if (std::ranges::find(Result, Word, &TraceStep::Word) != Result.end())
      break;
    const Instruction &Decoded = Text[Word];
    TraceStep &Step = Result.emplace_back(TraceStep{Word, {}, false});
    Flow Kind = flowOf(Decoded.Op);
    if (Kind == Flow::Branch || Kind == Flow::Jump)
      Step.Target = targetOf(Decoded, Word, uint32_t(Text.size()));
    if (isCall(Decoded.Op))
      Callers.push_back(Word + 1);
    if (Decoded.Op == Opcode::JR && !Callers.empty()) {
      Step.Target = Callers.back();
      Callers.pop_back();
    }
    bool MayGoOn = Kind == Flow::Next || Kind == Flow::Branch;
    if (!MayGoOn && !Step.Target)
      break;
    Step.FollowsTarget =
        !MayGoOn ||
        (Step.Target && isMostlyTaken(Subject, Word, Executed[Word]));
    Word = Step.FollowsTarget ? *Step.Target : Word + 1;
  }
  return Result;
}

std::vector<uint32_t> exitsOf(const FunctionalSubject &Subject,
                              const Trace &Steps) {
  std::span<const Instruction> Text = Subject.Text->instructions();
  std::vector<uint32_t> Result;
  for (const TraceStep &Step : Steps) {
    Opcode Op = Text[Step.Word].Op;
    Flow Kind = flowOf(Op);
    bool IsLast = &Step == &Steps.back();
    if (Step.Target && (IsLast || !Step.FollowsTarget))
      Result.push_back(*Step.Target);
    bool MayGoOn = Kind == Flow::Next || Kind == Flow::Branch;
    if ((MayGoOn && (IsLast || Step.FollowsTarget)) || isCall(Op))
      Result.push_back(Step.Word + 1);
  }
  return Result;
}

} // namespace tp
