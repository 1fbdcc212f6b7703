//===- TypeText.cpp - The definition of a type as text -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/source/DebugInformation.h"

#include "debugger/source/NameIndex.h"

#include "llvm/Support/raw_ostream.h"

using namespace llvm;
using namespace llvm::dwarf;

namespace tp {

/// `int A[3]`, `float (*F)(int)`.
static std::string declaration(const Type &Of, StringRef Name) {
  StringRef Text = Of.Name;
  size_t Inner = Text.find("(*)");
  if (Inner != StringRef::npos)
    return (Text.take_front(Inner + 2) + Name + Text.drop_front(Inner + 2))
        .str();
  if (Of.Kind == TypeKind::Array) {
    size_t At = Text.find('[');
    if (At != StringRef::npos)
      return (Text.take_front(At).rtrim() + " " + Name + Text.drop_front(At))
          .str();
  }
  bool IsTight = Text.ends_with("*") || Text.ends_with("&");
  return (Text + (IsTight ? "" : " ") + Name).str();
}

static StringRef keyword(TypeKind Kind) {
  switch (Kind) {
  case TypeKind::Class:
    return "class";
  case TypeKind::Union:
    return "union";
  default:
    return "struct";
  }
}

static void writeMembers(raw_ostream &OS, const Type &Record, unsigned Indent) {
  for (const Member &Part : Record.Members) {
    if (Part.IsBase)
      continue;
    OS.indent(Indent);
    if (Part.Name.empty() && Part.Of->isRecord()) {
      OS << keyword(Part.Of->stripped().Kind) << " {\n";
      writeMembers(OS, Part.Of->stripped(), Indent + 4);
      OS.indent(Indent) << "};\n";
      continue;
    }
    OS << declaration(*Part.Of, Part.Name);
    if (Part.BitSize)
      OS << " : " << Part.BitSize;
    OS << ";\n";
  }
  for (const StaticMember &Part : Record.StaticMembers)
    OS.indent(Indent) << "static " << Part.Name << ";\n";
}

static void writeRecord(raw_ostream &OS, const Type &Record) {
  OS << keyword(Record.Kind) << ' ' << Record.Name;
  const char *Separator = " : ";
  for (const Member &Part : Record.Members)
    if (Part.IsBase) {
      OS << Separator << (Part.IsVirtualBase ? "virtual " : "") << Part.Name;
      Separator = ", ";
    }
  OS << " {\n";
  writeMembers(OS, Record, 4);
  OS << "}";
}

static void writeEnumeration(raw_ostream &OS, const Type &Enumeration) {
  OS << (Enumeration.IsScoped ? "enum class " : "enum ") << Enumeration.Name
     << " {";
  int64_t Next = 0;
  const char *Separator = "";
  for (const Enumerator &Named : Enumeration.Enumerators) {
    OS << Separator << Named.Name;
    if (Named.Value != Next)
      OS << " = " << Named.Value;
    Next = Named.Value + 1;
    Separator = ", ";
  }
  OS << "}";
}

/// The record or enumeration that a pointer, reference or array is of.
static const Type *innermost(const Type &Of) {
  const Type *At = &Of.stripped();
  while (At->isPointer() || At->isReference() || At->Kind == TypeKind::Array) {
    if (!At->Target)
      return nullptr;
    At = &At->Target->stripped();
  }
  bool HasDefinition = At->isRecord() || At->Kind == TypeKind::Enumeration;
  return HasDefinition && At != &Of.stripped() ? At : nullptr;
}

std::string describeType(const Type &Of) {
  std::string Text;
  raw_string_ostream OS(Text);
  const Type &Plain = Of.stripped();
  if (const Type *Inner = innermost(Plain)) {
    // The stars and brackets are what the name has behind the inner one's.
    size_t At = StringRef(Plain.Name).find(Inner->Name);
    if (At == StringRef::npos)
      return Plain.Name;
    OS << describeType(*Inner) << ' '
       << StringRef(Plain.Name).drop_front(At + Inner->Name.size()).ltrim();
    return Text;
  }
  if (Plain.isRecord())
    writeRecord(OS, Plain);
  else if (Plain.Kind == TypeKind::Enumeration)
    writeEnumeration(OS, Plain);
  else if (Plain.Kind == TypeKind::Incomplete)
    OS << "struct " << Plain.Name << " {<incomplete type>}";
  else
    OS << Plain.Name;
  return Text;
}

} // namespace tp
