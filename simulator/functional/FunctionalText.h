//===- FunctionalText.h - A text, ready for the functional mode -*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_FUNCTIONAL_FUNCTIONALTEXT_H
#define TP_SIMULATOR_FUNCTIONAL_FUNCTIONALTEXT_H

#include "simulator/core/Program.h"
#include "simulator/functional/FunctionalHandlers.h"

#include <vector>

namespace tp {

/// The handler of \p Op; behind an instruction that has moved the stack pointer
/// the one that looks at it first.
template <class Checks>
FunctionalHandler functionalHandler(Opcode Op, bool StackHasMoved,
                                    Subnormals Mode) {
  auto choose = [&]<class Handlers>(Handlers) {
    return StackHasMoved ? Handlers::afterStackMove() : Handlers::of(Op);
  };
  switch (Mode) {
  case Subnormals::Keep:
    return choose(FunctionalHandlers<Subnormals::Keep, Checks>());
  case Subnormals::Flush:
    return choose(FunctionalHandlers<Subnormals::Flush, Checks>());
  case Subnormals::Trap:
    return choose(FunctionalHandlers<Subnormals::Trap, Checks>());
  }
  __builtin_unreachable();
}

/// The text with the handler of each instruction, one slot per word and one
/// behind it. \p FlushToZero as in the chip's description. Checks want to know
/// of each move of the stack pointer, others only if the stack has a limit.
template <class Checks>
std::vector<FunctionalSlot>
decodeWithChecks(const Program &Text, bool FlushToZero, bool WatchesStack) {
  std::vector<FunctionalSlot> Slots;
  uint32_t Address = Text.textBegin();
  bool StackHasMoved = false;
  for (const Instruction &Decoded : Text.instructions()) {
    Subnormals Mode = !FlushToZero                   ? Subnormals::Keep
                      : Text.isFloatChecked(Address) ? Subnormals::Trap
                                                     : Subnormals::Flush;
    Slots.push_back(
        {functionalHandler<Checks>(Decoded.Op, StackHasMoved, Mode), Decoded});
    StackHasMoved = WatchesStack && movesStackPointer(Decoded);
    Address += 4;
  }
  Slots.push_back({FunctionalHandlers<Subnormals::Keep, Checks>::endOfText(),
                   Instruction()});
  return Slots;
}

/// The same without checks.
std::vector<FunctionalSlot> decodeFunctional(const Program &Text,
                                             bool FlushToZero);

} // namespace tp

#endif // TP_SIMULATOR_FUNCTIONAL_FUNCTIONALTEXT_H
