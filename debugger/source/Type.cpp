//===- Type.cpp - Types of a program's source ----------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/source/Type.h"

#include "llvm/ADT/STLExtras.h"

namespace tp {

const Type &Type::stripped() const {
  const Type *At = this;
  while ((At->Kind == TypeKind::Typedef || At->Kind == TypeKind::Const ||
          At->Kind == TypeKind::Volatile ||
          At->Kind == TypeKind::OtherQualifier) &&
         At->Target)
    At = At->Target;
  return *At;
}

bool Type::isInteger() const {
  switch (stripped().Kind) {
  case TypeKind::Boolean:
  case TypeKind::Character:
  case TypeKind::Signed:
  case TypeKind::Unsigned:
  case TypeKind::Enumeration:
    return true;
  default:
    return false;
  }
}

bool Type::isArithmetic() const {
  return isInteger() || stripped().Kind == TypeKind::Float;
}

bool Type::isSigned() const {
  const Type &Plain = stripped();
  if (Plain.Kind == TypeKind::Enumeration && Plain.Target)
    return Plain.Target->isSigned();
  if (Plain.Kind == TypeKind::Character)
    return Plain.IsSignedCharacter;
  return Plain.Kind == TypeKind::Signed;
}

bool Type::isPointer() const {
  TypeKind Plain = stripped().Kind;
  return Plain == TypeKind::Pointer || Plain == TypeKind::NullPointer;
}

bool Type::isReference() const {
  TypeKind Plain = stripped().Kind;
  return Plain == TypeKind::LvalueReference ||
         Plain == TypeKind::RvalueReference;
}

bool Type::isRecord() const {
  TypeKind Plain = stripped().Kind;
  return Plain == TypeKind::Structure || Plain == TypeKind::Class ||
         Plain == TypeKind::Union;
}

bool Type::isCharacter() const {
  return stripped().Kind == TypeKind::Character;
}

bool Type::hasMember(llvm::StringRef Name) const {
  return llvm::any_of(stripped().Members, [&](const Member &Part) {
    return (!Part.IsBase && Part.Name == Name) ||
           ((Part.IsBase || Part.Name.empty()) && Part.Of->hasMember(Name));
  });
}

bool isSameType(const Type &A, const Type &B) {
  const Type &Left = A.stripped();
  const Type &Right = B.stripped();
  if (&Left == &Right)
    return true;
  if (Left.Kind != Right.Kind || Left.Size != Right.Size)
    return false;
  switch (Left.Kind) {
  case TypeKind::Pointer:
  case TypeKind::LvalueReference:
  case TypeKind::RvalueReference:
  case TypeKind::Array:
    return Left.Target && Right.Target &&
           isSameType(*Left.Target, *Right.Target);
  default:
    return Left.Name == Right.Name;
  }
}

} // namespace tp
