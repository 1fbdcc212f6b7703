//===- NameIndex.h - Entries of the debug information by name ---*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_SOURCE_NAMEINDEX_H
#define TP_DEBUGGER_SOURCE_NAMEINDEX_H

#include "llvm/ADT/ArrayRef.h"
#include "llvm/ADT/DenseMap.h"
#include "llvm/ADT/StringMap.h"
#include "llvm/ADT/StringRef.h"
#include "llvm/DebugInfo/DWARF/DWARFDie.h"

#include <optional>
#include <string>
#include <vector>

namespace llvm {
class DWARFContext;
class DWARFUnit;
} // namespace llvm

namespace tp {

/// The functions, variables and types that a program describes outside of its
/// functions' code, by the last part of their names.
class NameIndex {
public:
  /// Reads all units of \p Dwarf, which must outlive the index.
  explicit NameIndex(llvm::DWARFContext &Dwarf);

  /// Functions with code of their own.
  llvm::ArrayRef<llvm::DWARFDie> functions() const { return Functions; }
  /// Definitions of variables that live as long as the program, also those in
  /// functions.
  llvm::ArrayRef<llvm::DWARFDie> variables() const { return Variables; }
  llvm::ArrayRef<llvm::DWARFDie> variables(llvm::StringRef BaseName) const;
  /// Definitions of types first, then declarations. The name is that with
  /// template arguments or without.
  std::vector<llvm::DWARFDie> types(llvm::StringRef BaseName) const;
  /// Enumerators of all enumerations.
  llvm::ArrayRef<llvm::DWARFDie> enumerators(llvm::StringRef Name) const;
  /// The definition of the static member or variable that \p Declaration
  /// declares; invalid if there is none.
  llvm::DWARFDie definitionOf(llvm::DWARFDie Declaration) const;

  /// How well \p Candidate, whose name is the wanted one or ends with it, fits
  /// what stands in the scope \p Place (`scene::visit::`) of \p Unit: more is
  /// better. The innermost scope around the place counts most, then what
  /// `using` brings there, then the unit; the library's own names come last.
  size_t nearness(llvm::DWARFDie Candidate, llvm::StringRef Place,
                  const llvm::DWARFUnit *Unit) const;

private:
  /// A `using` declaration or directive.
  struct Import {
    /// The scope that it is in.
    std::string Scope;
    /// What it names, with `::` behind it if that is a namespace.
    std::string Name;
  };

  using DieList = std::vector<llvm::DWARFDie>;

  DieList Functions;
  DieList Variables;
  llvm::StringMap<DieList> VariablesByName;
  llvm::StringMap<DieList> Types;
  llvm::StringMap<DieList> Enumerators;
  llvm::DenseMap<uint64_t, llvm::DWARFDie> Definitions;

  std::vector<Import> Imports;

  void addImport(llvm::DWARFDie Die);
  void addUnit(llvm::DWARFUnit &Unit);
  void add(llvm::DWARFDie Die);
  void addVariable(llvm::DWARFDie Die);
};

/// The number that an attribute holds, signed if its form says so; nothing if
/// it holds none.
std::optional<int64_t> constantOf(const llvm::DWARFFormValue &Form);

/// The entry that has the name: what \p Die completes or is a copy of.
llvm::DWARFDie originOf(llvm::DWARFDie Die);

/// The name of an entry without what it is in; empty if it has none.
llvm::StringRef baseName(llvm::DWARFDie Die);

/// The namespaces, classes and functions around an entry, each followed by
/// `::`.
std::string scopePrefix(llvm::DWARFDie Die);

/// With namespaces and classes.
std::string qualifiedName(llvm::DWARFDie Die);

/// `name<int>` without `<int>`.
llvm::StringRef withoutTemplateArguments(llvm::StringRef Name);

/// The last of the names that `::` separates, not those in template arguments.
llvm::StringRef lastComponent(llvm::StringRef Qualified);

/// Where the parameter types of `name(int)` begin, or npos.
size_t parameterListOf(llvm::StringRef Name);

/// Whether \p Wanted can mean \p Qualified: it is the same or its last
/// components; anonymous namespaces, and template arguments where \p Wanted has
/// none, may be left out.
bool matchesName(llvm::StringRef Qualified, llvm::StringRef Wanted);

} // namespace tp

#endif // TP_DEBUGGER_SOURCE_NAMEINDEX_H
