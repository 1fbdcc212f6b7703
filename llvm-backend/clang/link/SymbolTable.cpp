//===- SymbolTable.cpp - The global symbols of a program ------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/link/ElfInput.h"

using namespace llvm;

namespace tp {

Symbol &SymbolTable::get(StringRef Name) {
  auto [Entry, IsNew] = ByName.try_emplace(Name, nullptr);
  if (IsNew) {
    Symbols.emplace_back();
    Entry->second = &Symbols.back();
    Entry->second->Name = Entry->getKey();
  }
  return *Entry->second;
}

Symbol *SymbolTable::find(StringRef Name) const { return ByName.lookup(Name); }

static int strength(const Symbol &Definition) {
  if (!Definition.Defined)
    return 0;
  if (Definition.isWeak())
    return 1;
  return Definition.Common ? 2 : 3;
}

static StringRef fileOf(const Symbol &Definition) {
  return Definition.File ? StringRef(Definition.File->name()) : "the linker";
}

void SymbolTable::define(const Symbol &Definition, LinkDiagnostics &Diags) {
  Symbol &Known = get(Definition.Name);
  int Old = strength(Known), New = strength(Definition);
  if (Old == 3 && New == 3) {
    Diags.error("duplicate symbol: " + Definition.Name + "\n  defined in " +
                fileOf(Known) + "\n  defined in " + fileOf(Definition));
    return;
  }
  bool IsLargerCommon = Old == 2 && New == 2 && Definition.Size > Known.Size;
  if (New <= Old && !IsLargerCommon)
    return;
  StringRef Name = Known.Name;
  bool WeaklyReferenced = Known.WeaklyReferenced;
  uint32_t CommonAlignment =
      IsLargerCommon ? std::max(Known.Value, Definition.Value) : 0;
  Known = Definition;
  Known.Name = Name;
  Known.WeaklyReferenced = WeaklyReferenced;
  if (IsLargerCommon)
    Known.Value = CommonAlignment;
}

} // namespace tp
