//===- Value.h - A value of a program, where it is and of what type *- C++
//-*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_SOURCE_VALUE_H
#define TP_DEBUGGER_SOURCE_VALUE_H

#include "debugger/source/FrameContext.h"
#include "debugger/source/Type.h"

#include "llvm/ADT/SmallVector.h"
#include "llvm/Support/Error.h"

#include <cstdint>
#include <optional>
#include <string>

namespace tp {

/// A part of an object that lies in one place.
struct ValuePiece {
  enum PlaceKind : uint8_t { InMemory, InRegister, Computed, Lost };
  PlaceKind Place = Lost;
  /// Bytes of the object that it holds.
  uint32_t Bytes = 0;
  /// InMemory.
  uint32_t Address = 0;
  /// InRegister: DWARF's number, and the part's first byte in the register.
  unsigned Register = 0;
  uint32_t ByteInRegister = 0;
  /// Computed: the bytes, zeros behind them; InRegister: what the register
  /// holds.
  llvm::SmallVector<uint8_t, 8> Contents;
};

/// A value: an object in memory, one that is in registers or split, or a
/// result. It is a snapshot except for what is in memory, which is read when
/// it is asked for.
class Value {
public:
  Value() = default;
  /// An object in memory.
  static Value inMemory(const Type &Of, uint32_t Address);
  /// A result, which has no place.
  static Value computed(const Type &Of, llvm::ArrayRef<uint8_t> Bytes);
  static Value integer(const Type &Of, uint64_t Number);
  static Value real(const Type &Of, double Number);
  /// An object in the places that its location says.
  static Value inPieces(const Type &Of, llvm::ArrayRef<ValuePiece> Pieces);
  /// A variable that has no value here, as far as the program says.
  static Value optimizedOut(const Type &Of);

  bool isValid() const { return Of != nullptr; }
  const Type &type() const { return *Of; }
  /// Where it is, if all of it is in memory in one piece.
  std::optional<uint32_t> address() const;
  /// The register that holds it, if one does.
  std::optional<unsigned> registerNumber() const;
  bool isOptimizedOut() const;
  /// It is a bit-field; it has no address of its own.
  bool isBitField() const { return BitSize != 0; }
  uint32_t bitSize() const { return BitSize; }

  /// Its bytes, type().Size of them; of a bit-field the extended number's.
  llvm::Expected<llvm::SmallVector<uint8_t, 16>>
  bytes(const FrameContext &Frame) const;
  /// The first bytes of it only: a long array need not be read whole.
  llvm::Expected<llvm::SmallVector<uint8_t, 16>>
  bytes(const FrameContext &Frame, uint32_t Offset, uint32_t Size) const;

  /// An integer, character, boolean, enumeration or pointer, extended as its
  /// type says; a reference's address.
  llvm::Expected<uint64_t> asInteger(const FrameContext &Frame) const;
  /// A floating-point value, or an integer converted.
  llvm::Expected<double> asReal(const FrameContext &Frame) const;

  /// The same place as another type.
  Value as(const Type &Other) const;
  /// A part of it, from byte \p Offset on.
  Value part(const Type &Part, uint32_t Offset) const;
  /// A bit-field in it.
  Value bits(const Type &Part, uint32_t Offset, uint32_t FirstBit,
             uint32_t Bits) const;
  /// With its bytes read, so that it stays as it is.
  llvm::Expected<Value> snapshot(const FrameContext &Frame) const;

  /// Changes the object. The error says why that is not possible.
  llvm::Error assign(const FrameContext &Frame,
                     llvm::ArrayRef<uint8_t> Bytes) const;
  /// Changes an integer, character, boolean, enumeration, pointer or bit-field.
  llvm::Error assignInteger(const FrameContext &Frame, uint64_t Number) const;

private:
  const Type *Of = nullptr;
  llvm::SmallVector<ValuePiece, 1> Pieces;
  uint32_t BitOffset = 0;
  uint32_t BitSize = 0;

  llvm::Expected<llvm::SmallVector<uint8_t, 16>>
  gather(const FrameContext &Frame, uint32_t Offset, uint32_t Size) const;
  Value slice(const Type &Part, uint32_t Offset, uint32_t Size) const;
  llvm::Error store(const FrameContext &Frame, uint32_t Offset,
                    llvm::ArrayRef<uint8_t> Bytes) const;
};

/// What is said of an object in what is no memory.
llvm::Error cannotAccess(uint32_t Address);

/// A value and what to call it.
struct NamedValue {
  /// `Member`, `[3]`, a base class's name, `*Pointer`.
  std::string Name;
  Value Of;
  bool IsBase = false;
};

} // namespace tp

#endif // TP_DEBUGGER_SOURCE_VALUE_H
