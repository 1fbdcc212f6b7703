//===- ModelExecution.cpp - What instructions do in the model -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/oracle/ModelContext.h"

namespace tp::test {

namespace {

template <Opcode Op, Subnormals Mode>
ModelEffects executeBody(ScoreboardModel &Model, ModelThread &T,
                         const Instruction &Decoded) {
  uint32_t Values[NumRegisters];
  for (unsigned I = 0; I != NumRegisters; ++I)
    Values[I] = T.Registers[I].Value;
  Body<Op> Run(Decoded, Values);
  ModelContext<Mode> Context(Model, T, Op);
  Run.run(Context);
  if constexpr (Body<Op>::HasDestination) {
    Context.Effects.HasResult = !Context.keeps();
    Context.Effects.Result = Run.result();
  }
  return Context.Effects;
}

template <Subnormals Mode>
ModelEffects executeIn(ScoreboardModel &Model, ModelThread &T,
                       const Instruction &Decoded) {
  using Function =
      ModelEffects (*)(ScoreboardModel &, ModelThread &, const Instruction &);
#define TP_FUNCTION_OF(NAME) executeBody<Opcode::NAME, Mode>,
  static constexpr Function Table[] = {TP_EACH_OPCODE(TP_FUNCTION_OF)};
#undef TP_FUNCTION_OF
  return Table[unsigned(Decoded.Op)](Model, T, Decoded);
}

} // namespace

ModelEffects ScoreboardModel::execute(ModelThread &T, const Instruction &I) {
  if (!Chip.FlushToZero)
    return executeIn<Subnormals::Keep>(*this, T, I);
  if (Text.isFloatChecked(T.Pc))
    return executeIn<Subnormals::Trap>(*this, T, I);
  return executeIn<Subnormals::Flush>(*this, T, I);
}

} // namespace tp::test
