//===- MathFunctions.cpp - Which function a call computes -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/Canonicalize/MathFunctions.h"
#include "llvm-backend/FloatingPoint/Canonicalize/CanonicalizerSteps.h"
#include "llvm-backend/FloatingPoint/Canonicalize/Expressions.h"
#include "llvm/ADT/StringSwitch.h"
#include "llvm/IR/IRBuilder.h"
#include "llvm/IR/IntrinsicInst.h"
#include "llvm/IR/Module.h"

using namespace llvm;

static MathFunction getIntrinsicFunction(Intrinsic::ID ID) {
  switch (ID) {
  case Intrinsic::sqrt:
    return MathFunction::SquareRoot;
  case Intrinsic::pow:
    return MathFunction::Power;
  case Intrinsic::powi:
    return MathFunction::IntegerPower;
  case Intrinsic::minnum:
    return MathFunction::Minimum;
  case Intrinsic::maxnum:
    return MathFunction::Maximum;
  case Intrinsic::exp:
  case Intrinsic::exp2:
  case Intrinsic::exp10:
  case Intrinsic::log:
  case Intrinsic::log2:
  case Intrinsic::log10:
  case Intrinsic::sin:
  case Intrinsic::cos:
  case Intrinsic::tan:
  case Intrinsic::asin:
  case Intrinsic::acos:
  case Intrinsic::atan:
  case Intrinsic::atan2:
  case Intrinsic::sinh:
  case Intrinsic::cosh:
  case Intrinsic::tanh:
    return MathFunction::Approximate;
  default:
    return MathFunction::None;
  }
}

// By the name for double.
static MathFunction getLibraryFunction(StringRef Name) {
  return StringSwitch<MathFunction>(Name)
      .Case("sqrt", MathFunction::SquareRoot)
      .Case("pow", MathFunction::Power)
      .Case("fmin", MathFunction::Minimum)
      .Case("fmax", MathFunction::Maximum)
      .Cases({"exp", "exp2", "exp10", "expm1"}, MathFunction::Approximate)
      .Cases({"log", "log2", "log10", "log1p"}, MathFunction::Approximate)
      .Cases({"sin", "cos", "tan", "sincos"}, MathFunction::Approximate)
      .Cases({"asin", "acos", "atan", "atan2"}, MathFunction::Approximate)
      .Cases({"sinh", "cosh", "tanh"}, MathFunction::Approximate)
      .Cases({"asinh", "acosh", "atanh"}, MathFunction::Approximate)
      .Cases({"sinpi", "cospi", "tanpi"}, MathFunction::Approximate)
      .Cases({"cbrt", "hypot", "erf", "erfc"}, MathFunction::Approximate)
      .Cases({"tgamma", "lgamma"}, MathFunction::Approximate)
      .Default(MathFunction::None);
}

// Whether \p Call has the type of the library's function on \p Scalar.
static bool hasMathType(const CallBase &Call, const Type &Scalar) {
  if (Call.getType() != &Scalar && !Call.getType()->isVoidTy())
    return false;
  return Call.arg_size() > 0 && Call.getArgOperand(0)->getType() == &Scalar;
}

MathFunction llvm::getMathFunction(const CallBase &Call) {
  const Function *Callee = Call.getCalledFunction();
  if (!Callee)
    return MathFunction::None;
  if (Intrinsic::ID ID = Callee->getIntrinsicID())
    return isRewrittenType(*Call.getType()) ? getIntrinsicFunction(ID)
                                            : MathFunction::None;
  if (Callee->hasLocalLinkage())
    return MathFunction::None;
  StringRef Name = Callee->getName();
  LLVMContext &Context = Callee->getContext();
  if (hasMathType(Call, *Type::getDoubleTy(Context)))
    return getLibraryFunction(Name);
  if (hasMathType(Call, *Type::getFloatTy(Context)) && Name.consume_back("f"))
    return getLibraryFunction(Name);
  return MathFunction::None;
}

CallBase *llvm::matchMathCall(Value &V, MathFunction Function) {
  auto *Call = dyn_cast<CallBase>(&V);
  return Call && getMathFunction(*Call) == Function ? Call : nullptr;
}

//===----------------------------------------------------------------------===//
// One way to compute them
//===----------------------------------------------------------------------===//

// The library's name of an intrinsic on \p Scalar.
static std::string getLibraryName(const IntrinsicInst &Intrinsic,
                                  const Type &Scalar) {
  if (Intrinsic.getIntrinsicID() == Intrinsic::powi)
    return Scalar.isFloatTy() ? "__powisf2" : "__powidf2";
  // llvm.<name> or llvm.<name>.<type>
  StringRef Name = Intrinsic::getBaseName(Intrinsic.getIntrinsicID());
  Name.consume_front("llvm.");
  return (Name + (Scalar.isFloatTy() ? "f" : "")).str();
}

static Value *createLibraryCall(IRBuilderBase &Builder, FunctionCallee Callee,
                                ArrayRef<Value *> Arguments) {
  CallInst *Call = Builder.CreateCall(Callee, Arguments);
  Call->addFnAttr(Attribute::NoBuiltin);
  Call->setDoesNotAccessMemory();
  Call->setDoesNotThrow();
  Call->addFnAttr(Attribute::WillReturn);
  return Call;
}

static Value *createLibraryCalls(IRBuilderBase &Builder, FunctionCallee Callee,
                                 const CallBase &Call) {
  SmallVector<Value *, 2> Arguments(Call.args());
  auto *Vector = dyn_cast<FixedVectorType>(Call.getType());
  if (!Vector)
    return createLibraryCall(Builder, Callee, Arguments);
  Value *Result = PoisonValue::get(Vector);
  for (unsigned Lane = 0; Lane != Vector->getNumElements(); ++Lane) {
    SmallVector<Value *, 2> Elements;
    for (Value *Argument : Arguments)
      Elements.push_back(Argument->getType()->isVectorTy()
                             ? Builder.CreateExtractElement(Argument, Lane)
                             : Argument);
    Result = Builder.CreateInsertElement(
        Result, createLibraryCall(Builder, Callee, Elements), Lane);
  }
  return Result;
}

// The optimizer evaluates intrinsics with the host's library, the program with
// its own.
static void replaceByLibraryCall(IntrinsicInst &Intrinsic) {
  Type &Scalar = *Intrinsic.getType()->getScalarType();
  SmallVector<Type *, 2> Parameters;
  for (const Value *Argument : Intrinsic.args())
    Parameters.push_back(Argument->getType()->getScalarType());
  auto *CalleeType = FunctionType::get(&Scalar, Parameters, /*isVarArg=*/false);
  FunctionCallee Callee = Intrinsic.getModule()->getOrInsertFunction(
      getLibraryName(Intrinsic, Scalar), CalleeType);
  auto *Library = dyn_cast<Function>(Callee.getCallee());
  if (!Library || Library->hasLocalLinkage() ||
      Library->getFunctionType() != CalleeType)
    return;
  IRBuilder<> Builder(&Intrinsic);
  Builder.setFastMathFlags(Intrinsic.getFastMathFlags());
  replaceExpression(Intrinsic, *createLibraryCalls(Builder, Callee, Intrinsic));
}

// Which of two zeros is the smaller is left open by minnum and fmin, and
// settled by minimumnum.
static void replaceByOrderedMinimum(CallBase &Call, Intrinsic::ID ID) {
  if (!isa<CallInst>(Call))
    return;
  IRBuilder<> Builder(&Call);
  Builder.setFastMathFlags(Call.getFastMathFlags());
  replaceExpression(Call,
                    *Builder.CreateBinaryIntrinsic(ID, Call.getArgOperand(0),
                                                   Call.getArgOperand(1)));
}

static void fixMathFunction(CallBase &Call) {
  switch (getMathFunction(Call)) {
  case MathFunction::None:
  case MathFunction::SquareRoot:
    return;
  case MathFunction::Minimum:
    return replaceByOrderedMinimum(Call, Intrinsic::minimumnum);
  case MathFunction::Maximum:
    return replaceByOrderedMinimum(Call, Intrinsic::maximumnum);
  case MathFunction::Power:
  case MathFunction::IntegerPower:
  case MathFunction::Approximate:
    if (auto *Intrinsic = dyn_cast<IntrinsicInst>(&Call))
      replaceByLibraryCall(*Intrinsic);
    else
      Call.addFnAttr(Attribute::NoBuiltin);
  }
}

void llvm::fixMathFunctions(Function &F) {
  forEachInstruction(F, [](Instruction &I) {
    if (auto *Call = dyn_cast<CallBase>(&I))
      fixMathFunction(*Call);
  });
}
