//===- TypeTable.cpp - Finds and makes types -----------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/source/TypeTable.h"

#include "debugger/source/NameIndex.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/DebugInfo/DWARF/DWARFUnit.h"

using namespace llvm;
using namespace llvm::dwarf;

namespace tp {

namespace {

struct BasicType {
  StringRef Name;
  TypeKind Kind;
  unsigned Bytes;
};

} // namespace

static constexpr BasicType kBasicTypes[] = {
    {"void", TypeKind::Void, 0},
    {"bool", TypeKind::Boolean, 1},
    {"char", TypeKind::Character, 1},
    {"signed char", TypeKind::Character, 1},
    {"unsigned char", TypeKind::Character, 1},
    {"wchar_t", TypeKind::Character, 4},
    {"char8_t", TypeKind::Character, 1},
    {"char16_t", TypeKind::Character, 2},
    {"char32_t", TypeKind::Character, 4},
    {"short", TypeKind::Signed, 2},
    {"unsigned short", TypeKind::Unsigned, 2},
    {"int", TypeKind::Signed, 4},
    {"unsigned int", TypeKind::Unsigned, 4},
    {"long", TypeKind::Signed, 4},
    {"unsigned long", TypeKind::Unsigned, 4},
    {"long long", TypeKind::Signed, 8},
    {"unsigned long long", TypeKind::Unsigned, 8},
    {"float", TypeKind::Float, 4},
    {"double", TypeKind::Float, 8},
    {"std::nullptr_t", TypeKind::NullPointer, 4},
};

TypeTable::TypeTable(const NameIndex &Names) : Names(Names) {}
TypeTable::~TypeTable() = default;

const Type &TypeTable::basic(StringRef Name) {
  auto [Entry, IsNew] = Basic.try_emplace(Name);
  if (!IsNew)
    return *Entry->second;
  const auto *Found = find_if(
      kBasicTypes, [&](const BasicType &Entry) { return Entry.Name == Name; });
  assert(Found != std::end(kBasicTypes) && "no such basic type");
  Entry->second = std::make_unique<Type>();
  Type &Known = *Entry->second;
  Known.Name = Name.str();
  Known.Kind = Found->Kind;
  Known.Size = Found->Bytes;
  Known.IsSignedCharacter =
      Name == "char" || Name == "signed char" || Name == "wchar_t";
  if (Found->Kind == TypeKind::NullPointer)
    Known.Target = &basic("void");
  return Known;
}

const Type &TypeTable::integer(unsigned Bytes, bool Signed) {
  switch (Bytes) {
  case 1:
    return basic(Signed ? "signed char" : "unsigned char");
  case 2:
    return basic(Signed ? "short" : "unsigned short");
  case 8:
    return basic(Signed ? "long long" : "unsigned long long");
  default:
    return basic(Signed ? "int" : "unsigned int");
  }
}

Type &TypeTable::derived(const Type &Base, uint64_t Key, bool &IsNew) {
  std::unique_ptr<Type> &Known = Derived[{&Base, Key}];
  IsNew = !Known;
  if (IsNew) {
    Known = std::make_unique<Type>();
    Known->Target = &Base;
  }
  return *Known;
}

static uint64_t keyOf(TypeKind Kind, uint64_t Count = 0) {
  return uint64_t(Kind) << 40 | Count;
}

/// `int *`, `int **`, `int (*)[4]`.
static std::string pointerName(const Type &Target, StringRef Mark) {
  const Type &Plain = Target;
  if (Plain.Kind == TypeKind::Array || Plain.Kind == TypeKind::Function) {
    StringRef Name = Plain.Name;
    size_t At = Name.find(Plain.Kind == TypeKind::Array ? '[' : '(');
    if (At != StringRef::npos)
      return (Name.take_front(At).rtrim() + " (" + Mark + ")" +
              Name.drop_front(At))
          .str();
  }
  bool IsTight = StringRef(Target.Name).ends_with("*") ||
                 StringRef(Target.Name).ends_with("&");
  return (Target.Name + (IsTight ? "" : " ") + Mark).str();
}

const Type &TypeTable::pointerTo(const Type &Target) {
  bool IsNew;
  Type &Result = derived(Target, keyOf(TypeKind::Pointer), IsNew);
  if (IsNew) {
    Result.Kind = TypeKind::Pointer;
    Result.Size = 4;
    Result.Name = pointerName(Target, "*");
  }
  return Result;
}

const Type &TypeTable::referenceTo(const Type &Target) {
  bool IsNew;
  Type &Result = derived(Target, keyOf(TypeKind::LvalueReference), IsNew);
  if (IsNew) {
    Result.Kind = TypeKind::LvalueReference;
    Result.Size = 4;
    Result.Name = pointerName(Target, "&");
  }
  return Result;
}

const Type &TypeTable::arrayOf(const Type &Element, uint32_t Count) {
  bool IsNew;
  Type &Result = derived(Element, keyOf(TypeKind::Array, Count), IsNew);
  if (IsNew) {
    Result.Kind = TypeKind::Array;
    Result.Count = Count;
    Result.Size = Element.Size * Count;
    StringRef Name = Element.Name;
    size_t At =
        Element.Kind == TypeKind::Array ? Name.find('[') : StringRef::npos;
    StringRef Before = At == StringRef::npos ? Name : Name.take_front(At);
    StringRef Behind = At == StringRef::npos ? "" : Name.drop_front(At);
    Result.Name = (Before.rtrim() + "[" + Twine(Count) + "]" + Behind).str();
  }
  return Result;
}

const Type &TypeTable::qualified(TypeKind Qualifier, const Type &Target) {
  bool IsNew;
  Type &Result = derived(Target, keyOf(Qualifier), IsNew);
  if (IsNew) {
    StringRef Word = Qualifier == TypeKind::Const ? "const" : "volatile";
    Result.Kind = Qualifier;
    Result.Size = Target.Size;
    Result.Name = Target.isPointer() ? Target.Name + " " + Word.str()
                                     : Word.str() + " " + Target.Name;
  }
  return Result;
}

const Type &TypeTable::function(const Type &Result, StringRef Parameters) {
  std::string Name = Result.Name + " " + Parameters.str();
  std::unique_ptr<Type> &Known = Basic[Name];
  if (!Known) {
    Known = std::make_unique<Type>();
    Known->Kind = TypeKind::Function;
    Known->Name = Name;
    Known->Target = &Result;
  }
  return *Known;
}

const Type &TypeTable::typeOf(DWARFDie Die) {
  if (std::optional<DWARFFormValue> Form = Die.findRecursively(DW_AT_type))
    return fromDie(Die.getAttributeValueAsReferencedDie(*Form));
  return basic("void");
}

const Type &TypeTable::fromDie(DWARFDie Die) {
  if (!Die)
    return basic("void");
  Die = Die.resolveTypeUnitReference();
  auto Known = ByDie.find(Die.getOffset());
  if (Known != ByDie.end())
    return *Known->second;
  auto Made = std::make_unique<Type>();
  Type &Result = *Made;
  // Before its parts, which may lead back to it.
  ByDie.try_emplace(Die.getOffset(), std::move(Made));
  read(Result, Die);
  return Result;
}

const Type *TypeTable::find(StringRef Name, DWARFDie Scope) {
  if (llvm::any_of(kBasicTypes,
                   [&](const BasicType &Entry) { return Entry.Name == Name; }))
    return &basic(Name);
  std::string Place;
  const DWARFUnit *Unit = nullptr;
  if (Scope) {
    Place = qualifiedName(Scope) + "::";
    Unit = Scope.getDwarfUnit();
  }
  DWARFDie Best;
  size_t BestNearness = 0;
  StringRef Last = lastComponent(Name);
  for (DWARFDie Die : Names.types(withoutTemplateArguments(Last))) {
    if (!matchesName(qualifiedName(Die), Name))
      continue;
    // Definitions come before declarations, and `Box` itself before `Box<int>`.
    size_t Near = 4 * Names.nearness(Die, Place, Unit) +
                  (Die.find(DW_AT_declaration) ? 0 : 2) +
                  (StringRef(baseName(Die)) == Last ? 1 : 0);
    if (Near > BestNearness) {
      Best = Die;
      BestNearness = Near;
    }
  }
  return Best ? &fromDie(Best) : nullptr;
}

} // namespace tp
