//===- LocationStack.cpp - The stack machine of DWARF's expressions ------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/source/LocationStack.h"

#include "debugger/source/Frames.h"
#include "debugger/source/LocationEvaluator.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/BinaryFormat/Dwarf.h"
#include "llvm/DebugInfo/DWARF/DWARFContext.h"
#include "llvm/DebugInfo/DWARF/DWARFDie.h"
#include "llvm/Support/Endian.h"
#include "llvm/Support/MathExtras.h"

using namespace llvm;
using namespace llvm::dwarf;

namespace tp {

uint64_t LocationStack::Entry::zeroExtended() const {
  return Bits >= 64 ? Value : Value & maskTrailingOnes<uint64_t>(Bits);
}

int64_t LocationStack::Entry::signExtended() const {
  return SignExtend64(Value, Bits);
}

Error LocationStack::malformed(const Twine &What) const {
  return createStringError("the location cannot be evaluated: " + What);
}

void LocationStack::endPiece(uint32_t Bytes) {
  ValuePiece Piece;
  Piece.Bytes = Bytes;
  if (Implicit) {
    Piece.Place = ValuePiece::Computed;
    Piece.Contents.assign(Implicit->begin(), Implicit->end());
  } else if (IsLost || (Kind != ValuePiece::InRegister && Stack.empty())) {
    Piece.Place = ValuePiece::Lost;
  } else if (Kind == ValuePiece::InRegister && !hasRegister(Register)) {
    Piece.Place = ValuePiece::Lost;
  } else if (Kind == ValuePiece::InMemory) {
    Piece.Place = ValuePiece::InMemory;
    Piece.Address = uint32_t(Stack.back().Value);
  } else {
    Piece.Place = Kind;
    Piece.Register = Register;
    uint64_t Value =
        Kind == ValuePiece::InRegister
            ? Frame.Registers.Values[Register]
            : uint64_t(Stack.back().IsSigned ? Stack.back().signExtended()
                                             : Stack.back().zeroExtended());
    for (uint32_t I = 0; I != std::min(Bytes, 8u); ++I)
      Piece.Contents.push_back(uint8_t(Value >> (8 * I)));
  }
  Pieces.push_back(std::move(Piece));
  Stack.clear();
  Kind = ValuePiece::InMemory;
  Implicit.reset();
  IsLost = false;
}

Expected<std::vector<ValuePiece>>
LocationStack::places(ArrayRef<uint8_t> Expression, uint32_t Size) {
  if (Error Problem = run(Expression))
    return std::move(Problem);
  if (!HasPieces)
    endPiece(Size);
  return std::move(Pieces);
}

Expected<std::optional<uint64_t>>
LocationStack::number(ArrayRef<uint8_t> Expression) {
  if (Error Problem = run(Expression))
    return std::move(Problem);
  if (IsLost)
    return std::nullopt;
  if (Kind == ValuePiece::InRegister) {
    if (!hasRegister(Register))
      return std::nullopt;
    return Frame.Registers.Values[Register];
  }
  if (Stack.empty())
    return std::nullopt;
  return Stack.back().IsSigned ? uint64_t(Stack.back().signExtended())
                               : Stack.back().zeroExtended();
}

Error LocationStack::run(ArrayRef<uint8_t> Expression) {
  DWARFExpression Operations(
      DataExtractor(toStringRef(Expression), Unit.isLittleEndian(), 4), 4,
      Unit.getFormat());
  // No location has this many operations unless it never ends.
  unsigned Left = 10000;
  for (auto At = Operations.begin(), End = Operations.end(); At != End;) {
    const Operation &Op = *At;
    if (Op.isError() || Left-- == 0)
      return malformed("broken expression");
    if (Op.getCode() == DW_OP_entry_value ||
        Op.getCode() == DW_OP_GNU_entry_value) {
      uint64_t Bytes = Op.getRawOperand(0);
      if (Bytes > Expression.size() - Op.getEndOffset())
        return malformed("broken expression");
      Expected<std::optional<uint64_t>> Entry =
          Owner.entryValue(Expression.slice(Op.getEndOffset(), Bytes), Frame);
      if (!Entry)
        return Entry.takeError();
      IsLost |= !*Entry;
      push(Entry->value_or(0));
      At = At.skipBytes(Bytes);
      continue;
    }
    bool IsBranch = Op.getCode() == DW_OP_bra;
    if (IsBranch || Op.getCode() == DW_OP_skip) {
      if (IsBranch && Stack.empty())
        return malformed("empty stack");
      if (!IsBranch || Stack.pop_back_val().zeroExtended() != 0)
        At = At.skipBytes(Op.getRawOperand(0));
      else
        ++At;
      continue;
    }
    if (Error Problem = step(Op, Expression))
      return Problem;
    ++At;
  }
  return Error::success();
}

bool LocationStack::pushConstant(const Operation &Op) {
  uint8_t Code = Op.getCode();
  if (Code >= DW_OP_lit0 && Code <= DW_OP_lit31) {
    push(Code - DW_OP_lit0);
    return true;
  }
  switch (Code) {
  case DW_OP_addr:
  case DW_OP_const1u:
  case DW_OP_const1s:
  case DW_OP_const2u:
  case DW_OP_const2s:
  case DW_OP_const4u:
  case DW_OP_const4s:
  case DW_OP_const8u:
  case DW_OP_const8s:
  case DW_OP_constu:
  case DW_OP_consts: {
    // Wider than the generic type only in a value that follows at once.
    Entry Constant{Op.getRawOperand(0)};
    Constant.Bits = 64;
    Stack.push_back(Constant);
    return true;
  }
  default:
    return false;
  }
}

bool LocationStack::rearrange(const Operation &Op) {
  auto Pick = [&](size_t Depth) {
    if (Depth >= Stack.size())
      return false;
    Stack.push_back(Stack[Stack.size() - 1 - Depth]);
    return true;
  };
  switch (Op.getCode()) {
  case DW_OP_dup:
    return Pick(0);
  case DW_OP_over:
    return Pick(1);
  case DW_OP_pick:
    return Pick(Op.getRawOperand(0));
  case DW_OP_drop:
    if (Stack.empty())
      return false;
    Stack.pop_back();
    return true;
  case DW_OP_swap:
    if (Stack.size() < 2)
      return false;
    std::swap(Stack.back(), Stack[Stack.size() - 2]);
    return true;
  case DW_OP_rot:
    if (Stack.size() < 3)
      return false;
    std::rotate(Stack.end() - 3, Stack.end() - 1, Stack.end());
    return true;
  default:
    return false;
  }
}

Error LocationStack::unary(uint8_t Code) {
  if (Stack.empty())
    return malformed("empty stack");
  Entry &Top = Stack.back();
  if (Code == DW_OP_neg || (Code == DW_OP_abs && Top.signExtended() < 0))
    Top.Value = 0 - Top.Value;
  else if (Code == DW_OP_not)
    Top.Value = ~Top.Value;
  return Error::success();
}

Error LocationStack::binary(uint8_t Code) {
  if (Stack.size() < 2)
    return malformed("empty stack");
  Entry Right = Stack.pop_back_val();
  Entry &Left = Stack.back();
  if (Left.IsGeneric && Right.IsGeneric)
    Left.Bits = Right.Bits = 32;
  uint64_t A = Left.zeroExtended(), B = Right.zeroExtended();
  int64_t SignedA = Left.signExtended(), SignedB = Right.signExtended();
  bool IsUnsigned = !Left.IsGeneric && !Left.IsSigned;
  auto Compare = [&](auto Function) {
    bool Result = IsUnsigned ? Function(A, B) : Function(SignedA, SignedB);
    Left = Entry{Result};
  };
  switch (Code) {
  case DW_OP_plus:
    Left.Value = A + B;
    break;
  case DW_OP_minus:
    Left.Value = A - B;
    break;
  case DW_OP_mul:
    Left.Value = A * B;
    break;
  case DW_OP_and:
    Left.Value = A & B;
    break;
  case DW_OP_or:
    Left.Value = A | B;
    break;
  case DW_OP_xor:
    Left.Value = A ^ B;
    break;
  case DW_OP_shl:
    Left.Value = B < Left.Bits ? A << B : 0;
    break;
  case DW_OP_shr:
    Left.Value = B < Left.Bits ? A >> B : 0;
    break;
  case DW_OP_shra:
    Left.Value = uint64_t(SignedA >> std::min<uint64_t>(B, Left.Bits - 1u));
    break;
  case DW_OP_div:
  case DW_OP_mod:
    if (B == 0)
      return malformed("division by zero");
    if (Code == DW_OP_div)
      Left.Value = IsUnsigned      ? A / B
                   : SignedB == -1 ? 0 - A
                                   : uint64_t(SignedA / SignedB);
    else
      Left.Value = !Left.IsSigned  ? A % B
                   : SignedB == -1 ? 0
                                   : uint64_t(SignedA % SignedB);
    break;
  case DW_OP_eq:
    Compare([](auto X, auto Y) { return X == Y; });
    break;
  case DW_OP_ne:
    Compare([](auto X, auto Y) { return X != Y; });
    break;
  case DW_OP_lt:
    Compare([](auto X, auto Y) { return X < Y; });
    break;
  case DW_OP_le:
    Compare([](auto X, auto Y) { return X <= Y; });
    break;
  case DW_OP_gt:
    Compare([](auto X, auto Y) { return X > Y; });
    break;
  case DW_OP_ge:
    Compare([](auto X, auto Y) { return X >= Y; });
    break;
  }
  return Error::success();
}

Error LocationStack::useRegister(unsigned Number,
                                 std::optional<int64_t> Offset) {
  if (Number >= DwarfRegisters)
    return malformed("register " + Twine(Number));
  if (!Offset) {
    Kind = ValuePiece::InRegister;
    Register = Number;
    return Error::success();
  }
  IsLost |= !hasRegister(Number);
  push(Frame.Registers.Values[Number] + uint32_t(*Offset));
  return Error::success();
}

Error LocationStack::dereference(unsigned Bytes, Entry Type) {
  if (Stack.empty() || Bytes == 0 || Bytes > 8)
    return malformed("bad dereference");
  if (IsLost)
    return Error::success();
  uint8_t Buffer[8] = {};
  uint32_t Address = uint32_t(Stack.pop_back_val().Value);
  if (!Frame.read(Address, MutableArrayRef(Buffer, Bytes)))
    return cannotAccess(Address);
  Type.Value = support::endian::read64le(Buffer);
  Stack.push_back(Type);
  return Error::success();
}

Expected<LocationStack::Entry> LocationStack::typeAt(uint64_t Offset) const {
  Entry Type;
  if (Offset == 0)
    return Type;
  DWARFDie Die = Unit.getDIEForOffset(Unit.getOffset() + Offset);
  uint64_t Encoding =
      Die ? toUnsigned(Die.find(DW_AT_encoding), 0) : uint64_t(0);
  uint64_t Bytes = Die ? toUnsigned(Die.find(DW_AT_byte_size), 0) : 0;
  if (Bytes == 0 || Bytes > 8 || Encoding == DW_ATE_float)
    return malformed("a type that is no integer");
  Type.IsGeneric = false;
  Type.Bits = uint8_t(toUnsigned(Die.find(DW_AT_bit_size), 8 * Bytes));
  // LLVM names the types that it converts through by their bits.
  StringRef Name = dwarf::toStringRef(Die.find(DW_AT_name));
  unsigned Bits = 0;
  if (Name.starts_with("DW_ATE_") &&
      !Name.rsplit('_').second.getAsInteger(10, Bits) && Bits <= 64)
    Type.Bits = uint8_t(Bits);
  Type.IsSigned = Encoding == DW_ATE_signed || Encoding == DW_ATE_signed_char;
  return Type;
}

Error LocationStack::special(const Operation &Op,
                             ArrayRef<uint8_t> Expression) {
  switch (Op.getCode()) {
  case DW_OP_nop:
  // The offset of a thread_local object is its address.
  case DW_OP_form_tls_address:
  case DW_OP_GNU_push_tls_address:
    return Error::success();
  case DW_OP_addrx:
  case DW_OP_constx: {
    std::optional<object::SectionedAddress> Address =
        Unit.getAddrOffsetSectionItem(uint32_t(Op.getRawOperand(0)));
    if (!Address)
      return malformed("no address of that number");
    push(Address->Address);
    return Error::success();
  }
  case DW_OP_plus_uconst:
    if (Stack.empty())
      return malformed("empty stack");
    Stack.back().Value += Op.getRawOperand(0);
    return Error::success();
  case DW_OP_regx:
    return useRegister(unsigned(Op.getRawOperand(0)), std::nullopt);
  case DW_OP_bregx:
    return useRegister(unsigned(Op.getRawOperand(0)),
                       int64_t(Op.getRawOperand(1)));
  case DW_OP_fbreg: {
    Expected<uint32_t> Base = Owner.frameBase(Frame);
    if (!Base)
      return Base.takeError();
    push(*Base + uint32_t(Op.getRawOperand(0)));
    return Error::success();
  }
  case DW_OP_call_frame_cfa: {
    Expected<uint32_t> Cfa = Owner.Frames.cfa(Frame);
    if (!Cfa)
      return Cfa.takeError();
    push(*Cfa);
    return Error::success();
  }
  case DW_OP_deref:
    return dereference(4, Entry());
  case DW_OP_deref_size:
    return dereference(unsigned(Op.getRawOperand(0)), Entry());
  case DW_OP_deref_type: {
    Expected<Entry> Type = typeAt(Op.getRawOperand(1));
    if (!Type)
      return Type.takeError();
    return dereference(unsigned(Op.getRawOperand(0)), *Type);
  }
  case DW_OP_convert:
  case DW_OP_reinterpret: {
    Expected<Entry> Type = typeAt(Op.getRawOperand(0));
    if (!Type)
      return Type.takeError();
    if (Stack.empty())
      return malformed("empty stack");
    const Entry &From = Stack.back();
    Type->Value = From.IsSigned || (From.IsGeneric && Type->IsSigned)
                      ? uint64_t(From.signExtended())
                      : From.zeroExtended();
    Stack.back() = *Type;
    return Error::success();
  }
  case DW_OP_stack_value:
    Kind = ValuePiece::Computed;
    return Error::success();
  case DW_OP_implicit_value:
    if (Op.getEndOffset() > Expression.size())
      return malformed("broken expression");
    Implicit = Expression.slice(Op.getRawOperand(1), Op.getRawOperand(0));
    return Error::success();
  case DW_OP_piece:
    HasPieces = true;
    endPiece(uint32_t(Op.getRawOperand(0)));
    return Error::success();
  default:
    return malformed(OperationEncodingString(Op.getCode()));
  }
}

Error LocationStack::step(const Operation &Op, ArrayRef<uint8_t> Expression) {
  uint8_t Code = Op.getCode();
  if (pushConstant(Op))
    return Error::success();
  if (Code >= DW_OP_reg0 && Code <= DW_OP_reg31)
    return useRegister(Code - DW_OP_reg0, std::nullopt);
  if (Code >= DW_OP_breg0 && Code <= DW_OP_breg31)
    return useRegister(Code - DW_OP_breg0, int64_t(Op.getRawOperand(0)));
  switch (Code) {
  case DW_OP_dup:
  case DW_OP_drop:
  case DW_OP_over:
  case DW_OP_pick:
  case DW_OP_swap:
  case DW_OP_rot:
    return rearrange(Op) ? Error::success() : malformed("empty stack");
  case DW_OP_neg:
  case DW_OP_not:
  case DW_OP_abs:
    return unary(Code);
  case DW_OP_plus:
  case DW_OP_minus:
  case DW_OP_mul:
  case DW_OP_div:
  case DW_OP_mod:
  case DW_OP_and:
  case DW_OP_or:
  case DW_OP_xor:
  case DW_OP_shl:
  case DW_OP_shr:
  case DW_OP_shra:
  case DW_OP_eq:
  case DW_OP_ne:
  case DW_OP_lt:
  case DW_OP_le:
  case DW_OP_gt:
  case DW_OP_ge:
    return binary(Code);
  default:
    return special(Op, Expression);
  }
}

} // namespace tp
