//===- TPTargetInfo.h - The TP in LLVM's target registry --------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_TARGETINFO_TPTARGETINFO_H
#define TP_LLVM_BACKEND_TARGETINFO_TPTARGETINFO_H

namespace llvm {

class Target;

/// The one registry entry of the TP.
Target &getTheTPTarget();

} // namespace llvm

/// Register the TP's parts with LLVM's target registry. Each may be called more
/// than once.
extern "C" {
void LLVMInitializeTPTargetInfo();
void LLVMInitializeTPTargetMC();
void LLVMInitializeTPAsmParser();
void LLVMInitializeTPDisassembler();
}

#endif // TP_LLVM_BACKEND_TARGETINFO_TPTARGETINFO_H
