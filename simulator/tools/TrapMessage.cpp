//===- TrapMessage.cpp - A trap in words ----------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/TrapMessage.h"

#include "llvm-backend/FloatingPoint/Check/CheckFailure.h"
#include "simulator/isa/Instructions.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/Endian.h"
#include "llvm/Support/Format.h"
#include "llvm/Support/MathExtras.h"
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

/// What the failed check that ends in a `break` says of itself; nothing for
/// another trap.
static std::optional<std::string>
failedCheck(const Trap &T, const RegisterFunction &Registers) {
  if (T.Kind != TrapKind::Break || !CheckFailure::isCode(T.Address))
    return std::nullopt;
  // CheckFailure.h: the low words, then the high words.
  constexpr unsigned FirstLow = 4, FirstHigh = 7;
  std::array<uint64_t, 3> Values;
  for (unsigned I = 0; I != Values.size(); ++I)
    Values[I] = Make_64(Registers(FirstHigh + I), Registers(FirstLow + I));
  return CheckFailure::fromCode(T.Address).describe(Values);
}

/// Takes from \p Frames the innermost one if it only names the check of
/// -fsanitize= that ended in the trap: clang makes it a function
/// `__clang_trap_msg$<category>$<reason>`.
/// \returns the check in words, or nothing.
static std::optional<std::string>
takeSanitizerCheck(std::vector<SourceFrame> &Frames) {
  if (Frames.empty())
    return std::nullopt;
  StringRef Reason = Frames.front().Function;
  if (!Reason.consume_front("__clang_trap_msg$"))
    return std::nullopt;
  StringRef Category;
  std::tie(Category, Reason) = Reason.split('$');
  std::string Text =
      (Category == "Undefined Behavior Sanitizer" ? "undefined behaviour: "
                                                  : Category + ": ")
          .str();
  if (!Reason.empty())
    Text += toLower(Reason.front());
  Text += Reason.drop_front(Reason.empty() ? 0 : 1);
  Frames.erase(Frames.begin());
  return Text;
}

/// The instruction at \p Pc with its operands by name and the values that it
/// reads; empty if there is none.
static std::string instructionText(uint32_t Pc, const ElfProgram &Program,
                                   const RegisterFunction &Registers) {
  const Segment &Text = Program.text();
  if (Pc < Text.Address ||
      uint64_t(Pc) + 4 > Text.Address + Text.Contents.size())
    return "";
  uint32_t Word = support::endian::read32le(&Text.Contents[Pc - Text.Address]);
  std::string Line;
  raw_string_ostream OS(Line);
  Opcode Op = decode(Word).Op;
  if (Op == IllegalOpcode) {
    OS << "word " << address(Word);
    return Line;
  }
  OS << mnemonic(Op);
  StringRef Separator = " ";
  for (const OperandInfo &Operand : operandsOf(Op)) {
    uint32_t Field =
        Word >> Operand.Shift & maskTrailingOnes<uint32_t>(Operand.Width);
    OS << Separator << Operand.Name << '=';
    Separator = ", ";
    if (Operand.Kind == OperandKind::Immediate) {
      int64_t Value = Operand.IsSigned ? SignExtend64(Field, Operand.Width)
                                       : int64_t(Field);
      OS << Value * Operand.Scale;
      continue;
    }
    bool IsFloat = Operand.Kind == OperandKind::FloatRegister;
    OS << (IsFloat ? 'f' : 'r') << Field;
    if (Operand.IsDestination)
      continue;
    if (IsFloat)
      OS << ": "
         << describeFloat(Registers(Field + NumIntegerRegisters),
                          CheckType::Float);
    else
      OS << " (" << address(Registers(Field)) << ')';
  }
  return Line;
}

std::string trapMessage(const Trap &T, TrapClock Clock, const ChipConfig &Chip,
                        const ElfProgram &Program, Symbolizer &Symbols,
                        const RegisterFunction &Registers) {
  std::string Message;
  raw_string_ostream OS(Message);
  OS << "thread " << T.Thread << " (TM " << T.Thread / Chip.TpsPerTm << ", TP "
     << T.Thread % Chip.TpsPerTm << ") trapped ";
  if (Clock == TrapClock::Cycles)
    OS << "at cycle " << T.Cycle << ": ";
  else
    OS << "after " << T.Cycle << " instructions: ";
  std::vector<SourceFrame> Frames = Symbols.frames(T.Pc);
  std::optional<std::string> Check = failedCheck(T, Registers);
  if (!Check && T.Kind == TrapKind::Break)
    Check = takeSanitizerCheck(Frames);
  OS << (Check ? *Check : T.what());
  if (T.Kind == TrapKind::AddressOutOfRange &&
      isBelowLocalStore(T.Address, Chip))
    OS << "\n  stack overflow: the local store of " << Chip.LocalStoreBytes
       << " bytes begins at " << address(uint32_t(0) - Chip.LocalStoreBytes);
  if (T.Kind == TrapKind::StackOverflow)
    OS << "\n  the program's own data begin below "
       << address(Program.stackLimit().value_or(0))
       << " (__tp_stack_limit); link it with a larger "
          "-Wl,-z,stack-size=<bytes>";

  OS << "\n  pc " << address(T.Pc);
  for (size_t I = 0; I != Frames.size(); ++I)
    OS << (I ? "\n    inlined " : " ") << Symbolizer::describe(Frames[I]);

  if (Check)
    return Message;
  if (std::string Text = instructionText(T.Pc, Program, Registers);
      !Text.empty())
    OS << "\n  instruction: " << Text;
  return Message;
}

} // namespace tp
