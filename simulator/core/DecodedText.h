//===- DecodedText.h - A program's text, ready for a chip -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_DECODEDTEXT_H
#define TP_SIMULATOR_CORE_DECODEDTEXT_H

#include "simulator/core/CodeGenerator.h"
#include "simulator/core/Handlers.h"
#include "simulator/core/Program.h"
#include "simulator/core/ResourceLayout.h"

#include <vector>

namespace tp {

/// The handler of the word \p Number of the text. One that is observed tells
/// the recorder.
template <class Word, bool FlushToZero>
Handler<Word> handlerOf(const Program &Text, uint32_t Number,
                        bool IsObserved = false) {
  std::span<const Instruction> Words = Text.instructions();
  bool StackHasMoved = Text.stackLimit() != 0 && Number != 0 &&
                       movesStackPointer(Words[Number - 1]);
  auto In = [&](auto Mode) {
    using Of = Handlers<Word, Mode()>;
    if (StackHasMoved)
      return Of::afterStackMove(IsObserved);
    Opcode Op = Words[Number].Op;
    return IsObserved ? Of::observed(Op) : Of::of(Op);
  };
  if constexpr (!FlushToZero)
    return In(std::integral_constant<Subnormals, Subnormals::Keep>());
  if (Text.isFloatChecked(Text.textBegin() + Number * 4))
    return In(std::integral_constant<Subnormals, Subnormals::Trap>());
  return In(std::integral_constant<Subnormals, Subnormals::Flush>());
}

/// The text with the handler of each instruction, one slot per word and one
/// behind it.
template <class Word, bool FlushToZero>
std::vector<Slot<Word>> decodeText(const Program &Text, const ChipConfig &Chip,
                                   const ResourceLayout &Layout) {
  constexpr Subnormals Mode =
      FlushToZero ? Subnormals::Flush : Subnormals::Keep;
  std::vector<Slot<Word>> Slots;
  // Decides on the bank. Messages are as if they were not in the text.
  uint32_t Fetches = Text.textBegin() / 4;
  for (const Instruction &Decoded : Text.instructions()) {
    auto Number = uint32_t(Slots.size());
    Slot<Word> S{0, handlerOf<Word, FlushToZero>(Text, Number), Decoded, 0,
                 Number};
    bool IsMessage = Decoded.Op != IllegalOpcode && !takesTime(Decoded.Op);
    if (Decoded.Op != IllegalOpcode && !IsMessage) {
      uint32_t Bank = Fetches % Chip.IcacheBanks;
      S.Use = Word(Layout.use(unitOf(Decoded.Op), Bank));
      S.Result = ready::after(
          Chip.Latency[unsigned(latencyClassOf(Decoded.Op))], Decoded.Op);
    }
    Slots.push_back(S);
    if (!IsMessage)
      ++Fetches;
  }
  Slots.push_back(
      {0, Handlers<Word, Mode>::endOfText(), {}, 0, uint32_t(Slots.size())});
  return Slots;
}

/// What a code generator must know of \p Slots, which decodeText() made. What
/// it points to are the arguments.
template <class Word>
CodeSubject describeText(const std::vector<Slot<Word>> &Slots,
                         const Program &Text, const ChipContext &Context,
                         const ResourceLayout &Layout, bool FlushToZero) {
  CodeSubject Result;
  Result.Text = &Text;
  Result.Context = &Context;
  Result.FlushToZero = FlushToZero;
  Result.Guards = Layout.guards();
  Result.Slots = Slots.data();
  Result.SlotBytes = sizeof(Slot<Word>);
  Result.HandlerOffset = offsetof(Slot<Word>, Execute);
  Result.WordBytes = sizeof(Word);
  for (const Slot<Word> &S : Slots) {
    Result.Interpreter.push_back(reinterpret_cast<const void *>(S.Execute));
    Result.Uses.push_back(S.Use);
    Result.Results.push_back(S.Result);
  }
  Result.WaitForTarget = reinterpret_cast<const void *>(
      Handlers<Word, Subnormals::Keep>::afterTakenBranch());
  return Result;
}

} // namespace tp

#endif // TP_SIMULATOR_CORE_DECODEDTEXT_H
