//===- Children.cpp - What a value consists of ---------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/source/Children.h"

#include "debugger/source/NameIndex.h"

#include "llvm/ADT/StringExtras.h"

using namespace llvm;

namespace tp {

Value Sequence::at(uint32_t Index) const {
  return First.part(*Element, Index * Element->Size);
}

static Value memberOf(const Value &Of, const Member &Part) {
  if (Part.BitSize)
    return Of.bits(*Part.Of, Part.Offset, Part.BitOffset, Part.BitSize);
  return Of.part(*Part.Of, Part.Offset);
}

std::optional<Value> findMember(const Value &Of, StringRef Name) {
  const Type &Record = Of.type().stripped();
  if (!Record.isRecord())
    return std::nullopt;
  for (const Member &Part : Record.Members)
    if (!Part.IsBase && Part.Name == Name)
      return memberOf(Of, Part);
  for (const Member &Part : Record.Members)
    if ((Part.IsBase && !Part.IsVirtualBase) || Part.Name.empty())
      if (std::optional<Value> Found = findMember(memberOf(Of, Part), Name))
        return Found;
  return std::nullopt;
}

Expected<Value> pointee(const Value &Of, const FrameContext &Frame) {
  const Type &Plain = Of.type().stripped();
  if (!Plain.isPointer() && !Plain.isReference())
    return createStringError("a value of type " + Of.type().Name +
                             " is no pointer");
  Expected<uint64_t> Address = Of.asInteger(Frame);
  if (!Address)
    return Address.takeError();
  if (Plain.Target->stripped().Kind == TypeKind::Void ||
      Plain.Kind == TypeKind::NullPointer)
    return createStringError("a pointer to void points to no object");
  return Value::inMemory(*Plain.Target, uint32_t(*Address));
}

/// A member anywhere in the implementation of a container.
static std::optional<Value> findDeep(const Value &Of, StringRef Name) {
  if (std::optional<Value> Found = findMember(Of, Name))
    return Found;
  for (const Member &Part : Of.type().stripped().Members)
    if (!Part.BitSize && Part.Of->isRecord())
      if (std::optional<Value> Found = findDeep(memberOf(Of, Part), Name))
        return Found;
  return std::nullopt;
}

static Expected<std::optional<Sequence>>
fromPointer(const Value &Begin, uint32_t Count, const FrameContext &Frame) {
  Sequence Result;
  Result.Element = Begin.type().stripped().Target;
  Result.Count = Count;
  if (Count) {
    Expected<Value> First = pointee(Begin, Frame);
    if (!First)
      return First.takeError();
    Result.First = *First;
  }
  return Result;
}

/// Of the members \p Begin, a pointer, and \p Size, how many.
static Expected<std::optional<Sequence>>
pointerAndSize(const Value &Of, StringRef Begin, StringRef Size,
               const FrameContext &Frame) {
  std::optional<Value> First = findDeep(Of, Begin);
  std::optional<Value> Count = findDeep(Of, Size);
  if (!First || !Count || !First->type().isPointer())
    return std::nullopt;
  Expected<uint64_t> Number = Count->asInteger(Frame);
  if (!Number)
    return Number.takeError();
  return fromPointer(*First, uint32_t(*Number), Frame);
}

static Expected<std::optional<Sequence>>
twoPointers(const Value &Of, StringRef Begin, StringRef End,
            const FrameContext &Frame) {
  std::optional<Value> First = findDeep(Of, Begin);
  std::optional<Value> Last = findDeep(Of, End);
  if (!First || !Last || !First->type().isPointer())
    return std::nullopt;
  Expected<uint64_t> From = First->asInteger(Frame);
  if (!From)
    return From.takeError();
  Expected<uint64_t> To = Last->asInteger(Frame);
  if (!To)
    return To.takeError();
  const Type &Element = *First->type().stripped().Target;
  if (*To < *From || Element.Size == 0)
    return std::nullopt;
  return fromPointer(*First, uint32_t(*To - *From) / Element.Size, Frame);
}

static Sequence ofArray(const Value &Of) {
  const Type &Array = Of.type().stripped();
  Sequence Result;
  Result.Element = Array.Target;
  Result.Count = Array.Count.value_or(0);
  Result.First = Of;
  return Result;
}

Expected<std::optional<Sequence>> elementsOf(const Value &Of,
                                             const FrameContext &Frame) {
  const Type &Plain = Of.type().stripped();
  if (Plain.Kind == TypeKind::Array || Plain.Kind == TypeKind::Vector)
    return ofArray(Of);
  if (!Plain.isRecord() || !StringRef(Plain.Name).starts_with("std::"))
    return std::nullopt;
  StringRef Name = withoutTemplateArguments(lastComponent(Plain.Name));
  if (Name == "array") {
    std::optional<Value> Elements = findMember(Of, "_M_elems");
    if (Elements && Elements->type().stripped().Kind == TypeKind::Array)
      return ofArray(*Elements);
    return std::nullopt;
  }
  if (Name == "basic_string_view")
    return pointerAndSize(Of, "_M_str", "_M_len", Frame);
  if (Name == "basic_string")
    return pointerAndSize(Of, "_M_p", "_M_string_length", Frame);
  if (Name == "initializer_list")
    return pointerAndSize(Of, "_M_array", "_M_len", Frame);
  if (Name == "vector")
    return twoPointers(Of, "_M_start", "_M_finish", Frame);
  if (Name == "span") {
    Expected<std::optional<Sequence>> Dynamic =
        pointerAndSize(Of, "_M_ptr", "_M_extent_value", Frame);
    if (!Dynamic || *Dynamic)
      return Dynamic;
    // A fixed extent is only in the type: span<int, 4U>.
    std::optional<Value> First = findMember(Of, "_M_ptr");
    uint32_t Count = 0;
    if (First && !StringRef(Plain.Name)
                      .rsplit(',')
                      .second.trim()
                      .rtrim("UL>")
                      .getAsInteger(10, Count))
      return fromPointer(*First, Count, Frame);
  }
  return std::nullopt;
}

/// A container that cannot be read is shown by its members.
static std::optional<Sequence> readableElements(const Value &Of,
                                                const FrameContext &Frame) {
  Expected<std::optional<Sequence>> Elements = elementsOf(Of, Frame);
  if (Elements)
    return std::move(*Elements);
  consumeError(Elements.takeError());
  return std::nullopt;
}

uint32_t childCount(const Value &Of, const FrameContext &Frame) {
  const Type &Plain = Of.type().stripped();
  if (std::optional<Sequence> Elements = readableElements(Of, Frame))
    return Elements->Count;
  if (Plain.isRecord())
    return uint32_t(Plain.Members.size());
  if (!Plain.isPointer() && !Plain.isReference())
    return 0;
  TypeKind Target = Plain.Target->stripped().Kind;
  return Target != TypeKind::Void && Target != TypeKind::Function &&
         Target != TypeKind::Incomplete && Plain.Kind != TypeKind::NullPointer;
}

Expected<std::vector<NamedValue>> children(const Value &Of,
                                           const FrameContext &Frame,
                                           uint32_t First, uint32_t Count) {
  std::vector<NamedValue> Result;
  uint32_t All = childCount(Of, Frame);
  First = std::min(First, All);
  uint32_t Last = First + std::min(Count, All - First);
  const Type &Plain = Of.type().stripped();
  if (std::optional<Sequence> Elements = readableElements(Of, Frame)) {
    for (uint32_t I = First; I != Last; ++I)
      Result.push_back({"[" + std::to_string(I) + "]", Elements->at(I), false});
    return Result;
  }
  if (Plain.isRecord()) {
    for (uint32_t I = First; I != Last; ++I) {
      const Member &Part = Plain.Members[I];
      Value Inner = Part.IsVirtualBase ? Value::optimizedOut(*Part.Of)
                                       : memberOf(Of, Part);
      Result.push_back({Part.Name, std::move(Inner), Part.IsBase});
    }
    return Result;
  }
  if (First == Last)
    return Result;
  Expected<Value> Target = pointee(Of, Frame);
  if (!Target)
    return Target.takeError();
  Result.push_back({Plain.isReference() ? "&" : "*", *Target, false});
  return Result;
}

} // namespace tp
