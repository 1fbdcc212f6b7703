//===- NameIndex.cpp - Entries of the debug information by name ----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/source/NameIndex.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/DebugInfo/DWARF/DWARFContext.h"

using namespace llvm;
using namespace llvm::dwarf;

namespace tp {

static constexpr StringLiteral kAnonymousNamespace = "(anonymous namespace)";

std::optional<int64_t> constantOf(const DWARFFormValue &Form) {
  // The forms of a fixed size do not say whether they are signed.
  bool IsSigned =
      is_contained({DW_FORM_sdata, DW_FORM_implicit_const}, Form.getForm());
  if (IsSigned)
    return Form.getAsSignedConstant();
  std::optional<uint64_t> Number = Form.getAsUnsignedConstant();
  return Number ? std::optional(int64_t(*Number)) : std::nullopt;
}

DWARFDie originOf(DWARFDie Die) {
  // A declaration, its definition, a copy: more are a loop.
  constexpr unsigned MaxOrigins = 16;
  for (unsigned I = 0; Die && I != MaxOrigins; ++I) {
    DWARFDie Next = Die.getAttributeValueAsReferencedDie(DW_AT_specification);
    if (!Next)
      Next = Die.getAttributeValueAsReferencedDie(DW_AT_abstract_origin);
    if (!Next)
      break;
    Die = Next;
  }
  return Die;
}

StringRef baseName(DWARFDie Die) {
  if (!Die)
    return {};
  return toStringRef(originOf(Die).find(DW_AT_name));
}

static bool isScope(Tag T) {
  switch (T) {
  case DW_TAG_namespace:
  case DW_TAG_structure_type:
  case DW_TAG_class_type:
  case DW_TAG_union_type:
  case DW_TAG_subprogram:
    return true;
  default:
    return false;
  }
}

std::string scopePrefix(DWARFDie Die) {
  std::string Prefix;
  Die = originOf(Die);
  if (!Die)
    return Prefix;
  for (DWARFDie Scope = Die.getParent(); Scope; Scope = Scope.getParent()) {
    if (!isScope(Scope.getTag()))
      continue;
    StringRef Name = baseName(Scope);
    if (Name.empty())
      Name = Scope.getTag() == DW_TAG_namespace ? StringRef(kAnonymousNamespace)
                                                : StringRef("(anonymous)");
    Prefix = (Name + "::" + Prefix).str();
    DWARFDie Origin = originOf(Scope);
    if (Origin != Scope)
      return scopePrefix(Origin) + Prefix;
  }
  return Prefix;
}

std::string qualifiedName(DWARFDie Die) {
  return scopePrefix(Die) + baseName(Die).str();
}

StringRef withoutTemplateArguments(StringRef Name) {
  if (!Name.ends_with(">") || Name.starts_with("operator"))
    return Name;
  unsigned Depth = 0;
  for (size_t I = Name.size(); I-- != 0;) {
    Depth += Name[I] == '>';
    Depth -= Name[I] == '<';
    if (Depth == 0)
      return Name.take_front(I);
  }
  return Name;
}

/// Where an operator's name begins, whose characters are no brackets: npos if
/// \p Name does not end with one.
static size_t operatorBegin(StringRef Name) {
  constexpr StringLiteral Keyword = "operator";
  size_t At = Name.rfind(Keyword);
  if (At == StringRef::npos || (At != 0 && Name[At - 1] != ':'))
    return StringRef::npos;
  StringRef Behind = Name.drop_front(At + Keyword.size());
  bool IsWord = !Behind.empty() && (isAlnum(Behind[0]) || Behind[0] == '_');
  return IsWord ? StringRef::npos : At;
}

/// Where the last `::` outside of brackets is, or npos.
static size_t lastSeparator(StringRef Name) {
  size_t Operator = operatorBegin(Name);
  if (Operator != StringRef::npos)
    return Operator >= 2 ? Operator - 2 : StringRef::npos;
  int Depth = 0;
  for (size_t I = Name.size(); I-- > 1;) {
    Depth += Name[I] == '>' || Name[I] == ')';
    Depth -= Name[I] == '<' || Name[I] == '(';
    if (Depth == 0 && Name[I] == ':' && Name[I - 1] == ':')
      return I - 1;
  }
  return StringRef::npos;
}

StringRef lastComponent(StringRef Qualified) {
  size_t At = lastSeparator(Qualified);
  return At == StringRef::npos ? Qualified : Qualified.drop_front(At + 2);
}

size_t parameterListOf(StringRef Name) {
  size_t Operator = operatorBegin(Name.take_front(Name.rfind(')')));
  size_t Begin = 0;
  if (Operator != StringRef::npos) {
    // Of `operator()(int)` the second bracket.
    Begin = Operator + StringRef("operator").size();
    if (Name.drop_front(Begin).starts_with("()"))
      Begin += 2;
    return Name.find('(', Begin);
  }
  int Depth = 0;
  for (size_t I = 0; I != Name.size(); ++I) {
    Depth += Name[I] == '<';
    Depth -= Name[I] == '>';
    if (Name[I] == '(' && Depth == 0 && I != 0 &&
        !Name.drop_front(I).starts_with(kAnonymousNamespace))
      return I;
  }
  return StringRef::npos;
}

static StringRef dropLastComponent(StringRef Qualified) {
  size_t At = lastSeparator(Qualified);
  return At == StringRef::npos ? StringRef() : Qualified.take_front(At);
}

/// `array<int, 4U>` and `array<int,4>` are the same.
static std::string normalized(StringRef Name) {
  std::string Result;
  bool InNumber = false;
  for (char C : Name) {
    bool IsWord = isAlnum(C) || C == '_';
    InNumber =
        IsWord && (InNumber ||
                   (isDigit(C) && (Result.empty() || (!isAlnum(Result.back()) &&
                                                      Result.back() != '_'))));
    bool IsSuffix = InNumber && (C == 'U' || C == 'L' || C == 'u' || C == 'l');
    if (C != ' ' && !IsSuffix)
      Result += C;
  }
  return Result;
}

static bool sameComponent(StringRef Have, StringRef Wanted) {
  return Have == Wanted || withoutTemplateArguments(Have) == Wanted ||
         (Wanted.contains('<') && normalized(Have) == normalized(Wanted));
}

bool matchesName(StringRef Qualified, StringRef Wanted) {
  bool FromGlobal = Wanted.consume_front("::");
  while (!Wanted.empty()) {
    StringRef Have = lastComponent(Qualified);
    if (!sameComponent(Have, lastComponent(Wanted))) {
      if (Have != kAnonymousNamespace || Qualified.empty())
        return false;
    } else {
      Wanted = dropLastComponent(Wanted);
    }
    Qualified = dropLastComponent(Qualified);
  }
  return !FromGlobal || Qualified.empty() || Qualified == kAnonymousNamespace;
}

NameIndex::NameIndex(DWARFContext &Dwarf) {
  for (const auto &Unit : Dwarf.normal_units())
    addUnit(*Unit);
}

void NameIndex::addUnit(DWARFUnit &Unit) {
  for (const DWARFDebugInfoEntry &Entry : Unit.dies())
    add(DWARFDie(&Unit, &Entry));
}

void NameIndex::add(DWARFDie Die) {
  switch (Die.getTag()) {
  case DW_TAG_subprogram:
    if (Die.find(DW_AT_low_pc) || Die.find(DW_AT_ranges))
      Functions.push_back(Die);
    break;
  case DW_TAG_variable:
  case DW_TAG_member:
    addVariable(Die);
    break;
  case DW_TAG_structure_type:
  case DW_TAG_class_type:
  case DW_TAG_union_type:
  case DW_TAG_enumeration_type:
  case DW_TAG_typedef:
  case DW_TAG_base_type: {
    StringRef Name = toStringRef(Die.find(DW_AT_name));
    if (Name.empty())
      break;
    Types[Name].push_back(Die);
    StringRef Plain = withoutTemplateArguments(Name);
    if (Plain != Name)
      Types[Plain].push_back(Die);
    break;
  }
  case DW_TAG_imported_declaration:
  case DW_TAG_imported_module:
    addImport(Die);
    break;
  case DW_TAG_enumerator:
    Enumerators[toStringRef(Die.find(DW_AT_name))].push_back(Die);
    break;
  default:
    break;
  }
}

void NameIndex::addImport(DWARFDie Die) {
  DWARFDie Target = Die.getAttributeValueAsReferencedDie(DW_AT_import);
  if (!Target)
    return;
  bool IsNamespace = Target.getTag() == DW_TAG_namespace;
  // The library's own, `using ::memcpy` in std, say nothing of the program.
  std::string Scope = scopePrefix(Die);
  if (StringRef(Scope).starts_with("std::"))
    return;
  Imports.push_back({Scope, qualifiedName(Target) + (IsNamespace ? "::" : "")});
}

size_t NameIndex::nearness(DWARFDie Candidate, StringRef Place,
                           const DWARFUnit *Unit) const {
  std::string Prefix = scopePrefix(Candidate);
  size_t Score = 1;
  if (!StringRef(Prefix).starts_with("std::"))
    Score += 2;
  if (Unit && Candidate.getDwarfUnit() == Unit)
    Score += 4;
  if (Place.starts_with(Prefix))
    return Score + 16 + 16 * Prefix.size();
  std::string Name = Prefix + baseName(Candidate).str();
  size_t Imported = 0;
  for (const Import &Using : Imports)
    if (Place.starts_with(Using.Scope) &&
        (Using.Name == Name || Using.Name == Prefix))
      Imported = std::max(Imported, 8 + 16 + 16 * Using.Scope.size());
  return Score + Imported;
}

/// A constant, or a global variable that the program no longer has.
static bool isGlobalWithoutPlace(DWARFDie Die) {
  for (DWARFDie Scope = Die.getParent(); Scope; Scope = Scope.getParent())
    if (Scope.isSubroutineDIE() || Scope.getTag() == DW_TAG_lexical_block)
      return false;
  if (Die.find(DW_AT_const_value))
    return true;
  return Die.getTag() == DW_TAG_variable && !Die.find(DW_AT_declaration);
}

/// Variables of functions without a fixed place belong to their blocks.
void NameIndex::addVariable(DWARFDie Die) {
  if (std::optional<DWARFFormValue> Location = Die.find(DW_AT_location)) {
    std::optional<ArrayRef<uint8_t>> Block = Location->getAsBlock();
    bool IsFixed =
        Block && !Block->empty() &&
        (is_contained({DW_OP_addr, DW_OP_addrx}, (*Block)[0]) ||
         is_contained({DW_OP_GNU_push_tls_address, DW_OP_form_tls_address},
                      Block->back()));
    if (!IsFixed)
      return;
  } else if (!isGlobalWithoutPlace(Die)) {
    return;
  }
  StringRef Name = baseName(Die);
  if (Name.empty())
    return;
  Variables.push_back(Die);
  VariablesByName[Name].push_back(Die);
  DWARFDie Origin = originOf(Die);
  if (Origin != Die)
    Definitions.try_emplace(Origin.getOffset(), Die);
}

ArrayRef<DWARFDie> NameIndex::variables(StringRef BaseName) const {
  auto Found = VariablesByName.find(BaseName);
  return Found == VariablesByName.end() ? ArrayRef<DWARFDie>()
                                        : ArrayRef(Found->second);
}

std::vector<DWARFDie> NameIndex::types(StringRef BaseName) const {
  auto Found = Types.find(BaseName);
  if (Found == Types.end())
    return {};
  std::vector<DWARFDie> Result;
  for (bool IsDeclaration : {false, true})
    copy_if(Found->second, std::back_inserter(Result), [&](DWARFDie Die) {
      return Die.find(DW_AT_declaration).has_value() == IsDeclaration;
    });
  return Result;
}

ArrayRef<DWARFDie> NameIndex::enumerators(StringRef Name) const {
  auto Found = Enumerators.find(Name);
  return Found == Enumerators.end() ? ArrayRef<DWARFDie>()
                                    : ArrayRef(Found->second);
}

DWARFDie NameIndex::definitionOf(DWARFDie Declaration) const {
  return Definitions.lookup(originOf(Declaration).getOffset());
}

} // namespace tp
