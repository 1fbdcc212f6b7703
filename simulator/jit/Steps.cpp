//===- Steps.cpp - The instructions as functions --------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Compiled to bitcode only: see Step.h.
//
//===----------------------------------------------------------------------===//

#include "simulator/core/ExecutionContext.h"
#include "simulator/jit/Step.h"

using namespace tp;

namespace {

/// The operands of a step: those of the text are constants of generated code.
struct StepOperands {
  uint32_t Word;
  Instruction Decoded;
  ReadyWord Result;
  uint32_t Sources[3];
};

} // namespace

template <Opcode Op, Subnormals Mode>
[[gnu::always_inline]] static inline void
step(Thread *T, TmRunnerState *Runner, uint64_t Cycle,
     const StepOperands &Operands, StepResult *Result) {
  using Context = ExecutionContext<Op, Mode>;
  static_assert(unsigned(Context::Outcome::Next) == StepNext &&
                unsigned(Context::Outcome::Branch) == StepBranch);
  Body<Op> Run(Operands.Decoded, Operands.Sources);
  Context C(*T, *Runner, Operands.Word, Runner->IssuedAt[Operands.Word], Cycle,
            Operands.Decoded.Destination, Operands.Result);
  Run.run(C);
  Result->Value = Run.result();
  Result->Ready = C.resultReady();
  Result->TargetWord = C.targetWord();
  Result->Kind = uint8_t(C.outcome());
}

#define TP_STEP(NAME, MODE)                                                    \
  extern "C" [[gnu::always_inline]] void tp##MODE##NAME(                       \
      Thread *T, TmRunnerState *Runner, uint64_t Cycle, uint32_t Word,         \
      int32_t Immediate, uint8_t SecondImmediate, uint8_t Destination,         \
      ReadyWord Ready, uint32_t First, uint32_t Second, uint32_t Third,        \
      StepResult *Result) {                                                    \
    step<Opcode::NAME, Subnormals::MODE>(                                      \
        T, Runner, Cycle,                                                      \
        {Word,                                                                 \
         {Immediate, Opcode::NAME, Destination, {0, 1, 2}, SecondImmediate},   \
         Ready,                                                                \
         {First, Second, Third}},                                              \
        Result);                                                               \
  }
#define TP_STEPS(NAME)                                                         \
  TP_STEP(NAME, Keep) TP_STEP(NAME, Flush) TP_STEP(NAME, Trap)

TP_EACH_OPCODE(TP_STEPS)
