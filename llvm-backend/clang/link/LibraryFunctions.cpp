//===- LibraryFunctions.cpp - Functions that the compiler calls -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/link/LibraryFunctions.h"
#include "llvm-backend/TPDataLayout.h"
#include "llvm/Analysis/TargetLibraryInfo.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/IntrinsicInst.h"
#include "llvm/IR/RuntimeLibcalls.h"

using namespace llvm;

namespace tp {

namespace {

/// Groups of library functions: a call of one may become a call of another.
enum class Group : unsigned { None, Always, FloatMath, DoubleMath, Other };

/// What a program has, found by following references from its roots.
class Reachability {
public:
  void mark(const GlobalValue *Global);
  void follow();
  bool uses(Group Kind) const { return Groups & 1u << unsigned(Kind); }

private:
  void visit(const Instruction &Instruction, bool MayChangeCalls);
  void visitOperands(const User &User, bool MayChangeCalls);
  void noteCall(const Function &Callee, bool MayChangeCalls);
  void noteUse(Group Kind) { Groups |= 1u << unsigned(Kind); }

  SmallPtrSet<const Value *, 32> Marked;
  SmallVector<const GlobalValue *, 64> Pending;
  unsigned Groups = 0;
};

} // namespace

static StringSet<> codeGeneratorCalls() {
  StringSet<> Names;
  for (RTLIB::LibcallImpl Implementation : RTLIB::libcall_impls())
    Names.insert(
        RTLIB::RuntimeLibcallsInfo::getLibcallImplName(Implementation));
  return Names;
}

static Group mathGroup(const FunctionType &Type) {
  auto Mentions = [&](bool (llvm::Type::*IsKind)() const) {
    return (Type.getReturnType()->getScalarType()->*IsKind)() ||
           any_of(Type.params(), [&](const llvm::Type *Parameter) {
             return (Parameter->getScalarType()->*IsKind)();
           });
  };
  if (Mentions(&llvm::Type::isDoubleTy))
    return Group::DoubleMath;
  return Mentions(&llvm::Type::isFloatTy) ? Group::FloatMath : Group::None;
}

// Functions on memory and strings: loops and other string functions turn into
// them.
static bool isStringFunction(StringRef Name) {
  return Name.starts_with("mem") || Name == "bcmp" ||
         (Name.starts_with("str") && !Name.starts_with("strto") &&
          !Name.ends_with("dup"));
}

static Group groupOf(const Function &Candidate) {
  static const StringSet<> CodeGeneratorCalls = codeGeneratorCalls();
  static const TargetLibraryInfoImpl Library{Triple(llvm::TPTriple)};
  StringRef Name = Candidate.getName();
  LibFunc Known;
  bool IsLibraryFunction = Library.getLibFunc(Name, Known);
  if (!IsLibraryFunction)
    return CodeGeneratorCalls.contains(Name) ? Group::Always : Group::None;
  if (isStringFunction(Name))
    return Group::Always;
  Group Math = mathGroup(*Candidate.getFunctionType());
  return Math == Group::None ? Group::Other : Math;
}

void Reachability::mark(const GlobalValue *Global) {
  if (Marked.insert(Global).second)
    Pending.push_back(Global);
}

void Reachability::visitOperands(const User &User, bool MayChangeCalls) {
  for (const Use &Operand : User.operands()) {
    if (const auto *Global = dyn_cast<GlobalValue>(Operand)) {
      mark(Global);
      if (const auto *Callee = dyn_cast<Function>(Global))
        noteCall(*Callee, MayChangeCalls);
    } else if (isa<Constant>(Operand) && Marked.insert(Operand).second) {
      visitOperands(*cast<Constant>(Operand), MayChangeCalls);
    }
  }
}

// Intrinsics that need no library for any type.
static bool isAlwaysInline(Intrinsic::ID Intrinsic) {
  switch (Intrinsic) {
  case Intrinsic::fabs:
  case Intrinsic::copysign:
  case Intrinsic::fptosi_sat:
  case Intrinsic::fptoui_sat:
  case Intrinsic::is_fpclass:
    return true;
  default:
    return false;
  }
}

void Reachability::noteCall(const Function &Callee, bool MayChangeCalls) {
  if (!Callee.isIntrinsic()) {
    if (MayChangeCalls)
      noteUse(groupOf(Callee));
  } else if (!isAlwaysInline(Callee.getIntrinsicID())) {
    noteUse(mathGroup(*Callee.getFunctionType()));
  }
}

void Reachability::visit(const Instruction &Instruction, bool MayChangeCalls) {
  // The remainder is a call of fmod or fmodf.
  if (Instruction.getOpcode() == Instruction::FRem)
    noteUse(Instruction.getType()->getScalarType()->isDoubleTy()
                ? Group::DoubleMath
                : Group::FloatMath);
  visitOperands(Instruction, MayChangeCalls);
}

void Reachability::follow() {
  while (!Pending.empty()) {
    const GlobalValue *Global = Pending.pop_back_val();
    visitOperands(*Global, /*MayChangeCalls=*/false);
    const auto *Body = dyn_cast<Function>(Global);
    if (!Body)
      continue;
    // With -fno-builtin, as in the runtime itself, a call stays what it is.
    bool MayChangeCalls = !Body->hasFnAttribute("no-builtins");
    for (const Instruction &Instruction : instructions(Body))
      visit(Instruction, MayChangeCalls);
  }
}

StringSet<> libraryFunctionsToKeep(const Module &Program,
                                   const StringSet<> &Roots) {
  Reachability Reached;
  for (const GlobalValue &Global : Program.global_values())
    if (Roots.contains(Global.getName()) || Global.hasAppendingLinkage())
      Reached.mark(&Global);

  StringSet<> Kept;
  for (bool Changed = true; Changed;) {
    Reached.follow();
    Changed = false;
    for (const Function &Candidate : Program) {
      Group Kind = groupOf(Candidate);
      if (Candidate.isDeclaration() || Kind == Group::None ||
          (Kind != Group::Always && !Reached.uses(Kind)) ||
          !Kept.insert(Candidate.getName()).second)
        continue;
      Changed = true;
      Reached.mark(&Candidate);
    }
  }
  return Kept;
}

} // namespace tp
