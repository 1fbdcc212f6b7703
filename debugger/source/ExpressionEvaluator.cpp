//===- ExpressionEvaluator.cpp - Computes trees of expressions -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/source/ExpressionEvaluator.h"

#include "debugger/source/Children.h"
#include "debugger/source/DebugInformation.h"
#include "debugger/source/Expression.h"
#include "debugger/source/NameIndex.h"
#include "simulator/isa/Instructions.h"

#include "llvm/ADT/StringSwitch.h"

using namespace llvm;

namespace tp {

ExpressionEvaluator::ExpressionEvaluator(DebugInformation &Information)
    : Information(Information), Names(Information), Math(Information.types()) {}

Expected<Value> ExpressionEvaluator::evaluate(const ExpressionNode &Node,
                                              const FrameContext &Frame,
                                              ValueHistory *History) const {
  return run(Node, {Frame, History});
}

Expected<Value> ExpressionEvaluator::name(const ExpressionNode &Node,
                                          Place At) const {
  if (!Node.Bound || !Node.Bound->isFor(At.Frame)) {
    Expected<BoundName> Bound = Names.bind(Node.Name, At.Frame);
    if (!Bound)
      return Bound.takeError();
    Node.Bound = std::move(*Bound);
  }
  return Names.value(*Node.Bound, Node.Name, At.Frame);
}

/// DWARF's number of a register by its name, without the computed ones.
static std::optional<unsigned> registerNumber(StringRef Name) {
  std::optional<unsigned> Special = StringSwitch<std::optional<unsigned>>(Name)
                                        .Case("sp", StackPointerRegister)
                                        .Case("fp", 30)
                                        .Case("ra", LinkRegister)
                                        .Default(std::nullopt);
  if (Special)
    return Special;
  bool IsFloat = Name.starts_with("f");
  unsigned Number;
  if (Name.drop_front().getAsInteger(10, Number) || Number >= 32)
    return std::nullopt;
  return IsFloat ? DwarfFirstFloat + Number : Number;
}

Expected<Value> ExpressionEvaluator::registerValue(StringRef Name,
                                                   Place At) const {
  TypeTable &Types = Information.types();
  const Type &Pointer = Types.pointerTo(Types.basic("void"));
  if (Name == "pc")
    return Value::integer(Pointer, At.Frame.Pc);
  if (Name == "cfa") {
    Expected<uint32_t> Cfa = Information.unwinder().cfa(At.Frame);
    if (!Cfa)
      return Cfa.takeError();
    return Value::integer(Pointer, *Cfa);
  }
  std::optional<unsigned> Found = registerNumber(Name);
  if (!Found)
    return createStringError("There is no register $" + Name + ".");
  unsigned Number = *Found;
  bool IsAddress = Name == "sp" || Name == "fp" || Name == "ra";
  const Type &Of = IsAddress                   ? Pointer
                   : Number >= DwarfFirstFloat ? Types.basic("float")
                                               : Types.basic("int");
  ValuePiece Piece;
  Piece.Bytes = 4;
  Piece.Register = Number;
  if (At.Frame.Registers.isKnown(Number)) {
    Piece.Place = ValuePiece::InRegister;
    for (unsigned I = 0; I != 4; ++I)
      Piece.Contents.push_back(
          uint8_t(At.Frame.Registers.Values[Number] >> (8 * I)));
  }
  return Value::inPieces(Of, Piece);
}

Expected<Value> ExpressionEvaluator::earlier(const ExpressionNode &Node,
                                             Place At) const {
  const Value *Found = nullptr;
  if (Node.Kind == NodeKind::History) {
    Found = At.History ? At.History->get(Node.Number) : nullptr;
    if (!Found)
      return createStringError("History has not yet reached $" +
                               Twine(Node.Number) + ".");
    return *Found;
  }
  Found = At.History ? At.History->variable(Node.Name) : nullptr;
  if (!Found)
    return createStringError("$" + Node.Name + " has no value.");
  return *Found;
}

Expected<Value> ExpressionEvaluator::object(const ExpressionNode &Node,
                                            Place At) const {
  Expected<Value> Result = run(Node, At);
  return Result ? Math.withoutReference(*Result, At.Frame) : std::move(Result);
}

Expected<uint64_t> ExpressionEvaluator::integer(const Value &Of,
                                                Place At) const {
  Expected<Value> Plain = Math.decayed(Of, At.Frame);
  if (!Plain)
    return Plain.takeError();
  if (!Plain->type().isInteger() && !Plain->type().isPointer())
    return createStringError("A value of type " + Plain->type().Name +
                             " is no integer.");
  return Plain->asInteger(At.Frame);
}

Expected<Value> ExpressionEvaluator::dereference(const Value &Of,
                                                 Place At) const {
  Expected<Value> Pointer = Math.decayed(Of, At.Frame);
  if (!Pointer)
    return Pointer;
  if (Pointer->type().isInteger()) {
    // As in gdb, a number is the address of a word.
    Expected<uint64_t> Address = Pointer->asInteger(At.Frame);
    if (!Address)
      return Address.takeError();
    return Value::inMemory(Information.types().basic("int"),
                           uint32_t(*Address));
  }
  if (!Pointer->type().isPointer())
    return createStringError("Attempt to take contents of a non-pointer "
                             "value.");
  return pointee(*Pointer, At.Frame);
}

Expected<Value> ExpressionEvaluator::addressOf(const ExpressionNode &Node,
                                               Place At) const {
  Expected<Value> Plain = object(*Node.Operands[0], At);
  if (!Plain)
    return Plain;
  if (Plain->isBitField())
    return createStringError("Cannot take the address of a bit-field.");
  if (std::optional<unsigned> Register = Plain->registerNumber())
    return createStringError("Address requested for a value that is in "
                             "register " +
                             registerName(*Register) + ".");
  std::optional<uint32_t> Address = Plain->address();
  if (!Address)
    return createStringError(Plain->isOptimizedOut()
                                 ? "value has been optimized out"
                                 : "Attempt to take address of value not "
                                   "located in memory.");
  return Value::integer(Information.types().pointerTo(Plain->type()), *Address);
}

Expected<Value> ExpressionEvaluator::binary(const ExpressionNode &Node,
                                            Place At) const {
  Expected<Value> Left = run(*Node.Operands[0], At);
  if (!Left)
    return Left;
  Expected<Value> Right = run(*Node.Operands[1], At);
  if (!Right)
    return Right;
  return Math.binary(Node.Operator, *Left, *Right, At.Frame);
}

Expected<Value> ExpressionEvaluator::logical(const ExpressionNode &Node,
                                             Place At) const {
  bool Result = Node.Kind == NodeKind::LogicalAnd;
  for (const auto &Operand : Node.Operands) {
    Expected<Value> Part = run(*Operand, At);
    if (!Part)
      return Part;
    Expected<bool> Is = Math.isTrue(*Part, At.Frame);
    if (!Is)
      return Is.takeError();
    if (*Is != (Node.Kind == NodeKind::LogicalAnd)) {
      Result = *Is;
      break;
    }
  }
  return Value::integer(Information.types().basic("bool"), Result);
}

Expected<Value> ExpressionEvaluator::setConvenience(StringRef Name,
                                                    const Value &New,
                                                    Place At) const {
  if (!At.History)
    return createStringError("$" + Name + " cannot be set here.");
  Expected<Value> Plain = Math.withoutReference(New, At.Frame);
  if (!Plain)
    return Plain;
  Expected<Value> Kept = Plain->snapshot(At.Frame);
  if (Kept)
    At.History->setVariable(Name, *Kept);
  return Kept;
}

Expected<Value> ExpressionEvaluator::setPc(const Value &New, Place At) const {
  Expected<Value> Number =
      Math.convert(New, Information.types().basic("unsigned int"), At.Frame);
  if (!Number)
    return Number;
  Expected<uint64_t> Pc = Number->asInteger(At.Frame);
  if (!Pc)
    return Pc.takeError();
  if (At.Frame.IsCaller || !At.Frame.Machine->WritePc ||
      !At.Frame.Machine->WritePc(uint32_t(*Pc)))
    return createStringError("$pc cannot be set here.");
  return Number;
}

/// Gives \p Object, what \p Target names, the value \p New. The target is not
/// evaluated again, as it may have effects.
Expected<Value> ExpressionEvaluator::store(const ExpressionNode &Target,
                                           const Value &Object,
                                           const Value &New, Place At) const {
  if (Target.Kind == NodeKind::Convenience)
    return setConvenience(Target.Name, New, At);
  if (Target.Kind == NodeKind::Register && Target.Name == "pc")
    return setPc(New, At);
  Expected<Value> Converted = Math.convert(New, Object.type(), At.Frame);
  if (!Converted)
    return Converted;
  if (Object.isBitField()) {
    Expected<uint64_t> Number = Converted->asInteger(At.Frame);
    if (!Number)
      return Number.takeError();
    if (Error Problem = Object.assignInteger(At.Frame, *Number))
      return std::move(Problem);
    return Converted;
  }
  Expected<SmallVector<uint8_t, 16>> Bytes = Converted->bytes(At.Frame);
  if (!Bytes)
    return Bytes.takeError();
  if (Error Problem = Object.assign(At.Frame, *Bytes))
    return std::move(Problem);
  return Value::computed(Object.type(), *Bytes);
}

Expected<Value> ExpressionEvaluator::step(const ExpressionNode &Node,
                                          Place At) const {
  Expected<Value> Target = object(*Node.Operands[0], At);
  if (!Target)
    return Target;
  Expected<Value> Before = Target->snapshot(At.Frame);
  if (!Before)
    return Before;
  Value One = Value::integer(Information.types().basic("int"), 1);
  Expected<Value> New = Math.binary(Node.Operator, *Before, One, At.Frame);
  if (!New)
    return New;
  Expected<Value> Stored = store(*Node.Operands[0], *Target, *New, At);
  if (!Stored || Node.Kind == NodeKind::PreStep)
    return Stored;
  return Before;
}

Expected<Value> ExpressionEvaluator::assign(const ExpressionNode &Node,
                                            Place At) const {
  const ExpressionNode &Target = *Node.Operands[0];
  Expected<Value> New = run(*Node.Operands[1], At);
  if (!New)
    return New;
  bool IsPlain = Node.Operator == OperatorKind::None;
  // It need not have a value yet.
  if (IsPlain && Target.Kind == NodeKind::Convenience)
    return setConvenience(Target.Name, *New, At);
  Expected<Value> Object = object(Target, At);
  if (!Object)
    return Object;
  if (!IsPlain)
    New = Math.binary(Node.Operator, *Object, *New, At.Frame);
  if (!New)
    return New;
  return store(Target, *Object, *New, At);
}

Expected<Value> ExpressionEvaluator::member(const ExpressionNode &Node,
                                            Place At) const {
  Expected<Value> Object = object(*Node.Operands[0], At);
  if (!Object)
    return Object;
  // As in gdb, `.` and `->` both work on pointers.
  if (Node.Kind == NodeKind::ArrowMember || Object->type().isPointer()) {
    if (Object->isOptimizedOut())
      return createStringError("value has been optimized out");
    Object = dereference(*Object, At);
    if (!Object)
      return Object;
  }
  StringRef Name = Node.Name;
  StringRef Last = lastComponent(Name);
  if (Last == Name)
    return Names.member(*Object, Name, At.Frame);
  // `object.Base::member`.
  StringRef Wanted = Name.drop_back(Last.size() + 2);
  Expected<std::optional<Value>> Base = findBase(
      *Object,
      [&](const Type &Class) {
        return matchesName(Class.stripped().Name, Wanted);
      },
      At.Frame);
  if (!Base)
    return Base.takeError();
  if (const std::optional<Value> &Found = *Base)
    return Names.member(*Found, Last, At.Frame);
  return createStringError("There is no base named " + Wanted + ".");
}

Expected<Value> ExpressionEvaluator::index(const ExpressionNode &Node,
                                           Place At) const {
  Expected<Value> Object = object(*Node.Operands[0], At);
  if (!Object)
    return Object;
  Expected<Value> Index = object(*Node.Operands[1], At);
  if (!Index)
    return Index;
  // `2[array]` as C has it.
  if (Object->type().isInteger() && !Index->type().isInteger())
    std::swap(*Object, *Index);
  if (!Index->type().isInteger())
    return createStringError("An index must be an integer.");
  Expected<uint64_t> Number = Index->asInteger(At.Frame);
  if (!Number)
    return Number.takeError();
  if (!Object->type().isPointer()) {
    Expected<std::optional<Sequence>> Elements = elementsOf(*Object, At.Frame);
    if (!Elements)
      return Elements.takeError();
    const std::optional<Sequence> &List = *Elements;
    if (!List)
      return createStringError("cannot subscript something of type `" +
                               Object->type().Name + "'");
    bool IsInMemory = List->First.isValid() && List->First.address();
    if (!IsInMemory && *Number >= List->Count)
      return createStringError("no such vector element");
    return List->at(uint32_t(*Number));
  }
  Expected<Value> Sum =
      Math.binary(OperatorKind::Add, *Object, *Index, At.Frame);
  if (!Sum)
    return Sum;
  return dereference(*Sum, At);
}

Expected<Value> ExpressionEvaluator::repeat(const ExpressionNode &Node,
                                            Place At) const {
  Expected<Value> First = object(*Node.Operands[0], At);
  if (!First)
    return First;
  Expected<Value> Count = run(*Node.Operands[1], At);
  if (!Count)
    return Count;
  Expected<uint64_t> Number = integer(*Count, At);
  if (!Number)
    return Number.takeError();
  if (int64_t(*Number) <= 0 || *Number > (1u << 24))
    return createStringError("Invalid number " + Twine(int64_t(*Number)) +
                             " of repetitions.");
  std::optional<uint32_t> Address = First->address();
  if (!Address)
    return createStringError("Only values in memory can be extended with '@'.");
  return Value::inMemory(
      Information.types().arrayOf(First->type(), uint32_t(*Number)), *Address);
}

/// The value of \p Taken in the type that it has together with \p Other.
Expected<Value> ExpressionEvaluator::branch(const ExpressionNode &Taken,
                                            const ExpressionNode &Other,
                                            Place At) const {
  Expected<Value> Result = run(Taken, At);
  if (!Result || Other.hasEffects())
    return Result;
  // Only its type is wanted; it need not have a value.
  Expected<Value> Unused = run(Other, At);
  if (!Unused) {
    consumeError(Unused.takeError());
    return Result;
  }
  const Type *Common = Math.commonType(Result->type(), Unused->type());
  if (!Common || isSameType(*Common, Result->type()))
    return Result;
  return Math.convert(*Result, *Common, At.Frame);
}

Expected<Value> ExpressionEvaluator::sizeOf(const ExpressionNode &Node,
                                            Place At) const {
  const Type *Of = Node.Of;
  if (!Of) {
    Expected<Value> Operand = run(*Node.Operands[0], At);
    if (!Operand)
      return Operand;
    Of = &Operand->type();
  }
  if (Of->isReference())
    Of = Of->stripped().Target;
  if (Of->stripped().Kind == TypeKind::Incomplete)
    return createStringError(Of->Name + " is incomplete.");
  return Value::integer(Information.types().basic("unsigned int"), Of->Size);
}

Expected<Value> ExpressionEvaluator::run(const ExpressionNode &Node,
                                         Place At) const {
  switch (Node.Kind) {
  case NodeKind::Constant:
    return Node.Literal;
  case NodeKind::Name:
    return name(Node, At);
  case NodeKind::Register:
    return registerValue(Node.Name, At);
  case NodeKind::History:
  case NodeKind::Convenience:
    return earlier(Node, At);
  case NodeKind::TypeName:
    return createStringError("Attempt to use a type as an expression.");
  case NodeKind::PreStep:
  case NodeKind::PostStep:
    return step(Node, At);
  case NodeKind::Binary:
    return binary(Node, At);
  case NodeKind::LogicalAnd:
  case NodeKind::LogicalOr:
    return logical(Node, At);
  case NodeKind::Assign:
    return assign(Node, At);
  case NodeKind::AddressOf:
    return addressOf(Node, At);
  case NodeKind::Member:
  case NodeKind::ArrowMember:
    return member(Node, At);
  case NodeKind::Index:
    return index(Node, At);
  case NodeKind::Repeat:
    return repeat(Node, At);
  case NodeKind::SizeOf:
    return sizeOf(Node, At);
  default:
    return ofValue(Node, At);
  }
}

Expected<Value> ExpressionEvaluator::ofValue(const ExpressionNode &Node,
                                             Place At) const {
  Expected<Value> First = run(*Node.Operands[0], At);
  if (!First)
    return First;
  switch (Node.Kind) {
  case NodeKind::Unary:
    return Math.unary(Node.Operator, *First, At.Frame);
  case NodeKind::Dereference:
    return dereference(*First, At);
  case NodeKind::Comma:
    return run(*Node.Operands[1], At);
  case NodeKind::Conditional: {
    Expected<bool> Is = Math.isTrue(*First, At.Frame);
    if (!Is)
      return Is.takeError();
    return branch(*Node.Operands[*Is ? 1 : 2], *Node.Operands[*Is ? 2 : 1], At);
  }
  case NodeKind::Cast: {
    bool ToPlain = Node.Of->isArithmetic() || Node.Of->isPointer();
    if (ToPlain) {
      First = Math.decayed(*First, At.Frame);
      if (!First)
        return First;
    }
    return Math.convert(*First, *Node.Of, At.Frame, Node.KeepBits);
  }
  case NodeKind::At: {
    Expected<uint64_t> Address = integer(*First, At);
    if (!Address)
      return Address.takeError();
    return Value::inMemory(*Node.Of, uint32_t(*Address));
  }
  default:
    return createStringError("This expression cannot be evaluated.");
  }
}

} // namespace tp
