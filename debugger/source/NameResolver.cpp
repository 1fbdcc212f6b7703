//===- NameResolver.cpp - What a name in an expression means -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/source/NameResolver.h"

#include "debugger/source/Children.h"
#include "debugger/source/DebugInformation.h"
#include "debugger/source/NameIndex.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/DebugInfo/DWARF/DWARFUnit.h"

using namespace llvm;
using namespace llvm::dwarf;

namespace tp {

bool NameResolver::isMemberName(const Type &Record, StringRef Name) const {
  const Type &Plain = Record.stripped();
  if (!Plain.isRecord())
    return false;
  if (Plain.hasMember(Name))
    return true;
  for (const StaticMember &Part : Plain.StaticMembers)
    if (Part.Name == Name)
      return true;
  return any_of(Plain.Members, [&](const Member &Part) {
    return Part.IsBase && isMemberName(*Part.Of, Name);
  });
}

/// The class whose `this` the lambda \p Closure holds; nullptr if it holds
/// none.
static const Type *capturedThis(const Type &Closure) {
  for (const Member &Part : Closure.stripped().Members)
    if (Part.Name == "this")
      return Part.Of->stripped().Target;
  return nullptr;
}

Expected<std::optional<Value>>
NameResolver::staticMember(const Type &Record, StringRef Name,
                           const FrameContext &Frame) const {
  const Type &Plain = Record.stripped();
  for (const StaticMember &Part : Plain.StaticMembers) {
    if (Part.Name != Name)
      continue;
    DWARFDie Definition = Information.names().definitionOf(Part.Die);
    VariableInfo Info;
    Info.Name = Part.Name;
    Info.Die = Definition ? Definition : Part.Die;
    Info.Of = &Information.types().typeOf(Part.Die);
    return Information.variables().value(Info, Frame);
  }
  for (const Member &Part : Plain.Members)
    if (Part.IsBase) {
      Expected<std::optional<Value>> Found =
          staticMember(*Part.Of, Name, Frame);
      if (!Found || *Found)
        return Found;
    }
  return std::nullopt;
}

Expected<Value> NameResolver::member(const Value &Object, StringRef Name,
                                     const FrameContext &Frame) const {
  if (!Object.type().isRecord())
    return createStringError(
        "Attempt to extract a component of a value that is not a structure.");
  if (Object.type().stripped().Kind == TypeKind::Incomplete)
    return createStringError(Object.type().Name + " is incomplete.");
  Expected<std::optional<Value>> Member = findMember(Object, Name, Frame);
  if (!Member)
    return Member.takeError();
  if (const std::optional<Value> &Found = *Member)
    return *Found;
  Expected<std::optional<Value>> Static =
      staticMember(Object.type(), Name, Frame);
  if (!Static)
    return Static.takeError();
  if (const std::optional<Value> &Found = *Static)
    return *Found;
  return createStringError("There is no member named " + Name + ".");
}

std::optional<Value> NameResolver::enumerator(StringRef Name,
                                              const FrameContext &Frame) const {
  for (DWARFDie Die : Information.names().enumerators(lastComponent(Name))) {
    DWARFDie Enumeration = Die.getParent();
    bool IsScoped = Enumeration.find(DW_AT_enum_class).has_value();
    std::string Outer = scopePrefix(Enumeration);
    std::string Inner = Outer + baseName(Enumeration).str() + "::";
    StringRef Last = baseName(Die);
    if (!matchesName(Inner + Last.str(), Name) &&
        (IsScoped || !matchesName(Outer + Last.str(), Name)))
      continue;
    // A scoped one is never meant without its enumeration.
    if (IsScoped && !Name.contains("::"))
      continue;
    const Type &Of = Information.types().fromDie(Enumeration);
    for (const Enumerator &Named : Of.Enumerators)
      if (Named.Name == Last)
        return Value::integer(Of, uint64_t(Named.Value));
  }
  return std::nullopt;
}

std::optional<Value> NameResolver::function(StringRef Name) const {
  const SourceMap &Map = Information.map();
  TypeTable &Types = Information.types();
  for (uint32_t Index : Map.findFunctions(Name)) {
    const FunctionInfo &Function = Map.function(Index);
    if (Function.InlinedInto)
      continue;
    return Value::inMemory(
        Types.function(
            Function.Die ? Types.typeOf(Function.Die) : Types.basic("void"),
            StringRef(Function.Name).drop_front(Function.QualifiedName.size())),
        Function.Entry);
  }
  return std::nullopt;
}

/// `Class::Member` of a constant that is only declared.
Expected<std::optional<Value>>
NameResolver::qualifiedMember(StringRef Name, const FrameContext &Frame) const {
  StringRef Last = lastComponent(Name);
  StringRef Class = Name.drop_back(Last.size());
  if (!Class.consume_back("::"))
    return std::nullopt;
  if (const Type *Record = Information.types().find(Class))
    return staticMember(*Record, Last, Frame);
  return std::nullopt;
}

Expected<BoundName> NameResolver::bind(StringRef Name,
                                       const FrameContext &Frame) const {
  BoundName Result;
  Result.Pc = Frame.lookupPc();
  Result.InlineDepth = Frame.InlineDepth;
  const Variables &Known = Information.variables();
  auto Use = [&](BoundName::NameKind Kind, const VariableInfo &Info) {
    Result.Kind = Kind;
    Result.Info = Info;
    return Result;
  };
  std::optional<VariableInfo> This = Known.findLocal(Frame, "this");
  const Type *Object = This ? This->Of->stripped().Target : nullptr;
  // In a lambda it is what the lambda holds.
  const Type *Captured = Object ? capturedThis(*Object) : nullptr;
  if (This && Captured && Name == "this")
    return Use(BoundName::MemberOfThis, *This);
  if (std::optional<VariableInfo> Local = Known.findLocal(Frame, Name))
    return Use(BoundName::Variable, *Local);
  if (This && Object && isMemberName(*Object, Name))
    return Use(BoundName::MemberOfThis, *This);
  if (This && Captured && isMemberName(*Captured, Name))
    return Use(BoundName::MemberOfCaptured, *This);
  if (std::optional<VariableInfo> Global = Known.findGlobal(Frame, Name))
    return Use(BoundName::Variable, *Global);
  if (std::optional<Value> Named = enumerator(Name, Frame)) {
    Result.Fixed = *Named;
    return Result;
  }
  Expected<std::optional<Value>> Static = qualifiedMember(Name, Frame);
  if (!Static)
    return Static.takeError();
  if (const std::optional<Value> &Found = *Static) {
    Result.Fixed = *Found;
    return Result;
  }
  if (std::optional<Value> Code = function(Name)) {
    Result.Fixed = *Code;
    return Result;
  }
  return createStringError("No symbol \"" + Name + "\" in current context.");
}

Expected<Value> NameResolver::value(const BoundName &Bound, StringRef Name,
                                    const FrameContext &Frame) const {
  if (Bound.Kind == BoundName::Constant)
    return Bound.Fixed;
  Expected<Value> Found = Information.variables().value(Bound.Info, Frame);
  if (!Found || Bound.Kind == BoundName::Variable)
    return Found;
  if (Found->isOptimizedOut())
    return createStringError("value of \"this\" has been optimized out");
  Expected<Value> Object = pointee(*Found, Frame);
  if (Object && Bound.Kind == BoundName::MemberOfCaptured) {
    Expected<Value> Captured = member(*Object, "this", Frame);
    if (!Captured)
      return Captured;
    Object = pointee(*Captured, Frame);
  }
  if (!Object)
    return Object;
  return member(*Object, Name, Frame);
}

} // namespace tp
