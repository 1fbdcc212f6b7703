//===- Value.cpp - A value of a program, where it is and of what type ----===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/source/Value.h"

#include "llvm/ADT/APFloat.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/ADT/bit.h"
#include "llvm/Support/MathExtras.h"

using namespace llvm;

namespace tp {

static Error optimizedOutError() {
  return createStringError("the value has been optimized out");
}

Error cannotAccess(uint32_t Address) {
  return createStringError("Cannot access memory at address 0x" +
                           utohexstr(Address, true));
}

Value Value::inMemory(const Type &Of, uint32_t Address) {
  ValuePiece Piece;
  Piece.Place = ValuePiece::InMemory;
  Piece.Bytes = Of.Size;
  Piece.Address = Address;
  return inPieces(Of, Piece);
}

Value Value::computed(const Type &Of, ArrayRef<uint8_t> Bytes) {
  ValuePiece Piece;
  Piece.Place = ValuePiece::Computed;
  Piece.Bytes = uint32_t(Bytes.size());
  Piece.Contents.assign(Bytes.begin(), Bytes.end());
  return inPieces(Of, Piece);
}

Value Value::integer(const Type &Of, uint64_t Number) {
  SmallVector<uint8_t, 8> Bytes;
  for (uint32_t I = 0; I != Of.Size; ++I)
    Bytes.push_back(I < 8 ? uint8_t(Number >> (8 * I))
                          : uint8_t(int64_t(Number) >> 63));
  return computed(Of, Bytes);
}

static const fltSemantics &halfSemantics(const Type &Of) {
  return Of.stripped().Name == "__bf16" ? APFloat::BFloat()
                                        : APFloat::IEEEhalf();
}

Value Value::real(const Type &Of, double Number) {
  if (Of.Size == 4)
    return integer(Of, bit_cast<uint32_t>(float(Number)));
  if (Of.Size == 2) {
    APFloat Half(Number);
    bool LosesInfo;
    Half.convert(halfSemantics(Of), APFloat::rmNearestTiesToEven, &LosesInfo);
    return integer(Of, Half.bitcastToAPInt().getZExtValue());
  }
  return integer(Of, bit_cast<uint64_t>(Number));
}

Value Value::inPieces(const Type &Of, ArrayRef<ValuePiece> Pieces) {
  Value Result;
  Result.Of = &Of;
  Result.Pieces.assign(Pieces.begin(), Pieces.end());
  return Result;
}

Value Value::optimizedOut(const Type &Of) { return inPieces(Of, {}); }

std::optional<uint32_t> Value::address() const {
  if (Pieces.size() != 1 || Pieces.front().Place != ValuePiece::InMemory ||
      isBitField())
    return std::nullopt;
  return Pieces.front().Address;
}

std::optional<unsigned> Value::registerNumber() const {
  if (Pieces.size() != 1 || Pieces.front().Place != ValuePiece::InRegister)
    return std::nullopt;
  return Pieces.front().Register;
}

bool Value::isOptimizedOut() const {
  return all_of(Pieces, [](const ValuePiece &Piece) {
    return Piece.Place == ValuePiece::Lost;
  });
}

Expected<SmallVector<uint8_t, 16>>
Value::gather(const FrameContext &Frame, uint32_t Offset, uint32_t Size) const {
  constexpr uint32_t MaxBytes = 64 << 20;
  if (Size > MaxBytes)
    return createStringError("a value of " + Twine(Size) +
                             " bytes is too large to read");
  SmallVector<uint8_t, 16> Result(Size);
  uint32_t Begin = 0;
  uint32_t Done = 0;
  for (const ValuePiece &Piece : Pieces) {
    uint32_t End = Begin + Piece.Bytes;
    uint32_t From = std::max(Begin, Offset);
    uint32_t To = std::min(End, Offset + Size);
    if (From < To) {
      MutableArrayRef<uint8_t> Part =
          MutableArrayRef(Result).slice(From - Offset, To - From);
      if (Piece.Place == ValuePiece::Lost)
        return optimizedOutError();
      if (Piece.Place == ValuePiece::InMemory) {
        uint32_t Address = Piece.Address + (From - Begin);
        if (!Frame.read(Address, Part))
          return cannotAccess(Address);
      } else {
        for (uint32_t I = 0; I != Part.size(); ++I)
          Part[I] = From - Begin + I < Piece.Contents.size()
                        ? Piece.Contents[From - Begin + I]
                        : 0;
      }
      Done += To - From;
    }
    Begin = End;
  }
  if (Done != Size)
    return optimizedOutError();
  return Result;
}

Expected<SmallVector<uint8_t, 16>>
Value::bytes(const FrameContext &Frame) const {
  if (!isBitField())
    return gather(Frame, 0, Of->Size);
  Expected<uint64_t> Number = asInteger(Frame);
  if (!Number)
    return Number.takeError();
  SmallVector<uint8_t, 16> Result;
  for (uint32_t I = 0; I != Of->Size; ++I)
    Result.push_back(uint8_t(*Number >> (8 * std::min(I, 7u))));
  return Result;
}

Expected<SmallVector<uint8_t, 16>>
Value::bytes(const FrameContext &Frame, uint32_t Offset, uint32_t Size) const {
  assert(!isBitField() && "a bit-field has no bytes of its own");
  return gather(Frame, Offset, Size);
}

Expected<uint64_t> Value::asInteger(const FrameContext &Frame) const {
  uint32_t Size =
      isBitField() ? uint32_t(divideCeil(BitOffset + BitSize, 8)) : Of->Size;
  if (Size == 0 || Size > 16)
    return createStringError("a value of type " + Of->Name + " is no number");
  Expected<SmallVector<uint8_t, 16>> Bytes = gather(Frame, 0, Size);
  if (!Bytes)
    return Bytes.takeError();
  uint64_t Number = 0;
  for (uint32_t I = 0; I != std::min(Size, 8u); ++I)
    Number |= uint64_t((*Bytes)[I]) << (8 * I);
  uint32_t Bits = std::min(8 * Size, 64u);
  if (isBitField()) {
    Number >>= BitOffset;
    if (Size > 8)
      Number |= uint64_t((*Bytes)[8]) << (64 - BitOffset);
    Bits = BitSize;
  }
  if (Bits == 64)
    return Number;
  return Of->isSigned() ? uint64_t(SignExtend64(Number, Bits))
                        : Number & maskTrailingOnes<uint64_t>(Bits);
}

Expected<double> Value::asReal(const FrameContext &Frame) const {
  Expected<uint64_t> Number = asInteger(Frame);
  if (!Number)
    return Number.takeError();
  if (Of->stripped().Kind != TypeKind::Float)
    return Of->isSigned() ? double(int64_t(*Number)) : double(*Number);
  if (Of->Size == 4)
    return double(bit_cast<float>(uint32_t(*Number)));
  if (Of->Size == 8)
    return bit_cast<double>(*Number);
  if (Of->Size != 2)
    return createStringError("values of type " + Of->Name +
                             " cannot be computed with");
  return APFloat(halfSemantics(*Of), APInt(16, *Number)).convertToDouble();
}

Value Value::as(const Type &Other) const {
  Value Result = *this;
  Result.Of = &Other;
  if (Result.Pieces.size() == 1)
    Result.Pieces.front().Bytes = Other.Size;
  return Result;
}

Value Value::slice(const Type &Part, uint32_t Offset, uint32_t Size) const {
  // What is in memory in one piece may go on around its type: the last array
  // of a structure, an index below 0.
  if (std::optional<uint32_t> Address = address()) {
    Value Result = inMemory(Part, *Address + Offset);
    Result.Pieces.front().Bytes = Size;
    return Result;
  }
  Value Result;
  Result.Of = &Part;
  uint32_t Begin = 0;
  for (const ValuePiece &Piece : Pieces) {
    uint32_t End = Begin + Piece.Bytes;
    uint32_t From = std::max(Begin, Offset);
    uint32_t To = std::min(End, Offset + Size);
    if (From < To) {
      ValuePiece New = Piece;
      New.Bytes = To - From;
      if (Piece.Place == ValuePiece::InMemory)
        New.Address = Piece.Address + (From - Begin);
      New.ByteInRegister = Piece.ByteInRegister + (From - Begin);
      New.Contents.erase(
          New.Contents.begin(),
          New.Contents.begin() +
              std::min<size_t>(From - Begin, New.Contents.size()));
      Result.Pieces.push_back(std::move(New));
    }
    Begin = End;
  }
  return Result;
}

Value Value::part(const Type &Part, uint32_t Offset) const {
  return slice(Part, Offset, Part.Size);
}

Value Value::bits(const Type &Part, uint32_t Offset, uint32_t FirstBit,
                  uint32_t Bits) const {
  Value Result = slice(Part, Offset, uint32_t(divideCeil(FirstBit + Bits, 8)));
  Result.BitOffset = FirstBit;
  Result.BitSize = Bits;
  return Result;
}

Expected<Value> Value::snapshot(const FrameContext &Frame) const {
  // More than anybody prints; it would be a copy of the program's memory.
  constexpr uint32_t MaxBytes = 1 << 20;
  if (Of->Size > MaxBytes)
    return *this;
  if (isOptimizedOut() && Of->Size)
    return *this;
  Expected<SmallVector<uint8_t, 16>> Bytes = bytes(Frame);
  if (!Bytes)
    return Bytes.takeError();
  return computed(*Of, *Bytes);
}

static Error storeInRegister(const FrameContext &Frame, const ValuePiece &Piece,
                             uint32_t Offset, ArrayRef<uint8_t> Bytes) {
  Offset += Piece.ByteInRegister;
  if (Offset + Bytes.size() > 4)
    return createStringError("the value is larger than its register");
  if (uint32_t Address = Frame.SavedAt[Piece.Register]) {
    if (Frame.Machine->Write && Frame.Machine->Write(Address + Offset, Bytes))
      return Error::success();
    return createStringError("Cannot write memory at address 0x" +
                             utohexstr(Address + Offset, true));
  }
  uint32_t Word = Frame.Registers.Values[Piece.Register];
  for (size_t I = 0; I != Bytes.size(); ++I) {
    Word &= ~(0xffu << (8 * (Offset + I)));
    Word |= uint32_t(Bytes[I]) << (8 * (Offset + I));
  }
  if (!Frame.Machine->WriteRegister ||
      !Frame.Machine->WriteRegister(Piece.Register, Word))
    return createStringError("the register cannot be changed");
  return Error::success();
}

Error Value::store(const FrameContext &Frame, uint32_t Offset,
                   ArrayRef<uint8_t> Bytes) const {
  uint32_t Begin = 0;
  for (const ValuePiece &Piece : Pieces) {
    uint32_t End = Begin + Piece.Bytes;
    uint32_t From = std::max(Begin, Offset);
    uint32_t To = std::min<uint32_t>(End, Offset + uint32_t(Bytes.size()));
    if (From < To) {
      ArrayRef<uint8_t> Part = Bytes.slice(From - Offset, To - From);
      switch (Piece.Place) {
      case ValuePiece::InMemory: {
        uint32_t Address = Piece.Address + (From - Begin);
        if (!Frame.Machine->Write || !Frame.Machine->Write(Address, Part))
          return createStringError("Cannot write memory at address 0x" +
                                   utohexstr(Address, true));
        break;
      }
      case ValuePiece::InRegister:
        if (Error Problem = storeInRegister(Frame, Piece, From - Begin, Part))
          return Problem;
        break;
      case ValuePiece::Computed:
        return createStringError("left operand of assignment is not an "
                                 "object of the program");
      case ValuePiece::Lost:
        return optimizedOutError();
      }
    }
    Begin = End;
  }
  if (Pieces.empty())
    return optimizedOutError();
  return Error::success();
}

Error Value::assign(const FrameContext &Frame, ArrayRef<uint8_t> Bytes) const {
  assert(!isBitField() && Bytes.size() == Of->Size && "wrong size");
  return store(Frame, 0, Bytes);
}

Error Value::assignInteger(const FrameContext &Frame, uint64_t Number) const {
  uint32_t Size =
      isBitField() ? uint32_t(divideCeil(BitOffset + BitSize, 8)) : Of->Size;
  if (Size > 8)
    return createStringError("a value of this size cannot be assigned");
  SmallVector<uint8_t, 8> Bytes;
  if (isBitField()) {
    Expected<SmallVector<uint8_t, 16>> Old = gather(Frame, 0, Size);
    if (!Old)
      return Old.takeError();
    uint64_t Word = 0;
    for (uint32_t I = 0; I != Size; ++I)
      Word |= uint64_t((*Old)[I]) << (8 * I);
    uint64_t Mask = maskTrailingOnes<uint64_t>(BitSize) << BitOffset;
    Number = (Word & ~Mask) | (Number << BitOffset & Mask);
  }
  for (uint32_t I = 0; I != Size; ++I)
    Bytes.push_back(uint8_t(Number >> (8 * I)));
  return store(Frame, 0, Bytes);
}

} // namespace tp
