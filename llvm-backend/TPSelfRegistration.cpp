//===- TPSelfRegistration.cpp - The TP in tools that load it --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/TPTargetMachine.h"

namespace {

/// `llc -load libLLVMTP.so` calls no function of what it loads.
struct SelfRegistration {
  SelfRegistration() { LLVMInitializeTPTarget(); }
} Registration;

} // namespace
