//===- TrapMessage.cpp - A trap in words ----------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/TrapMessage.h"

#include "llvm/Support/Format.h"
#include "llvm/Support/raw_ostream.h"

using namespace llvm;

namespace tp {

static FormattedNumber address(uint32_t Value) { return format_hex(Value, 10); }

/// True for an address so little below the local stores that it must come from
/// a stack that has outgrown them.
static bool isBelowLocalStore(uint32_t Address, const ChipConfig &Chip) {
  uint64_t Begin = (uint64_t(1) << 32) - Chip.LocalStoreBytes;
  constexpr uint64_t LargestLikelyFrame = 1 << 20;
  return Address < Begin && Address >= Begin - LargestLikelyFrame &&
         Address >= Chip.MemoryBytes;
}

std::string trapMessage(const Trap &T, const ChipConfig &Chip,
                        const Program &Text, Symbolizer &Symbols) {
  std::string Message;
  raw_string_ostream OS(Message);
  OS << "thread " << T.Thread << " (TM " << T.Thread / Chip.TpsPerTm << ", TP "
     << T.Thread % Chip.TpsPerTm << ") trapped at cycle " << T.Cycle << ": "
     << T.what();
  if (T.Kind == TrapKind::AddressOutOfRange &&
      isBelowLocalStore(T.Address, Chip))
    OS << "\n  stack overflow: the local store of " << Chip.LocalStoreBytes
       << " bytes begins at " << address(uint32_t(0) - Chip.LocalStoreBytes);

  OS << "\n  pc " << address(T.Pc);
  std::vector<SourceFrame> Frames = Symbols.frames(T.Pc);
  for (size_t I = 0; I != Frames.size(); ++I)
    OS << (I ? "\n    inlined " : " ") << Symbolizer::describe(Frames[I]);

  if (T.Pc >= Text.textBegin() && T.Pc < Text.textEnd()) {
    const Instruction &Trapped =
        Text.instructions()[(T.Pc - Text.textBegin()) / 4];
    if (Trapped.Op != IllegalOpcode)
      OS << "\n  instruction " << mnemonic(Trapped.Op);
  }
  return Message;
}

} // namespace tp
