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

/// Why a library function may be called though no call is there yet.
enum class Group : unsigned {
  None,
  /// Any code may need it.
  Always,
  // A call of one function of the group may become a call of another.
  FloatMath,
  DoubleMath,
  String,
  Other,
  // The code generator makes calls of operations that the TP lacks.
  Half,
  Double,
  Integer64,
  Integer128,
  Atomic,
};

/// What a program has, found by following references from its roots into the
/// program and what it takes of the runtime.
class Reachability {
public:
  Reachability(Module &Program, Module *Runtime)
      : Program(Program), Runtime(Runtime) {}

  void mark(const GlobalValue *Global);
  void follow();
  bool uses(Group Kind) const {
    return Kind == Group::Always || Groups & 1u << unsigned(Kind) ||
           // Formatted output turns into copies.
           (Kind == Group::String && uses(Group::Other));
  }

private:
  void visit(const Instruction &Instruction, bool MayChangeCalls);
  void visitOperands(const User &User, bool MayChangeCalls);
  void noteCall(const Function &Callee, bool MayChangeCalls);
  void noteType(Type *Used);
  void noteUse(Group Kind) { Groups |= 1u << unsigned(Kind); }

  Module &Program;
  Module *Runtime;
  SmallPtrSet<const Value *, 32> Marked;
  SmallVector<const GlobalValue *, 64> Pending;
  SmallPtrSet<Type *, 32> Types;
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

// Loops and copies of objects turn into them.
static bool isBlockFunction(StringRef Name) {
  return Name == "memcpy" || Name == "memmove" || Name == "memset" ||
         Name == "memcmp" || Name == "bcmp" || Name == "strlen";
}

static bool isStringFunction(StringRef Name) {
  return Name.starts_with("mem") ||
         (Name.starts_with("str") && !Name.starts_with("strto") &&
          !Name.ends_with("dup"));
}

// What has to be in a program for the code generator to call \p Candidate. The
// names follow GCC's: hf, sf, df, di and ti are types.
static Group codeGeneratorGroup(const Function &Candidate) {
  StringRef Name = Candidate.getName();
  if (!Name.consume_front("__"))
    return mathGroup(*Candidate.getFunctionType());
  if (Name.starts_with("atomic_") || Name.starts_with("sync_"))
    return Group::Atomic;
  if (Name.contains("hf") || Name.contains("bf"))
    return Group::Half;
  if (Name.contains("ti"))
    // Products of 64-bit numbers take more bits.
    return Name.starts_with("mul") ? Group::Integer64 : Group::Integer128;
  if (Name.contains("df"))
    return Group::Double;
  if (Name.contains("di"))
    return Group::Integer64;
  return Name.contains("sf") ? Group::FloatMath : Group::Always;
}

static Group groupOf(const Function &Candidate) {
  static const StringSet<> CodeGeneratorCalls = codeGeneratorCalls();
  static const TargetLibraryInfoImpl Library{Triple(llvm::TPTriple)};
  StringRef Name = Candidate.getName();
  LibFunc Known;
  if (!Library.getLibFunc(Name, Known))
    return CodeGeneratorCalls.contains(Name) ? codeGeneratorGroup(Candidate)
                                             : Group::None;
  if (isBlockFunction(Name))
    return Group::Always;
  if (isStringFunction(Name))
    return Group::String;
  if (Name.starts_with("strto"))
    return Group::Other;
  Group Math = mathGroup(*Candidate.getFunctionType());
  return Math == Group::None ? Group::Other : Math;
}

// The program's definition wins over the runtime's.
void Reachability::mark(const GlobalValue *Global) {
  if (Runtime && !Global->hasLocalLinkage() && !Global->hasAppendingLinkage()) {
    const GlobalValue *Other = Program.getNamedValue(Global->getName());
    if (!Other || Other->isDeclaration())
      Other = Runtime->getNamedValue(Global->getName());
    if (Other && !Other->isDeclaration())
      Global = Other;
  }
  if (Marked.insert(Global).second)
    Pending.push_back(Global);
}

void Reachability::noteType(Type *Used) {
  if (!Types.insert(Used).second)
    return;
  if (Used->isHalfTy() || Used->isBFloatTy())
    noteUse(Group::Half);
  else if (Used->isDoubleTy())
    noteUse(Group::Double);
  else if (Used->isIntegerTy() && Used->getIntegerBitWidth() > 32)
    noteUse(Group::Integer64);
  if (Used->isIntegerTy() && Used->getIntegerBitWidth() > 64)
    noteUse(Group::Integer128);
  for_each(Used->subtypes(), [&](Type *Part) { noteType(Part); });
}

void Reachability::visitOperands(const User &User, bool MayChangeCalls) {
  noteType(User.getType());
  for (const Use &Operand : User.operands()) {
    noteType(Operand->getType());
    if (const auto *Global = dyn_cast<GlobalValue>(Operand)) {
      mark(Global);
      if (const auto *Callee = dyn_cast<Function>(Global))
        noteCall(*Callee, MayChangeCalls);
    } else if (isa<Constant>(Operand) && Marked.insert(Operand).second) {
      visitOperands(*cast<Constant>(Operand), MayChangeCalls);
    }
  }
}

static bool isAlwaysInline(const Function &Intrinsic) {
  switch (Intrinsic.getIntrinsicID()) {
  case Intrinsic::fabs:
  case Intrinsic::copysign:
  case Intrinsic::fptosi_sat:
  case Intrinsic::fptoui_sat:
  case Intrinsic::is_fpclass:
    return true;
  // The TP has instructions for floats.
  case Intrinsic::ceil:
  case Intrinsic::floor:
  case Intrinsic::maximumnum:
  case Intrinsic::maxnum:
  case Intrinsic::minimumnum:
  case Intrinsic::minnum:
  case Intrinsic::nearbyint:
  case Intrinsic::rint:
  case Intrinsic::roundeven:
  case Intrinsic::sqrt:
  case Intrinsic::trunc:
    return mathGroup(*Intrinsic.getFunctionType()) == Group::FloatMath;
  default:
    return false;
  }
}

void Reachability::noteCall(const Function &Callee, bool MayChangeCalls) {
  if (!Callee.isIntrinsic()) {
    if (MayChangeCalls)
      noteUse(groupOf(Callee));
  } else if (!isAlwaysInline(Callee)) {
    noteUse(mathGroup(*Callee.getFunctionType()));
  }
}

// Words have instructions, and less is done with those of words.
static bool isAtomicByLibrary(const Instruction &Access) {
  auto TakesLock = [&](Type *Accessed, Align Alignment) {
    const uint64_t Bytes = Access.getDataLayout().getTypeStoreSize(Accessed);
    return Bytes > 4 || Alignment.value() < Bytes;
  };
  if (!Access.isAtomic() || isa<FenceInst>(Access))
    return false;
  if (const auto *Exchange = dyn_cast<AtomicCmpXchgInst>(&Access))
    return TakesLock(Exchange->getNewValOperand()->getType(),
                     Exchange->getAlign());
  if (const auto *Change = dyn_cast<AtomicRMWInst>(&Access))
    return TakesLock(Change->getType(), Change->getAlign());
  return TakesLock(getLoadStoreType(&Access), getLoadStoreAlignment(&Access));
}

void Reachability::visit(const Instruction &Instruction, bool MayChangeCalls) {
  // The remainder is a call of fmod or fmodf.
  if (Instruction.getOpcode() == Instruction::FRem)
    noteUse(Instruction.getType()->getScalarType()->isDoubleTy()
                ? Group::DoubleMath
                : Group::FloatMath);
  if (isAtomicByLibrary(Instruction))
    noteUse(Group::Atomic);
  visitOperands(Instruction, MayChangeCalls);
}

void Reachability::follow() {
  while (!Pending.empty()) {
    const GlobalValue *Global = Pending.pop_back_val();
    if (Global->isMaterializable())
      if (Error Failure = const_cast<GlobalValue *>(Global)->materialize())
        report_fatal_error(std::move(Failure));
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

StringSet<> libraryFunctionsToKeep(Module &Program, Module *Runtime,
                                   const StringSet<> &Roots) {
  Reachability Reached(Program, Runtime);
  SmallVector<const Function *> Candidates;
  for (const Module *Part : {&Program, Runtime}) {
    if (!Part)
      continue;
    for (const GlobalValue &Global : Part->global_values())
      if (Roots.contains(Global.getName()) || Global.hasAppendingLinkage())
        Reached.mark(&Global);
    for (const Function &F : *Part)
      if (!F.isDeclaration() && groupOf(F) != Group::None)
        Candidates.push_back(&F);
  }

  StringSet<> Kept;
  for (bool Changed = true; Changed;) {
    Reached.follow();
    Changed = false;
    for (const Function *Candidate : Candidates) {
      if (!Reached.uses(groupOf(*Candidate)) ||
          !Kept.insert(Candidate->getName()).second)
        continue;
      Changed = true;
      Reached.mark(Candidate);
    }
  }
  return Kept;
}

} // namespace tp
