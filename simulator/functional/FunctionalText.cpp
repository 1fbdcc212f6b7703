//===- FunctionalText.cpp - A text, ready for the functional mode ---------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/functional/FunctionalText.h"

namespace tp {

template <Subnormals Mode>
static FunctionalHandler handlerOf(Opcode Op, bool StackHasMoved) {
  return StackHasMoved ? FunctionalHandlers<Mode>::afterStackMove()
                       : FunctionalHandlers<Mode>::of(Op);
}

static FunctionalHandler handlerOf(Opcode Op, bool StackHasMoved,
                                   Subnormals Mode) {
  switch (Mode) {
  case Subnormals::Keep:
    return handlerOf<Subnormals::Keep>(Op, StackHasMoved);
  case Subnormals::Flush:
    return handlerOf<Subnormals::Flush>(Op, StackHasMoved);
  case Subnormals::Trap:
    return handlerOf<Subnormals::Trap>(Op, StackHasMoved);
  }
  __builtin_unreachable();
}

std::vector<FunctionalSlot> decodeFunctional(const Program &Text,
                                             bool FlushToZero) {
  std::vector<FunctionalSlot> Slots;
  uint32_t Address = Text.textBegin();
  bool StackHasMoved = false;
  for (const Instruction &Decoded : Text.instructions()) {
    Subnormals Mode = !FlushToZero                   ? Subnormals::Keep
                      : Text.isFloatChecked(Address) ? Subnormals::Trap
                                                     : Subnormals::Flush;
    Slots.push_back({handlerOf(Decoded.Op, StackHasMoved, Mode), Decoded});
    StackHasMoved = Text.stackLimit() != 0 && movesStackPointer(Decoded);
    Address += 4;
  }
  Slots.push_back(
      {FunctionalHandlers<Subnormals::Keep>::endOfText(), Instruction()});
  return Slots;
}

} // namespace tp
