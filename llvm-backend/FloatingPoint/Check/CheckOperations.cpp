//===- CheckOperations.cpp - What reports call an instruction -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/Check/CheckOperations.h"
#include "llvm-backend/TPBuiltins.h"
#include "llvm/IR/IntrinsicInst.h"

using namespace llvm;
using tp::CheckOperation;

static TPBuiltin::ID builtinOf(const CallBase &Call) {
  const Function *Callee = Call.getCalledFunction();
  return Callee ? TPBuiltin::getID(*Callee) : TPBuiltin::ID::None;
}

static CheckOperation describeCall(const CallBase &Call) {
  switch (Call.getIntrinsicID()) {
  case Intrinsic::fma:
  case Intrinsic::fmuladd:
    return CheckOperation::MultiplyAdd;
  case Intrinsic::sqrt:
    return CheckOperation::SquareRoot;
  case Intrinsic::fabs:
    return CheckOperation::Absolute;
  case Intrinsic::minnum:
  case Intrinsic::minimum:
  case Intrinsic::minimumnum:
    return CheckOperation::Minimum;
  case Intrinsic::maxnum:
  case Intrinsic::maximum:
  case Intrinsic::maximumnum:
    return CheckOperation::Maximum;
  default:
    break;
  }
  switch (builtinOf(Call)) {
  case TPBuiltin::ID::rcp:
    return CheckOperation::Reciprocal;
  case TPBuiltin::ID::rsqrt:
    return CheckOperation::ReciprocalSquareRoot;
  default:
    break;
  }
  // Functions of one or two numbers that the report can show.
  auto HasResultType = [&](const Value *Argument) {
    return Argument->getType() == Call.getType();
  };
  if (Call.arg_size() == 1 && all_of(Call.args(), HasResultType))
    return CheckOperation::UnaryFunction;
  if (Call.arg_size() == 2 && all_of(Call.args(), HasResultType))
    return CheckOperation::BinaryFunction;
  return CheckOperation::CallResult;
}

static CheckOperation describeOpcode(const Instruction &I) {
  switch (I.getOpcode()) {
  case Instruction::FAdd:
    return CheckOperation::Add;
  case Instruction::FSub:
    return CheckOperation::Subtract;
  case Instruction::FMul:
    return CheckOperation::Multiply;
  case Instruction::FDiv:
    return CheckOperation::Divide;
  case Instruction::FRem:
    return CheckOperation::Remainder;
  case Instruction::FNeg:
    return CheckOperation::Negate;
  case Instruction::FCmp:
    return describeComparison(cast<FCmpInst>(I).getPredicate());
  case Instruction::Call:
  case Instruction::Invoke:
    return describeCall(cast<CallBase>(I));
  case Instruction::Select:
  case Instruction::PHI:
    return CheckOperation::SelectedValue;
  default:
    return CheckOperation::ConvertedValue;
  }
}

std::pair<CheckOperation, CheckedValues>
llvm::describeOperation(Instruction &I) {
  CheckOperation Operation = describeOpcode(I);
  CheckedValues Values;
  switch (Operation) {
  case CheckOperation::CallResult:
  case CheckOperation::ConvertedValue:
    break;
  case CheckOperation::SelectedValue:
    Values.First = &I;
    break;
  default:
    Values.First = I.getOperand(0);
    if (I.getNumOperands() > 1 &&
        I.getOperand(1)->getType() == Values.First->getType())
      Values.Second = I.getOperand(1);
  }
  return {Operation, Values};
}

CheckOperation llvm::describeComparison(CmpInst::Predicate Predicate) {
  switch (Predicate) {
  case CmpInst::FCMP_OEQ:
  case CmpInst::FCMP_UEQ:
    return CheckOperation::Equal;
  case CmpInst::FCMP_ONE:
  case CmpInst::FCMP_UNE:
    return CheckOperation::NotEqual;
  case CmpInst::FCMP_OLT:
  case CmpInst::FCMP_ULT:
    return CheckOperation::Less;
  case CmpInst::FCMP_OLE:
  case CmpInst::FCMP_ULE:
    return CheckOperation::LessEqual;
  case CmpInst::FCMP_OGT:
  case CmpInst::FCMP_UGT:
    return CheckOperation::Greater;
  case CmpInst::FCMP_OGE:
  case CmpInst::FCMP_UGE:
    return CheckOperation::GreaterEqual;
  default:
    return CheckOperation::Ordered;
  }
}

static IntegerConversion conversionTo(
    const Instruction &I, bool IsSigned,
    IntegerConversion::RoundingKind Rounding = IntegerConversion::TowardZero) {
  return {I.getType()->getScalarSizeInBits(), IsSigned, Rounding};
}

std::optional<IntegerConversion> llvm::integerConversion(const Instruction &I) {
  if (isa<FPToSIInst, FPToUIInst>(I))
    return conversionTo(I, isa<FPToSIInst>(I));
  auto *Call = dyn_cast<CallBase>(&I);
  if (!Call)
    return std::nullopt;
  switch (Call->getIntrinsicID()) {
  case Intrinsic::fptosi_sat:
  case Intrinsic::experimental_constrained_fptosi:
    return conversionTo(I, /*IsSigned=*/true);
  case Intrinsic::fptoui_sat:
  case Intrinsic::experimental_constrained_fptoui:
    return conversionTo(I, /*IsSigned=*/false);
  case Intrinsic::lrint:
  case Intrinsic::llrint:
    return conversionTo(I, /*IsSigned=*/true, IntegerConversion::ToNearestEven);
  case Intrinsic::lround:
  case Intrinsic::llround:
    return conversionTo(I, /*IsSigned=*/true, IntegerConversion::ToNearestAway);
  default:
    break;
  }
  switch (builtinOf(*Call)) {
  // Floats near the limits are integers: how the builtin rounds does not
  // matter.
  case TPBuiltin::ID::trunc_w:
  case TPBuiltin::ID::round_w:
  case TPBuiltin::ID::floor_w:
  case TPBuiltin::ID::ceil_w:
    return conversionTo(I, /*IsSigned=*/true);
  default:
    return std::nullopt;
  }
}

CheckOperation llvm::describeConversion(IntegerConversion Conversion) {
  switch (Conversion.Bits) {
  case 8:
    return Conversion.IsSigned ? CheckOperation::ToInt8
                               : CheckOperation::ToUnsigned8;
  case 16:
    return Conversion.IsSigned ? CheckOperation::ToInt16
                               : CheckOperation::ToUnsigned16;
  case 32:
    return Conversion.IsSigned ? CheckOperation::ToInt32
                               : CheckOperation::ToUnsigned32;
  case 64:
    return Conversion.IsSigned ? CheckOperation::ToInt64
                               : CheckOperation::ToUnsigned64;
  default:
    return Conversion.IsSigned ? CheckOperation::ToOtherSigned
                               : CheckOperation::ToOtherUnsigned;
  }
}

std::optional<CmpInst::Predicate> llvm::floatPredicate(const Instruction &I) {
  if (auto *Comparison = dyn_cast<FCmpInst>(&I))
    return Comparison->getPredicate();
  if (auto *Comparison = dyn_cast<ConstrainedFPCmpIntrinsic>(&I))
    return Comparison->getPredicate();
  return std::nullopt;
}
