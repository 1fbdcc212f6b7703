//===- FunctionMap.cpp - The functions of a text --------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/core/FunctionMap.h"

#include <algorithm>
#include <optional>

namespace tp {

/// The word to which the instruction in \p Word goes by its immediate, if it
/// is one of the text.
static std::optional<uint32_t> targetOf(std::span<const Instruction> Text,
                                        uint32_t Word) {
  int64_t Target = int64_t(Word) + Text[Word].Immediate / 4;
  if (Target < 0 || Target >= int64_t(Text.size()))
    return std::nullopt;
  return uint32_t(Target);
}

FunctionMap::FunctionMap(const Program &Text, std::vector<uint32_t> Begins)
    : Entries(std::move(Begins)) {
  std::span<const Instruction> Words = Text.instructions();
  Entries.push_back(0);
  Entries.push_back((Text.entry() - Text.textBegin()) / 4);
  for (uint32_t Word = 0; Word != Words.size(); ++Word)
    if (Words[Word].Op == Opcode::JAL)
      if (std::optional<uint32_t> Target = targetOf(Words, Word))
        Entries.push_back(*Target);
  std::ranges::sort(Entries);
  auto Twice = std::ranges::unique(Entries);
  Entries.erase(Twice.begin(), Twice.end());

  uint32_t Function = 0;
  for (uint32_t Word = 0; Word != Words.size(); ++Word) {
    if (Function + 1 < Entries.size() && Entries[Function + 1] == Word)
      ++Function;
    FunctionOfWord.push_back(Function);
  }
}

static Transfer transferOf(std::span<const Instruction> Text, uint32_t Word,
                           const FunctionMap &Functions) {
  const Instruction &Decoded = Text[Word];
  switch (Decoded.Op) {
  case Opcode::JAL:
  case Opcode::JALR:
  case Opcode::BLTZAL:
  case Opcode::BGEZAL:
    return Transfer::Call;
  case Opcode::JR:
    return Decoded.Source[0] == LinkRegister ? Transfer::Return
                                             : Transfer::Jump;
  case IllegalOpcode:
    return Transfer::None;
  default:
    break;
  }
  if (!takesTime(Decoded.Op) ||
      latencyClassOf(Decoded.Op) != LatencyClass::Branch)
    return Transfer::None;
  std::optional<uint32_t> Target = targetOf(Text, Word);
  bool Leaves =
      Target && Functions.functionOf(*Target) != Functions.functionOf(Word);
  return Leaves ? Transfer::Jump : Transfer::None;
}

std::vector<Transfer> transfersOf(const Program &Text,
                                  const FunctionMap &Functions) {
  std::vector<Transfer> Result;
  for (uint32_t Word = 0; Word != Text.instructions().size(); ++Word)
    Result.push_back(transferOf(Text.instructions(), Word, Functions));
  return Result;
}

} // namespace tp
