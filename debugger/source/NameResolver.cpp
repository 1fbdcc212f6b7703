//===- NameResolver.cpp - What a name in an expression means -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/source/NameResolver.h"

#include "debugger/source/Children.h"
#include "debugger/source/DebugInformation.h"
#include "debugger/source/NameIndex.h"

#include "llvm/DebugInfo/DWARF/DWARFUnit.h"

using namespace llvm;
using namespace llvm::dwarf;

namespace tp {

bool NameResolver::isMemberName(const Type &Record, StringRef Name) const {
  const Type &Plain = Record.stripped();
  if (!Plain.isRecord())
    return false;
  for (const StaticMember &Part : Plain.StaticMembers)
    if (Part.Name == Name)
      return true;
  for (const Member &Part : Plain.Members) {
    if (Part.Name == Name && !Part.IsBase)
      return true;
    if ((Part.IsBase || Part.Name.empty()) && isMemberName(*Part.Of, Name))
      return true;
  }
  return false;
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
  if (std::optional<Value> Found = findMember(Object, Name))
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
  for (uint32_t Index : Map.findFunctions(Name)) {
    const FunctionInfo &Function = Map.function(Index);
    if (Function.InlinedInto)
      continue;
    return Value::inMemory(
        Information.types().function(
            Function.Die,
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
  if (std::optional<VariableInfo> Local = Known.findLocal(Frame, Name))
    return Use(BoundName::Variable, *Local);
  if (std::optional<VariableInfo> This = Known.findLocal(Frame, "this")) {
    const Type &Pointer = This->Of->stripped();
    if (Pointer.Target && isMemberName(*Pointer.Target, Name))
      return Use(BoundName::MemberOfThis, *This);
  }
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
  if (!Object)
    return Object;
  return member(*Object, Name, Frame);
}

} // namespace tp
