//===- TPBuiltins.cpp - The TP's compiler builtins ------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/TPBuiltins.h"
#include "llvm/ADT/StringSwitch.h"
#include "llvm/IR/Function.h"
#include "llvm/Support/ErrorHandling.h"

using namespace llvm;

TPBuiltin::ID TPBuiltin::getID(const Function &F) {
  StringRef Name = F.getName();
  if (!F.isDeclaration() || !Name.consume_front("tp_"))
    return ID::None;
  return StringSwitch<ID>(Name)
#define TP_BUILTIN(Name, ClangType, ClangAttributes, Effect)                   \
  .Case(#Name, ID::Name)
#include "llvm-backend/TPBuiltins.def"
      .Default(ID::None);
}

TPBuiltin::Effect TPBuiltin::getEffect(ID Builtin) {
  switch (Builtin) {
#define TP_BUILTIN(Name, ClangType, ClangAttributes, EffectName)               \
  case ID::Name:                                                               \
    return Effect::EffectName;
#include "llvm-backend/TPBuiltins.def"
  case ID::None:
    break;
  }
  llvm_unreachable("not a builtin");
}

bool TPBuiltin::isNoReturn(ID Builtin) {
  switch (Builtin) {
#define TP_BUILTIN(Name, ClangType, ClangAttributes, EffectName)               \
  case ID::Name:                                                               \
    return StringRef(ClangAttributes).contains('r');
#include "llvm-backend/TPBuiltins.def"
  case ID::None:
    break;
  }
  llvm_unreachable("not a builtin");
}
