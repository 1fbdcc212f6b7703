//===- Children.cpp - What a value consists of ---------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/source/Children.h"

#include "debugger/source/NameIndex.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/Support/Endian.h"

using namespace llvm;

namespace tp {

Value Sequence::at(uint32_t Index) const {
  return First.part(*Element, Index * Element->Size);
}

static Expected<uint32_t> wordAt(uint32_t Address, const FrameContext &Frame) {
  uint8_t Bytes[4];
  if (!Frame.read(Address, Bytes))
    return cannotAccess(Address);
  return support::endian::read32le(Bytes);
}

/// The vtable of the object says where a virtual base is.
static Expected<Value> virtualBase(const Value &Of, const Member &Base,
                                   const FrameContext &Frame) {
  std::optional<uint32_t> Object = Of.address();
  if (!Object || !Base.VirtualBaseSlot)
    return createStringError("The virtual base " + Base.Name +
                             " can only be found in memory.");
  Expected<uint32_t> Table = wordAt(*Object, Frame);
  if (!Table)
    return Table.takeError();
  Expected<uint32_t> Offset = wordAt(*Table - Base.VirtualBaseSlot, Frame);
  if (!Offset)
    return Offset.takeError();
  return Value::inMemory(*Base.Of, *Object + *Offset);
}

static Expected<Value> memberOf(const Value &Of, const Member &Part,
                                const FrameContext &Frame) {
  if (Part.IsVirtualBase)
    return virtualBase(Of, Part, Frame);
  if (Part.BitSize)
    return Of.bits(*Part.Of, Part.Offset, Part.BitOffset, Part.BitSize);
  return Of.part(*Part.Of, Part.Offset);
}

/// What \p Find finds in the parts of \p Of that \p IsSearched, the first one.
static Expected<std::optional<Value>>
findInParts(const Value &Of, const FrameContext &Frame,
            function_ref<bool(const Member &)> IsSearched,
            function_ref<Expected<std::optional<Value>>(const Value &)> Find) {
  for (const Member &Part : Of.type().stripped().Members) {
    if (!IsSearched(Part))
      continue;
    Expected<Value> Inner = memberOf(Of, Part, Frame);
    if (!Inner)
      return Inner.takeError();
    Expected<std::optional<Value>> Found = Find(*Inner);
    if (!Found || *Found)
      return Found;
  }
  return std::nullopt;
}

Expected<std::optional<Value>> findMember(const Value &Of, StringRef Name,
                                          const FrameContext &Frame) {
  const Type &Record = Of.type().stripped();
  if (!Record.isRecord())
    return std::nullopt;
  for (const Member &Part : Record.Members)
    if (!Part.IsBase && Part.Name == Name)
      return memberOf(Of, Part, Frame);
  return findInParts(
      Of, Frame,
      [&](const Member &Part) {
        return (Part.IsBase || Part.Name.empty()) && Part.Of->hasMember(Name);
      },
      [&](const Value &Inner) { return findMember(Inner, Name, Frame); });
}

/// Whether \p Derived is \p Base or has it as its base.
static bool hasBase(const Type &Derived,
                    function_ref<bool(const Type &)> IsWanted) {
  return IsWanted(Derived) ||
         any_of(Derived.stripped().Members, [&](const Member &Part) {
           return Part.IsBase && hasBase(*Part.Of, IsWanted);
         });
}

Expected<std::optional<Value>>
findBase(const Value &Of, function_ref<bool(const Type &)> IsWanted,
         const FrameContext &Frame) {
  if (IsWanted(Of.type()))
    return Of;
  return findInParts(
      Of, Frame,
      [&](const Member &Part) {
        return Part.IsBase && hasBase(*Part.Of, IsWanted);
      },
      [&](const Value &Inner) { return findBase(Inner, IsWanted, Frame); });
}

/// How far in \p Derived its base \p Base begins; nothing if it has none or a
/// virtual one is between them.
static std::optional<uint32_t> offsetOfBase(const Type &Derived,
                                            const Type &Base) {
  if (isSameType(Derived, Base))
    return 0;
  for (const Member &Part : Derived.stripped().Members)
    if (Part.IsBase && !Part.IsVirtualBase)
      if (std::optional<uint32_t> Offset = offsetOfBase(*Part.Of, Base))
        return Part.Offset + *Offset;
  return std::nullopt;
}

Expected<std::optional<Value>> asRelatedClass(const Value &Of, const Type &To,
                                              const FrameContext &Frame) {
  if (!Of.type().isRecord() || !To.isRecord())
    return std::nullopt;
  Expected<std::optional<Value>> Base = findBase(
      Of, [&](const Type &Class) { return isSameType(Class, To); }, Frame);
  if (!Base)
    return Base;
  if (std::optional<Value> &Found = *Base)
    return Found->as(To);
  std::optional<uint32_t> Address = Of.address();
  bool IsBase = hasBase(
      To, [&](const Type &Class) { return isSameType(Class, Of.type()); });
  if (!Address || !IsBase)
    return std::nullopt;
  std::optional<uint32_t> Offset = offsetOfBase(To, Of.type());
  if (!Offset)
    return createStringError("A virtual base does not say where the " +
                             To.Name + " around it is.");
  return Value::inMemory(To, *Address - *Offset);
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
static Expected<std::optional<Value>> findDeep(const Value &Of, StringRef Name,
                                               const FrameContext &Frame) {
  Expected<std::optional<Value>> Direct = findMember(Of, Name, Frame);
  if (!Direct || *Direct)
    return Direct;
  return findInParts(
      Of, Frame, [](const Member &Part) { return Part.Of->isRecord(); },
      [&](const Value &Inner) { return findDeep(Inner, Name, Frame); });
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
  Expected<std::optional<Value>> Pointer = findDeep(Of, Begin, Frame);
  if (!Pointer)
    return Pointer.takeError();
  Expected<std::optional<Value>> Extent = findDeep(Of, Size, Frame);
  if (!Extent)
    return Extent.takeError();
  const std::optional<Value> &First = *Pointer, &Count = *Extent;
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
  Expected<std::optional<Value>> Low = findDeep(Of, Begin, Frame);
  if (!Low)
    return Low.takeError();
  Expected<std::optional<Value>> High = findDeep(Of, End, Frame);
  if (!High)
    return High.takeError();
  const std::optional<Value> &First = *Low, &Last = *High;
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
    Expected<std::optional<Value>> Member = findMember(Of, "_M_elems", Frame);
    if (!Member)
      return Member.takeError();
    const std::optional<Value> &Elements = *Member;
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
    Expected<std::optional<Value>> Pointer = findMember(Of, "_M_ptr", Frame);
    if (!Pointer)
      return Pointer.takeError();
    const std::optional<Value> &First = *Pointer;
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
      Expected<Value> Inner = memberOf(Of, Part, Frame);
      if (!Inner) {
        consumeError(Inner.takeError());
        Inner = Value::optimizedOut(*Part.Of);
      }
      Result.push_back({Part.Name, std::move(*Inner), Part.IsBase});
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
