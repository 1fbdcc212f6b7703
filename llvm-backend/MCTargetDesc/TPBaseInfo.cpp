//===- TPBaseInfo.cpp - Table of the special registers --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/MCTargetDesc/TPBaseInfo.h"
#include "llvm/ADT/ArrayRef.h"
#include <algorithm>
#include <string>

namespace llvm::TPSpecialRegister {
#define GET_SpecialRegisters_IMPL
#include "TPGenSearchableTables.inc"
} // namespace llvm::TPSpecialRegister
