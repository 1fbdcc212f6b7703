//===- FloatingPointSettings.cpp - How floating point is compiled ---------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/FloatingPointSettings.h"
#include "llvm-backend/FloatingPoint/FloatingPointOptions.h"
#include "llvm-backend/clang/FrontendJob.h"
#include "clang/Frontend/CompilerInstance.h"

using namespace clang;
using namespace llvm;

namespace tp {

StringRef floatingPointPropertyName(FloatingPointProperty Property) {
  switch (Property) {
  case FloatingPointProperty::Reassociate:
    return "reassociate";
  case FloatingPointProperty::Reciprocal:
    return "reciprocal";
  case FloatingPointProperty::ApproximateFunctions:
    return "approximate functions";
  case FloatingPointProperty::SignedZeros:
    return "signed zeros";
  case FloatingPointProperty::NaN:
    return "NaN";
  case FloatingPointProperty::Infinity:
    return "infinity";
  case FloatingPointProperty::Contraction:
    return "contraction";
  case FloatingPointProperty::MathErrno:
    return "math-errno";
  case FloatingPointProperty::Trapping:
    return "trapping";
  case FloatingPointProperty::Rounding:
    return "rounding";
  case FloatingPointProperty::Subnormals:
    return "subnormals";
  case FloatingPointProperty::IntegerConversion:
    return "float to integer";
  case FloatingPointProperty::Canonicalization:
    return "canonicalization";
  case FloatingPointProperty::FusedMultiplyAdd:
    return "fma instruction";
  case FloatingPointProperty::CheckedMode:
    return "checked mode";
  }
  llvm_unreachable("no such property");
}

static StringRef contractionValue(LangOptions::FPModeKind Mode) {
  switch (Mode) {
  case LangOptions::FPM_Off:
    return "off";
  case LangOptions::FPM_On:
    return "within an expression";
  case LangOptions::FPM_Fast:
    return AcrossExpressionsValue;
  case LangOptions::FPM_FastHonorPragmas:
    return "across expressions, pragmas honoured";
  }
  llvm_unreachable("no such mode");
}

static StringRef subnormalsValue(DenormalMode Mode) {
  if (Mode == DenormalMode::getIEEE())
    return "kept";
  if (Mode == DenormalMode::getPreserveSign())
    return "flushed to zero of their sign";
  if (Mode == DenormalMode::getPositiveZero())
    return "flushed to positive zero";
  if (Mode == DenormalMode::getDynamic())
    return "as the chip treats them";
  return "inputs and results treated differently";
}

FloatingPointSettings floatingPointSettings(const CompilerInstance &Frontend) {
  setBackendOptions(Frontend.getFrontendOpts().LLVMArgs);
  const LangOptions &Language = Frontend.getLangOpts();
  FPOptions Arithmetic(Language);
  auto Allowed = [](bool Is) { return Is ? AllowedValue : "no"; };
  auto OnOff = [](bool Is) { return Is ? "on" : "off"; };

  using Property = FloatingPointProperty;
  FloatingPointSettings Values;
  Values[Property::Reassociate] = Allowed(Arithmetic.getAllowFPReassociate());
  Values[Property::Reciprocal] = Allowed(Arithmetic.getAllowReciprocal());
  Values[Property::ApproximateFunctions] =
      Allowed(Arithmetic.getAllowApproxFunc());
  Values[Property::SignedZeros] =
      Arithmetic.getNoSignedZero() ? "sign ignored" : "honoured";
  Values[Property::NaN] =
      Arithmetic.getNoHonorNaNs() ? AssumedAbsentValue : "honoured";
  Values[Property::Infinity] =
      Arithmetic.getNoHonorInfs() ? AssumedAbsentValue : "honoured";
  Values[Property::Contraction] =
      contractionValue(Arithmetic.getFPContractMode());
  Values[Property::MathErrno] = OnOff(Language.MathErrno);
  Values[Property::Trapping] =
      Arithmetic.getExceptionMode() == LangOptions::FPE_Ignore ? "not observed"
                                                               : "observed";
  Values[Property::Rounding] =
      Arithmetic.getRoundingMath() ? "may change" : "to nearest, ties to even";
  Values[Property::Subnormals] =
      subnormalsValue(Frontend.getCodeGenOpts().FPDenormalMode);
  Values[Property::IntegerConversion] =
      Frontend.getCodeGenOpts().StrictFloatCastOverflow
          ? "undefined out of range"
          : "saturates";
  Values[Property::Canonicalization] =
      OnOff(isFloatingPointCanonicalizationEnabled());
  Values[Property::FusedMultiplyAdd] =
      Frontend.getTarget().hasFeature("fma") ? "yes" : NoInstructionValue;
  Values[Property::CheckedMode] = OnOff(isFloatingPointCheckEnabled());
  return Values;
}

} // namespace tp
