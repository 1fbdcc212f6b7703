//===- LocationStack.h - DWARF's stack machine ------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_SOURCE_LOCATIONSTACK_H
#define TP_DEBUGGER_SOURCE_LOCATIONSTACK_H

#include "debugger/source/FrameContext.h"
#include "debugger/source/Value.h"

#include "llvm/ADT/SmallVector.h"
#include "llvm/DebugInfo/DWARF/DWARFUnit.h"
#include "llvm/DebugInfo/DWARF/LowLevel/DWARFExpression.h"
#include "llvm/Support/Error.h"

#include <vector>

namespace tp {

class LocationEvaluator;

/// Evaluates one expression at a frame.
class LocationStack {
public:
  /// \p KeepsRegisters: the call that the frame is at, if it is at one, leaves
  /// the registers alone that the expression names.
  LocationStack(const LocationEvaluator &Owner, llvm::DWARFUnit &Unit,
                const FrameContext &Frame, bool KeepsRegisters = true)
      : Owner(Owner), Unit(Unit), Frame(Frame), KeepsRegisters(KeepsRegisters) {
  }

  /// The places of an object of \p Size bytes; none if it has no value here.
  llvm::Expected<std::vector<ValuePiece>>
  places(llvm::ArrayRef<uint8_t> Expression, uint32_t Size);
  /// What the expression leaves on the stack, for expressions that compute a
  /// value and not a place. Nothing if it is not available.
  llvm::Expected<std::optional<uint64_t>>
  number(llvm::ArrayRef<uint8_t> Expression);

private:
  using Operation = llvm::DWARFExpression::Operation;

  /// A number and its type: by default the generic one, an address.
  struct Entry {
    uint64_t Value = 0;
    uint8_t Bits = 32;
    bool IsSigned = false;
    bool IsGeneric = true;

    uint64_t zeroExtended() const;
    int64_t signExtended() const;
  };

  const LocationEvaluator &Owner;
  llvm::DWARFUnit &Unit;
  const FrameContext &Frame;
  bool KeepsRegisters;
  llvm::SmallVector<Entry, 8> Stack;
  std::vector<ValuePiece> Pieces;
  ValuePiece::PlaceKind Kind = ValuePiece::InMemory;
  unsigned Register = 0;
  std::optional<llvm::ArrayRef<uint8_t>> Implicit;
  bool HasPieces = false;
  /// A value that the program no longer has was needed.
  bool IsLost = false;

  llvm::Error run(llvm::ArrayRef<uint8_t> Expression);
  llvm::Error step(const Operation &Op, llvm::ArrayRef<uint8_t> Expression);
  bool pushConstant(const Operation &Op);
  bool rearrange(const Operation &Op);
  llvm::Error binary(uint8_t Code);
  llvm::Error unary(uint8_t Code);
  llvm::Error useRegister(unsigned Number, std::optional<int64_t> Offset);
  llvm::Error dereference(unsigned Bytes, Entry Type);
  llvm::Error special(const Operation &Op, llvm::ArrayRef<uint8_t> Expression);
  llvm::Expected<Entry> typeAt(uint64_t Offset) const;
  bool hasRegister(unsigned Number) const {
    return KeepsRegisters ? Frame.Registers.isPresent(Number)
                          : Frame.Registers.isKnown(Number);
  }
  void push(uint64_t Value) { Stack.push_back(Entry{Value}); }
  void endPiece(uint32_t Bytes);
  llvm::Error malformed(const llvm::Twine &What) const;
};

} // namespace tp

#endif // TP_DEBUGGER_SOURCE_LOCATIONSTACK_H
