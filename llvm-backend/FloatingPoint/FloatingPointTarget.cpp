//===- FloatingPointTarget.cpp - What a function's target can do ----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/FloatingPointTarget.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/IR/Function.h"
#include "llvm/IR/Module.h"

using namespace llvm;

FloatingPointTarget::FloatingPointTarget(const Function &F)
    : TargetTriple(F.getParent()->getTargetTriple()),
      Features(F.getFnAttribute("target-features").getValueAsString()) {}

bool FloatingPointTarget::isTP() const {
  return TargetTriple.getArchName() == "tp";
}

bool FloatingPointTarget::hasFeature(StringRef Name) const {
  // The last word on a feature holds.
  bool Result = false;
  for (StringRef Feature : split(Features, ','))
    if (Feature.drop_front(!Feature.empty()) == Name)
      Result = Feature.front() == '+';
  return Result;
}

bool FloatingPointTarget::hasFusedMultiplyAdd(const Type &T) const {
  const Type &Scalar = *T.getScalarType();
  if (!Scalar.isFloatTy() && !Scalar.isDoubleTy())
    return false;
  if (isTP())
    return T.isFloatTy() && hasFeature("fma");
  switch (TargetTriple.getArch()) {
  case Triple::x86:
  case Triple::x86_64:
    return hasFeature("fma") || hasFeature("fma4");
  case Triple::arm:
  case Triple::armeb:
  case Triple::thumb:
  case Triple::thumbeb:
    return hasFeature(Scalar.isFloatTy() ? "vfp4sp" : "vfp4");
  case Triple::riscv32:
  case Triple::riscv64:
  case Triple::loongarch32:
  case Triple::loongarch64:
    return hasFeature(Scalar.isFloatTy() ? "f" : "d");
  case Triple::aarch64:
  case Triple::aarch64_be:
  case Triple::amdgcn:
  case Triple::nvptx:
  case Triple::nvptx64:
  case Triple::ppc64:
  case Triple::ppc64le:
  case Triple::systemz:
    return true;
  default:
    return false;
  }
}
