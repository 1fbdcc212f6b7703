//===- Type.h - Types of a program's source ---------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_SOURCE_TYPE_H
#define TP_DEBUGGER_SOURCE_TYPE_H

#include "llvm/ADT/StringRef.h"
#include "llvm/DebugInfo/DWARF/DWARFDie.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tp {

enum class TypeKind : uint8_t {
  Void,
  Boolean,
  Character,
  Signed,
  Unsigned,
  Float,
  Enumeration,
  Pointer,
  LvalueReference,
  RvalueReference,
  MemberPointer,
  NullPointer,
  Array,
  Vector,
  Structure,
  Class,
  Union,
  Function,
  Typedef,
  Const,
  Volatile,
  OtherQualifier,
  /// Declared only: the program does not say what is in it.
  Incomplete,
};

class Type;

/// A data member or a base class.
struct Member {
  /// Empty for anonymous structures and unions; a base class's name.
  std::string Name;
  const Type *Of = nullptr;
  /// From the beginning of the structure.
  uint32_t Offset = 0;
  /// Of a bit-field: its bits from the lowest of Offset on; else 0.
  uint32_t BitSize = 0;
  uint32_t BitOffset = 0;
  bool IsBase = false;
  bool IsVirtualBase = false;
  /// Of a virtual base: how far in front of what the vtable's pointer points to
  /// its offset stands; 0 if the program does not say.
  uint32_t VirtualBaseSlot = 0;
  /// The vtable's pointer.
  bool IsArtificial = false;
};

/// A static member, found by its name.
struct StaticMember {
  std::string Name;
  llvm::DWARFDie Die;
};

struct Enumerator {
  std::string Name;
  int64_t Value = 0;
};

/// A type. All uses of one description have the same address; they live as
/// long as the TypeTable.
class Type {
public:
  TypeKind Kind = TypeKind::Void;
  /// As a declaration would write it: `const tp::Vec3 *`.
  std::string Name;
  /// In bytes; 0 if it has none.
  uint32_t Size = 0;
  /// What a pointer, reference, array, typedef or qualifier is of; an
  /// enumeration's integer; a function's result.
  const Type *Target = nullptr;
  /// The class that a member pointer points into.
  const Type *Container = nullptr;
  /// Elements of an array; none if the program does not say how many.
  std::optional<uint32_t> Count;
  std::vector<Member> Members;
  std::vector<StaticMember> StaticMembers;
  std::vector<Enumerator> Enumerators;
  /// `enum class`.
  bool IsScoped = false;
  /// A character type is signed.
  bool IsSignedCharacter = false;
  llvm::DWARFDie Die;

  /// Without typedefs and qualifiers.
  const Type &stripped() const;
  bool isInteger() const;
  bool isArithmetic() const;
  bool isSigned() const;
  bool isPointer() const;
  bool isReference() const;
  bool isRecord() const;
  bool isCharacter() const;
  /// Of a structure: whether it, one of its bases or an anonymous structure in
  /// it has a member of that name that is not static.
  bool hasMember(llvm::StringRef Name) const;
};

/// Whether both describe the same type, perhaps in two units.
bool isSameType(const Type &A, const Type &B);

} // namespace tp

#endif // TP_DEBUGGER_SOURCE_TYPE_H
