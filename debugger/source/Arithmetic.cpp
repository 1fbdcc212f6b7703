//===- Arithmetic.cpp - Operators of C++ on values -----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/source/Arithmetic.h"

#include "debugger/source/Children.h"
#include "debugger/source/TypeTable.h"

#include "llvm/ADT/bit.h"
#include "llvm/Support/MathExtras.h"

#include <cmath>
#include <limits>

using namespace llvm;

namespace tp {

bool isComparison(OperatorKind Operator) {
  return Operator >= OperatorKind::Less && Operator <= OperatorKind::NotEqual;
}

Arithmetic::Arithmetic(TypeTable &Types)
    : Types(Types), Bool(Types.basic("bool")), Int(Types.basic("int")),
      UnsignedInt(Types.basic("unsigned int")),
      LongLong(Types.basic("long long")),
      UnsignedLongLong(Types.basic("unsigned long long")),
      Float(Types.basic("float")), Double(Types.basic("double")) {}

Value Arithmetic::truth(bool Result) const {
  return Value::integer(Bool, Result);
}

Expected<Value> Arithmetic::withoutReference(const Value &Of,
                                             const FrameContext &Frame) const {
  if (!Of.type().isReference())
    return Of;
  return pointee(Of, Frame);
}

Expected<Value> Arithmetic::decayed(const Value &Of,
                                    const FrameContext &Frame) const {
  Expected<Value> Plain = withoutReference(Of, Frame);
  if (!Plain)
    return Plain;
  const Type &Kind = Plain->type().stripped();
  if (Kind.Kind != TypeKind::Array && Kind.Kind != TypeKind::Function)
    return Plain;
  std::optional<uint32_t> Address = Plain->address();
  if (!Address)
    return createStringError("Attempt to take address of value not located in "
                             "memory.");
  const Type &Target = Kind.Kind == TypeKind::Array ? *Kind.Target : Kind;
  return Value::integer(Types.pointerTo(Target), *Address);
}

Expected<Arithmetic::Number>
Arithmetic::promote(const Value &Of, const FrameContext &Frame) const {
  Expected<Value> Plain = decayed(Of, Frame);
  if (!Plain)
    return Plain.takeError();
  Number Result;
  const Type &Kind = Plain->type().stripped();
  Result.Of = &Plain->type();
  if (Kind.Kind == TypeKind::Float) {
    Expected<double> Real = Plain->asReal(Frame);
    if (!Real)
      return Real.takeError();
    Result.Kind = Number::Real;
    Result.Bytes = uint8_t(Kind.Size);
    Result.RealNumber = *Real;
    return Result;
  }
  if (!Kind.isInteger() && !Kind.isPointer())
    return createStringError(
        "Argument to arithmetic operation not a number or boolean.");
  if (Kind.Size > 8)
    return createStringError("Numbers of more than 64 bits cannot be computed "
                             "with.");
  Expected<uint64_t> Bits = Plain->asInteger(Frame);
  if (!Bits)
    return Bits.takeError();
  Result.Bits = *Bits;
  if (Kind.isPointer()) {
    Result.Kind = Number::Pointer;
    Result.IsSigned = false;
    return Result;
  }
  // What an int can hold becomes one.
  uint32_t Width = Plain->isBitField() ? Plain->bitSize() : 8 * Kind.Size;
  Result.Bytes = Width <= 32 ? 4 : 8;
  Result.IsSigned = Kind.isSigned() || Width < 32;
  return Result;
}

const Type &Arithmetic::integerType(const Number &Of) const {
  if (Of.Bytes == 8)
    return Of.IsSigned ? LongLong : UnsignedLongLong;
  return Of.IsSigned ? Int : UnsignedInt;
}

const Type *Arithmetic::commonType(const Type &Left, const Type &Right) const {
  if (!Left.isArithmetic() || !Right.isArithmetic())
    return nullptr;
  if (isSameType(Left, Right))
    return &Left;
  auto IsReal = [](const Type &Of) {
    return Of.stripped().Kind == TypeKind::Float;
  };
  if (IsReal(Left) || IsReal(Right)) {
    bool InDouble = (IsReal(Left) && Left.stripped().Size == 8) ||
                    (IsReal(Right) && Right.stripped().Size == 8);
    return InDouble ? &Double : &Float;
  }
  auto Promoted = [](const Type &Of) {
    Number Result;
    Result.Bytes = uint8_t(std::max(Of.stripped().Size, 4u));
    Result.IsSigned = Of.isSigned() || Of.stripped().Size < 4;
    return Result;
  };
  return &integerType(commonNumber(Promoted(Left), Promoted(Right)));
}

Arithmetic::Number Arithmetic::commonNumber(const Number &Left,
                                            const Number &Right) {
  Number Common = Left;
  Common.Bytes = std::max(Left.Bytes, Right.Bytes);
  bool LeftWins = !Left.IsSigned && Left.Bytes == Common.Bytes;
  bool RightWins = !Right.IsSigned && Right.Bytes == Common.Bytes;
  Common.IsSigned = !LeftWins && !RightWins;
  return Common;
}

Value Arithmetic::makeInteger(const Number &Like, uint64_t Bits) const {
  return Value::integer(integerType(Like), Bits);
}

static uint64_t extended(uint64_t Bits, unsigned Bytes, bool IsSigned) {
  if (Bytes == 8)
    return Bits;
  return IsSigned ? uint64_t(SignExtend64(Bits, 8 * Bytes))
                  : Bits & maskTrailingOnes<uint64_t>(8 * Bytes);
}

template <class T> static bool compare(OperatorKind Operator, T Left, T Right) {
  switch (Operator) {
  case OperatorKind::Less:
    return Left < Right;
  case OperatorKind::Greater:
    return Left > Right;
  case OperatorKind::LessEqual:
    return Left <= Right;
  case OperatorKind::GreaterEqual:
    return Left >= Right;
  case OperatorKind::Equal:
    return Left == Right;
  default:
    return Left != Right;
  }
}

static Error notForReals() {
  return createStringError("Integer-only operation on a floating-point "
                           "value.");
}

Expected<Value> Arithmetic::integers(OperatorKind Operator, Number Left,
                                     Number Right) const {
  bool IsShift = Operator == OperatorKind::ShiftLeft ||
                 Operator == OperatorKind::ShiftRight;
  Number Common = IsShift ? Left : commonNumber(Left, Right);
  uint64_t A = extended(Left.Bits, Common.Bytes, Common.IsSigned);
  uint64_t B = extended(Right.Bits, Common.Bytes, Common.IsSigned);
  if (isComparison(Operator))
    return truth(Common.IsSigned
                     ? compare<int64_t>(Operator, int64_t(A), int64_t(B))
                     : compare<uint64_t>(Operator, A, B));
  unsigned Bits = 8 * Common.Bytes;
  if (IsShift && Right.Bits >= Bits)
    return createStringError("The shift's distance is not below the value's "
                             "width, " +
                             Twine(Bits) + ".");
  switch (Operator) {
  case OperatorKind::Add:
    return makeInteger(Common, A + B);
  case OperatorKind::Subtract:
    return makeInteger(Common, A - B);
  case OperatorKind::Multiply:
    return makeInteger(Common, A * B);
  case OperatorKind::Divide:
  case OperatorKind::Remainder: {
    if (B == 0)
      return createStringError("Division by zero");
    bool IsDivision = Operator == OperatorKind::Divide;
    if (!Common.IsSigned)
      return makeInteger(Common, IsDivision ? A / B : A % B);
    if (int64_t(B) == -1)
      return makeInteger(Common, IsDivision ? 0 - A : 0);
    return makeInteger(Common, uint64_t(IsDivision ? int64_t(A) / int64_t(B)
                                                   : int64_t(A) % int64_t(B)));
  }
  case OperatorKind::BitAnd:
    return makeInteger(Common, A & B);
  case OperatorKind::BitOr:
    return makeInteger(Common, A | B);
  case OperatorKind::BitXor:
    return makeInteger(Common, A ^ B);
  case OperatorKind::ShiftLeft:
    return makeInteger(Common, A << Right.Bits);
  case OperatorKind::ShiftRight:
    return makeInteger(Common, Common.IsSigned
                                   ? uint64_t(int64_t(A) >> Right.Bits)
                                   : A >> Right.Bits);
  default:
    return createStringError("not an operator of two integers");
  }
}

template <class T>
static std::optional<T> computeReal(OperatorKind Operator, T Left, T Right) {
  switch (Operator) {
  case OperatorKind::Add:
    return Left + Right;
  case OperatorKind::Subtract:
    return Left - Right;
  case OperatorKind::Multiply:
    return Left * Right;
  case OperatorKind::Divide:
    return Left / Right;
  default:
    return std::nullopt;
  }
}

Expected<Value> Arithmetic::reals(OperatorKind Operator, const Number &Left,
                                  const Number &Right) const {
  auto IsDouble = [](const Number &Operand) {
    return Operand.Kind == Number::Real && Operand.Bytes == 8;
  };
  bool InDouble = IsDouble(Left) || IsDouble(Right);
  auto RealOf = [InDouble](const Number &Operand) {
    if (Operand.Kind == Number::Real)
      return Operand.RealNumber;
    int64_t Signed = int64_t(Operand.Bits);
    if (InDouble)
      return Operand.IsSigned ? double(Signed) : double(Operand.Bits);
    return double(Operand.IsSigned ? float(Signed) : float(Operand.Bits));
  };
  double A = RealOf(Left), B = RealOf(Right);
  if (isComparison(Operator))
    return truth(compare(Operator, A, B));
  std::optional<double> Result;
  if (InDouble)
    Result = computeReal(Operator, A, B);
  else if (std::optional<float> Single =
               computeReal(Operator, float(A), float(B)))
    Result = *Single;
  if (!Result)
    return notForReals();
  return Value::real(InDouble ? Double : Float, *Result);
}

Expected<Value> Arithmetic::pointers(OperatorKind Operator, const Number &Left,
                                     const Number &Right) const {
  bool BothPointers =
      Left.Kind == Number::Pointer && Right.Kind == Number::Pointer;
  if (isComparison(Operator))
    return truth(
        compare<uint32_t>(Operator, uint32_t(Left.Bits), uint32_t(Right.Bits)));
  const Number &Pointer = Left.Kind == Number::Pointer ? Left : Right;
  const Number &Other = Left.Kind == Number::Pointer ? Right : Left;
  const Type &Target = *Pointer.Of->stripped().Target;
  // Of void and functions as GNU C counts them.
  uint32_t Step = std::max(Target.Size, 1u);
  if (BothPointers && Operator == OperatorKind::Subtract) {
    if (std::max(Right.Of->stripped().Target->Size, 1u) != Step)
      return createStringError("First argument of `-' is a pointer and second "
                               "argument points to another type.");
    return Value::integer(
        Int,
        uint64_t(int64_t(int32_t(Left.Bits - Right.Bits)) / int32_t(Step)));
  }
  bool IsAdd = Operator == OperatorKind::Add;
  if (BothPointers || (!IsAdd && (Operator != OperatorKind::Subtract ||
                                  Left.Kind != Number::Pointer)))
    return createStringError("This operator does not work on pointers.");
  uint64_t Distance = Other.Bits * Step;
  uint32_t Result =
      uint32_t(IsAdd ? Pointer.Bits + Distance : Pointer.Bits - Distance);
  return Value::integer(*Pointer.Of, Result);
}

Expected<Value> Arithmetic::binary(OperatorKind Operator, const Value &Left,
                                   const Value &Right,
                                   const FrameContext &Frame) const {
  Expected<Number> A = promote(Left, Frame);
  if (!A)
    return A.takeError();
  Expected<Number> B = promote(Right, Frame);
  if (!B)
    return B.takeError();
  bool HasPointer = A->Kind == Number::Pointer || B->Kind == Number::Pointer;
  bool HasReal = A->Kind == Number::Real || B->Kind == Number::Real;
  if (HasPointer && HasReal)
    return createStringError("This operator does not work on a pointer and a "
                             "floating-point value.");
  if (HasPointer)
    return pointers(Operator, *A, *B);
  if (HasReal)
    return reals(Operator, *A, *B);
  return integers(Operator, *A, *B);
}

Expected<bool> Arithmetic::isTrue(const Value &Of,
                                  const FrameContext &Frame) const {
  Expected<Number> Operand = promote(Of, Frame);
  if (!Operand)
    return Operand.takeError();
  return Operand->Kind == Number::Real ? Operand->RealNumber != 0
                                       : Operand->Bits != 0;
}

Expected<Value> Arithmetic::unary(OperatorKind Operator, const Value &Operand,
                                  const FrameContext &Frame) const {
  if (Operator == OperatorKind::Not) {
    Expected<bool> Is = isTrue(Operand, Frame);
    if (!Is)
      return Is.takeError();
    return truth(!*Is);
  }
  Expected<Number> A = promote(Operand, Frame);
  if (!A)
    return A.takeError();
  if (A->Kind == Number::Pointer) {
    if (Operator == OperatorKind::Plus)
      return decayed(Operand, Frame);
    return createStringError("This operator does not work on pointers.");
  }
  if (A->Kind == Number::Real) {
    if (Operator == OperatorKind::Complement)
      return notForReals();
    return Value::real(A->Bytes == 8 ? Double : Float,
                       Operator == OperatorKind::Minus ? -A->RealNumber
                                                       : A->RealNumber);
  }
  switch (Operator) {
  case OperatorKind::Minus:
    return makeInteger(*A, 0 - A->Bits);
  case OperatorKind::Complement:
    return makeInteger(*A, ~A->Bits);
  default:
    return makeInteger(*A, A->Bits);
  }
}

uint64_t realToInteger(double Number, unsigned Bytes, bool IsSigned) {
  if (Bytes < 4)
    return realToInteger(Number, 4, true);
  if (std::isnan(Number))
    return 0;
  double Whole = std::trunc(Number);
  int Bits = int(8 * Bytes);
  double Limit = std::ldexp(1.0, IsSigned ? Bits - 1 : Bits);
  if (Whole >= Limit)
    return IsSigned ? maskTrailingOnes<uint64_t>(unsigned(Bits) - 1)
                    : maskTrailingOnes<uint64_t>(unsigned(Bits));
  if (Whole < (IsSigned ? -Limit : 0.0))
    return IsSigned ? ~maskTrailingOnes<uint64_t>(unsigned(Bits) - 1) : 0;
  return IsSigned ? uint64_t(int64_t(Whole)) : uint64_t(Whole);
}

/// A class as a base, or as what it is the base of; another class or an array
/// is a view of the same memory if it has the same size, as in gdb.
Expected<Value> Arithmetic::convertObject(const Value &From, const Type &To,
                                          const FrameContext &Frame) const {
  if (isSameType(From.type(), To))
    return From.as(To);
  Expected<std::optional<Value>> Related = asRelatedClass(From, To, Frame);
  if (!Related)
    return Related.takeError();
  if (const std::optional<Value> &Found = *Related)
    return *Found;
  std::optional<uint32_t> Address = From.address();
  if (From.type().Size == To.Size && Address)
    return Value::inMemory(To, *Address);
  return createStringError("Invalid cast.");
}

Expected<Value> Arithmetic::convertReference(const Value &From, const Type &To,
                                             const FrameContext &Frame,
                                             bool KeepBits) const {
  Expected<Value> Object = withoutReference(From, Frame);
  if (!Object)
    return Object;
  std::optional<uint32_t> Address = Object->address();
  if (!Address)
    return createStringError("Attempt to take address of value not located "
                             "in memory.");
  const Type &Target = *To.stripped().Target;
  if (!KeepBits) {
    Expected<std::optional<Value>> Related =
        asRelatedClass(*Object, Target, Frame);
    if (!Related)
      return Related.takeError();
    if (const std::optional<Value> &Found = *Related)
      return *Found;
  }
  return Value::inMemory(Target, *Address);
}

/// A pointer to a class as one to a base, or to what it is the base of; nothing
/// if the bits stay as they are.
Expected<std::optional<Value>>
Arithmetic::convertClassPointer(const Value &From, const Type &To,
                                const FrameContext &Frame) const {
  const Type *Class = From.type().stripped().Target;
  const Type *Wanted = To.stripped().Target;
  if (!From.type().isPointer() || !To.isPointer() || !Class->isRecord() ||
      !Wanted->isRecord())
    return std::nullopt;
  Expected<uint64_t> Address = From.asInteger(Frame);
  if (!Address)
    return Address.takeError();
  if (*Address == 0)
    return std::nullopt;
  Expected<std::optional<Value>> Object = asRelatedClass(
      Value::inMemory(*Class, uint32_t(*Address)), *Wanted, Frame);
  if (!Object)
    return Object;
  const std::optional<Value> &Found = *Object;
  std::optional<uint32_t> Where = Found ? Found->address() : std::nullopt;
  if (Where)
    return Value::integer(To, *Where);
  return std::nullopt;
}

Expected<Value> Arithmetic::convertNumber(const Value &From, const Type &To,
                                          const FrameContext &Frame) const {
  const Type &Target = To.stripped();
  Expected<Number> A = promote(From, Frame);
  if (!A)
    return A.takeError();
  if (Target.Kind == TypeKind::Float) {
    if (A->Kind == Number::Pointer)
      return createStringError("Invalid cast.");
    double Real = A->Kind == Number::Real ? A->RealNumber
                  : A->IsSigned           ? double(int64_t(A->Bits))
                                          : double(A->Bits);
    // One rounding, not two.
    if (Target.Size == 4 && A->Kind == Number::Integer)
      Real = A->IsSigned ? float(int64_t(A->Bits)) : float(A->Bits);
    return Value::real(To, Real);
  }
  if (Target.Kind == TypeKind::Boolean)
    return Value::integer(To, A->Kind == Number::Real ? A->RealNumber != 0
                                                      : A->Bits != 0);
  if (!Target.isInteger() && !Target.isPointer() &&
      Target.Kind != TypeKind::MemberPointer)
    return createStringError("Invalid cast.");
  if (A->Kind == Number::Real) {
    if (!Target.isInteger())
      return createStringError("Invalid cast.");
    return Value::integer(
        To, realToInteger(A->RealNumber, Target.Size, To.isSigned()));
  }
  return Value::integer(To, A->Bits);
}

Expected<Value> Arithmetic::convert(const Value &From, const Type &To,
                                    const FrameContext &Frame,
                                    bool KeepBits) const {
  const Type &Target = To.stripped();
  if (Target.isReference())
    return convertReference(From, To, Frame, KeepBits);
  if (Target.Kind == TypeKind::Void)
    return Value::computed(To, {});
  Expected<Value> Source = withoutReference(From, Frame);
  if (!Source)
    return Source;
  if (Target.isRecord() || Target.Kind == TypeKind::Array)
    return convertObject(*Source, To, Frame);
  if (KeepBits && Source->type().Size == Target.Size) {
    Expected<SmallVector<uint8_t, 16>> Bytes = Source->bytes(Frame);
    if (!Bytes)
      return Bytes.takeError();
    return Value::computed(To, *Bytes);
  }
  Expected<std::optional<Value>> Pointer =
      convertClassPointer(*Source, To, Frame);
  if (!Pointer)
    return Pointer.takeError();
  if (const std::optional<Value> &Found = *Pointer)
    return *Found;
  return convertNumber(*Source, To, Frame);
}

} // namespace tp
