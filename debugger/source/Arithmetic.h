//===- Arithmetic.h - Operators of C++ on values ----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_SOURCE_ARITHMETIC_H
#define TP_DEBUGGER_SOURCE_ARITHMETIC_H

#include "debugger/source/Value.h"

namespace tp {

class TypeTable;

enum class OperatorKind : uint8_t {
  None,
  Add,
  Subtract,
  Multiply,
  Divide,
  Remainder,
  ShiftLeft,
  ShiftRight,
  BitAnd,
  BitOr,
  BitXor,
  Less,
  Greater,
  LessEqual,
  GreaterEqual,
  Equal,
  NotEqual,
  /// Of one operand.
  Plus,
  Minus,
  Not,
  Complement,
};

/// Computes as a program for the TP does: 32-bit int and long, promotions and
/// the usual conversions, float arithmetic in float.
class Arithmetic {
public:
  /// \p Types must outlive the object.
  explicit Arithmetic(TypeTable &Types);

  llvm::Expected<Value> unary(OperatorKind Operator, const Value &Operand,
                              const FrameContext &Frame) const;
  llvm::Expected<Value> binary(OperatorKind Operator, const Value &Left,
                               const Value &Right,
                               const FrameContext &Frame) const;
  /// A cast of C; \p KeepBits: a reinterpret_cast.
  llvm::Expected<Value> convert(const Value &From, const Type &To,
                                const FrameContext &Frame,
                                bool KeepBits = false) const;
  llvm::Expected<bool> isTrue(const Value &Of, const FrameContext &Frame) const;

  /// The type that two arithmetic values have together, as the branches of `?:`
  /// do; nullptr if one is no number.
  const Type *commonType(const Type &Left, const Type &Right) const;

  /// What a reference refers to, an array as a pointer to its first element, a
  /// function as a pointer; other values as they are.
  llvm::Expected<Value> decayed(const Value &Of,
                                const FrameContext &Frame) const;
  /// What a reference refers to; other values as they are.
  llvm::Expected<Value> withoutReference(const Value &Of,
                                         const FrameContext &Frame) const;

private:
  llvm::Expected<Value> convertObject(const Value &From, const Type &To,
                                      const FrameContext &Frame) const;
  llvm::Expected<std::optional<Value>>
  convertClassPointer(const Value &From, const Type &To,
                      const FrameContext &Frame) const;
  llvm::Expected<Value> convertReference(const Value &From, const Type &To,
                                         const FrameContext &Frame,
                                         bool KeepBits) const;
  llvm::Expected<Value> convertNumber(const Value &From, const Type &To,
                                      const FrameContext &Frame) const;

  /// A promoted operand.
  struct Number {
    enum NumberKind : uint8_t { Integer, Real, Pointer } Kind = Integer;
    uint8_t Bytes = 4;
    bool IsSigned = true;
    uint64_t Bits = 0;
    double RealNumber = 0;
    const Type *Of = nullptr;
  };

  TypeTable &Types;
  const Type &Bool;
  const Type &Int;
  const Type &UnsignedInt;
  const Type &LongLong;
  const Type &UnsignedLongLong;
  const Type &Float;
  const Type &Double;

  llvm::Expected<Number> promote(const Value &Of,
                                 const FrameContext &Frame) const;
  static Number commonNumber(const Number &Left, const Number &Right);
  const Type &integerType(const Number &Of) const;
  Value truth(bool Result) const;
  Value makeInteger(const Number &Like, uint64_t Bits) const;
  llvm::Expected<Value> integers(OperatorKind Operator, Number Left,
                                 Number Right) const;
  llvm::Expected<Value> reals(OperatorKind Operator, const Number &Left,
                              const Number &Right) const;
  llvm::Expected<Value> pointers(OperatorKind Operator, const Number &Left,
                                 const Number &Right) const;
};

/// As the TP's instructions convert: out of range gives the nearest, NaN 0. To
/// what is shorter than int it goes by int.
uint64_t realToInteger(double Number, unsigned Bytes, bool IsSigned);

/// Whether the result is true or false.
bool isComparison(OperatorKind Operator);

} // namespace tp

#endif // TP_DEBUGGER_SOURCE_ARITHMETIC_H
