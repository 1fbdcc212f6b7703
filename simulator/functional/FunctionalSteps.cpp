//===- FunctionalSteps.cpp - The instructions as functions ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Compiled to bitcode only: see FunctionalStep.h.
//
//===----------------------------------------------------------------------===//

#include "simulator/functional/FunctionalContext.h"
#include "simulator/functional/FunctionalStep.h"

using namespace tp;

namespace {

template <Opcode Op, Subnormals Mode>
[[gnu::always_inline]] inline void
step(FunctionalThread *T, FunctionalContextState *Shared, uint32_t Pc,
     const Instruction &Decoded, const uint32_t *Sources,
     FunctionalStepResult *Result) {
  using Context = FunctionalContext<Mode>;
  static_assert(unsigned(Context::Outcome::Next) == FunctionalStepNext &&
                unsigned(Context::Outcome::Branch) == FunctionalStepBranch);
  Body<Op> Run(Decoded, Sources);
  // Who asks for the counters is left to the interpreter.
  Context C(*T, *Shared, Pc, /*Issued=*/0);
  Run.run(C);
  Result->Value = Run.result();
  Result->TargetWord = C.targetWord();
  Result->Kind = uint8_t(C.outcome());
}

} // namespace

#define TP_STEP(NAME, MODE)                                                    \
  extern "C" [[gnu::always_inline]] void tp##MODE##NAME(                       \
      FunctionalThread *T, FunctionalContextState *Shared, uint32_t Pc,        \
      int32_t Immediate, uint8_t SecondImmediate, uint32_t First,              \
      uint32_t Second, uint32_t Third, FunctionalStepResult *Result) {         \
    const uint32_t Sources[] = {First, Second, Third};                         \
    step<Opcode::NAME, Subnormals::MODE>(                                      \
        T, Shared, Pc,                                                         \
        {Immediate, Opcode::NAME, NoRegister, {0, 1, 2}, SecondImmediate},     \
        Sources, Result);                                                      \
  }
#define TP_STEPS(NAME)                                                         \
  TP_STEP(NAME, Keep) TP_STEP(NAME, Flush) TP_STEP(NAME, Trap)

TP_EACH_OPCODE(TP_STEPS)
