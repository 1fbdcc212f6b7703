//===- Variables.cpp - The variables that can be seen at a place ---------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/source/Variables.h"

#include "debugger/source/LocationEvaluator.h"
#include "debugger/source/NameIndex.h"
#include "debugger/source/SourceMap.h"
#include "debugger/source/TypeTable.h"

#include "llvm/ADT/DenseSet.h"
#include "llvm/ADT/StringSet.h"
#include "llvm/DebugInfo/DWARF/DWARFUnit.h"

using namespace llvm;
using namespace llvm::dwarf;

namespace tp {

Variables::Variables(const SourceMap &Map, const NameIndex &Names,
                     TypeTable &Types, const LocationEvaluator &Locations)
    : Map(Map), Names(Names), Types(Types), Locations(Locations) {}

VariableInfo Variables::describe(DWARFDie Die) const {
  VariableInfo Result;
  Result.Name = baseName(Die).str();
  Result.Of = &Types.typeOf(Die);
  Result.Die = Die;
  Result.IsParameter = Die.getTag() == DW_TAG_formal_parameter;
  Result.IsArtificial = Die.findRecursively(DW_AT_artificial).has_value();
  Result.Declared = Map.declarationOf(Die);
  return Result;
}

static bool isVariable(DWARFDie Die) {
  return Die.getTag() == DW_TAG_variable ||
         Die.getTag() == DW_TAG_formal_parameter;
}

/// The variables of one block; of a function also those that the copy at hand
/// has lost, in the order of their declaration.
static std::vector<DWARFDie> variablesOf(DWARFDie Block) {
  std::vector<DWARFDie> Result;
  DWARFDie Origin =
      Block.getAttributeValueAsReferencedDie(DW_AT_abstract_origin);
  DenseMap<uint64_t, DWARFDie> Here;
  for (DWARFDie Child : Block.children())
    if (isVariable(Child))
      Here[originOf(Child).getOffset()] = Child;
  bool HasModel = Origin && Block.isSubroutineDIE();
  DenseSet<uint64_t> Added;
  if (HasModel)
    for (DWARFDie Child : Origin.children())
      if (isVariable(Child)) {
        DWARFDie Copy = Here.lookup(Child.getOffset());
        Result.push_back(Copy ? Copy : Child);
        Added.insert(Result.back().getOffset());
      }
  for (DWARFDie Child : Block.children())
    if (isVariable(Child) && !Added.contains(Child.getOffset()))
      Result.push_back(Child);
  return Result;
}

/// The blocks of the frame's function around its place, the innermost first.
static std::vector<DWARFDie> blocksOf(const SourceMap &Map,
                                      const FrameContext &Frame) {
  std::vector<DWARFDie> Result;
  std::vector<InlinedCall> Calls = Map.callsAt(Frame.lookupPc());
  if (Calls.empty())
    return Result;
  size_t Depth = std::min<size_t>(Frame.InlineDepth, Calls.size() - 1);
  for (DWARFDie Die = Calls[Depth].Die; Die; Die = Die.getParent()) {
    Result.push_back(Die);
    if (Die.isSubroutineDIE())
      break;
  }
  return Result;
}

std::vector<VariableInfo>
Variables::arguments(const FrameContext &Frame) const {
  std::vector<VariableInfo> Result;
  std::vector<DWARFDie> Blocks = blocksOf(Map, Frame);
  if (Blocks.empty())
    return Result;
  for (DWARFDie Die : variablesOf(Blocks.back()))
    if (Die.getTag() == DW_TAG_formal_parameter)
      Result.push_back(describe(Die));
  return Result;
}

std::vector<VariableInfo> Variables::locals(const FrameContext &Frame) const {
  std::vector<VariableInfo> Result;
  StringSet<> Seen;
  unsigned Depth = 0;
  for (DWARFDie Block : blocksOf(Map, Frame)) {
    StringSet<> Here;
    for (DWARFDie Die : variablesOf(Block)) {
      VariableInfo Info = describe(Die);
      if (Info.Name.empty())
        continue;
      Here.insert(Info.Name);
      if (Info.IsParameter || Info.IsArtificial)
        continue;
      Info.BlockDepth = Depth;
      Info.IsShadowed = Seen.contains(Info.Name);
      Result.push_back(std::move(Info));
    }
    for (const auto &Entry : Here)
      Seen.insert(Entry.getKey());
    ++Depth;
  }
  return Result;
}

std::vector<VariableInfo> Variables::globals() const {
  std::vector<VariableInfo> Result;
  for (DWARFDie Die : Names.variables()) {
    VariableInfo Info = describe(Die);
    Info.Name = qualifiedName(Die);
    Result.push_back(std::move(Info));
  }
  llvm::sort(Result, [](const VariableInfo &A, const VariableInfo &B) {
    return std::tie(A.Name, A.Declared.File, A.Declared.Line) <
           std::tie(B.Name, B.Declared.File, B.Declared.Line);
  });
  return Result;
}

std::optional<VariableInfo> Variables::find(const FrameContext &Frame,
                                            StringRef Name) const {
  if (std::optional<VariableInfo> Local = findLocal(Frame, Name))
    return Local;
  return findGlobal(Frame, Name);
}

/// The value that the template of \p Function, or of a class around it, was
/// given for its parameter \p Name.
static DWARFDie templateArgument(DWARFDie Function, StringRef Name) {
  DWARFDie Model =
      Function.getAttributeValueAsReferencedDie(DW_AT_abstract_origin);
  SmallVector<DWARFDie, 8> Scopes = {Function};
  if (Model)
    Scopes.push_back(Model);
  for (DWARFDie Scope = originOf(Function);
       Scope.getTag() != DW_TAG_namespace && Scope.getParent();
       Scope = Scope.getParent())
    Scopes.push_back(Scope);
  for (DWARFDie Scope : Scopes)
    for (DWARFDie Child : Scope.children())
      if (Child.getTag() == DW_TAG_template_value_parameter &&
          baseName(Child) == Name)
        return Child;
  return {};
}

std::optional<VariableInfo> Variables::findLocal(const FrameContext &Frame,
                                                 StringRef Name) const {
  if (Name.contains("::"))
    return std::nullopt;
  unsigned Depth = 0;
  std::vector<DWARFDie> Blocks = blocksOf(Map, Frame);
  for (DWARFDie Block : Blocks) {
    for (DWARFDie Die : variablesOf(Block))
      if (baseName(Die) == Name) {
        VariableInfo Info = describe(Die);
        Info.BlockDepth = Depth;
        return Info;
      }
    ++Depth;
  }
  if (!Blocks.empty())
    if (DWARFDie Argument = templateArgument(Blocks.back(), Name))
      return describe(Argument);
  return std::nullopt;
}

std::optional<VariableInfo> Variables::findGlobal(const FrameContext &Frame,
                                                  StringRef Name) const {
  std::vector<DWARFDie> Blocks = blocksOf(Map, Frame);
  std::string Place;
  DWARFUnit *Unit = nullptr;
  if (!Blocks.empty()) {
    Place = qualifiedName(Blocks.back()) + "::";
    Unit = Blocks.back().getDwarfUnit();
  }
  DWARFDie Best;
  size_t BestNearness = 0;
  for (DWARFDie Die : Names.variables(lastComponent(Name))) {
    if (!matchesName(qualifiedName(Die), Name))
      continue;
    size_t Nearness = Names.nearness(Die, Place, Unit);
    if (Nearness > BestNearness) {
      Best = Die;
      BestNearness = Nearness;
    }
  }
  if (!Best)
    return std::nullopt;
  return describe(Best);
}

/// The type of a variable in this frame: arrays of variable size have theirs.
Expected<const Type *> Variables::typeOf(const VariableInfo &Variable,
                                         const FrameContext &Frame) const {
  const Type &Plain = Variable.Of->stripped();
  if (Plain.Kind != TypeKind::Array || Plain.Count || !Plain.Die)
    return Variable.Of;
  SmallVector<uint32_t, 2> Counts;
  for (DWARFDie Child : Plain.Die.children()) {
    if (Child.getTag() != DW_TAG_subrange_type)
      continue;
    Expected<std::optional<int64_t>> Count =
        Locations.number(Child, DW_AT_count, Frame);
    if (!Count)
      return Count.takeError();
    const std::optional<int64_t> &Known = *Count;
    if (!Known)
      return Variable.Of;
    Counts.push_back(uint32_t(*Known));
  }
  const Type *Result = &Types.typeOf(Plain.Die);
  for (uint32_t Count : reverse(Counts))
    Result = &Types.arrayOf(*Result, Count);
  return Result;
}

Expected<Value> Variables::value(const VariableInfo &Variable,
                                 const FrameContext &Frame) const {
  Expected<const Type *> Of = typeOf(Variable, Frame);
  if (!Of)
    return Of.takeError();
  Expected<std::vector<ValuePiece>> Places =
      Locations.locate(Variable.Die, (*Of)->Size, Frame);
  if (!Places)
    return Places.takeError();
  return Value::inPieces(**Of, *Places);
}

} // namespace tp
