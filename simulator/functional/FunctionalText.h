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

/// What the instruction before has done to the stack pointer.
enum class StackChange : uint8_t {
  None,
  /// It has written it.
  Written,
  /// It has moved it, so that it may be too low now.
  Moved,
};

/// The handler of \p Op behind an instruction that has done \p Change.
template <class Checks>
FunctionalHandler functionalHandler(Opcode Op, StackChange Change,
                                    Subnormals Mode) {
  auto Choose = [&]<class Handlers>(Handlers) {
    switch (Change) {
    case StackChange::None:
      return Handlers::of(Op);
    case StackChange::Written:
      return Handlers::afterStackWrite();
    case StackChange::Moved:
      return Handlers::afterStackMove();
    }
    __builtin_unreachable();
  };
  switch (Mode) {
  case Subnormals::Keep:
    return Choose(FunctionalHandlers<Subnormals::Keep, Checks>());
  case Subnormals::Flush:
    return Choose(FunctionalHandlers<Subnormals::Flush, Checks>());
  case Subnormals::Trap:
    return Choose(FunctionalHandlers<Subnormals::Trap, Checks>());
  }
  __builtin_unreachable();
}

/// The text with the handler of each instruction, one slot per word and one
/// behind it. \p FlushToZero as in the chip's description. \p WatchesStack:
/// the checks want to know of each write of the stack pointer.
template <class Checks>
std::vector<FunctionalSlot>
decodeWithChecks(const Program &Text, bool FlushToZero, bool WatchesStack) {
  std::vector<FunctionalSlot> Slots;
  uint32_t Address = Text.textBegin();
  StackChange Change = StackChange::None;
  for (const Instruction &Decoded : Text.instructions()) {
    Subnormals Mode = !FlushToZero                   ? Subnormals::Keep
                      : Text.isFloatChecked(Address) ? Subnormals::Trap
                                                     : Subnormals::Flush;
    Slots.push_back(
        {functionalHandler<Checks>(Decoded.Op, Change, Mode), Decoded});
    if (Text.stackLimit() != 0 && movesStackPointer(Decoded))
      Change = StackChange::Moved;
    else if (WatchesStack && Decoded.Destination == StackPointerRegister)
      Change = StackChange::Written;
    else
      Change = StackChange::None;
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
