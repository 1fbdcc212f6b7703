//===- TypeTable.h - Finds and makes types ----------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_SOURCE_TYPETABLE_H
#define TP_DEBUGGER_SOURCE_TYPETABLE_H

#include "debugger/source/Type.h"

#include "llvm/ADT/DenseMap.h"
#include "llvm/ADT/StringMap.h"
#include "llvm/ADT/StringRef.h"

#include <map>
#include <memory>

namespace tp {

class NameIndex;

/// The types of a program, read when they are first asked for, and those that
/// expressions make of them.
class TypeTable {
public:
  explicit TypeTable(const NameIndex &Names);
  ~TypeTable();

  /// The type that \p Die describes; void for an invalid one.
  const Type &fromDie(llvm::DWARFDie Die);
  /// The type that DW_AT_type of \p Die names.
  const Type &typeOf(llvm::DWARFDie Die);

  /// Types that every program has, by their name in C++: `unsigned int`.
  const Type &basic(llvm::StringRef Name);
  const Type &pointerTo(const Type &Target);
  const Type &referenceTo(const Type &Target);
  const Type &arrayOf(const Type &Element, uint32_t Count);
  const Type &qualified(TypeKind Qualifier, const Type &Target);
  /// The type of a function; \p Parameters in brackets: `(int, float)`.
  const Type &function(const Type &Result, llvm::StringRef Parameters);
  /// `int`, `unsigned int`, `long long` and so on of a number of bytes.
  const Type &integer(unsigned Bytes, bool Signed);

  /// A structure, enumeration or typedef by its name, as it is seen from
  /// \p Scope (a DIE in whose namespaces and classes to look first), or by the
  /// last parts of it; nullptr if there is none.
  const Type *find(llvm::StringRef Name, llvm::DWARFDie Scope = {});

private:
  const NameIndex &Names;
  llvm::DenseMap<uint64_t, std::unique_ptr<Type>> ByDie;
  llvm::StringMap<std::unique_ptr<Type>> Basic;
  std::map<std::pair<const Type *, uint64_t>, std::unique_ptr<Type>> Derived;

  void read(Type &Result, llvm::DWARFDie Die);
  void readMembers(Type &Result, llvm::DWARFDie Die);
  void readEnumerators(Type &Result, llvm::DWARFDie Die);
  void readArray(Type &Result, llvm::DWARFDie Die);
  Type &derived(const Type &Base, uint64_t Key, bool &IsNew);
};

} // namespace tp

#endif // TP_DEBUGGER_SOURCE_TYPETABLE_H
