//===- TP.h - The TP code generator's passes --------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_TP_H
#define TP_LLVM_BACKEND_TP_H

#include "llvm/Support/CodeGen.h"

namespace llvm {

class FunctionPass;
class ModulePass;
class PassRegistry;
class TPTargetMachine;

/// Creates the pass that turns the selection DAG into TP instructions.
FunctionPass *createTPISelDag(TPTargetMachine &TM, CodeGenOptLevel OptLevel);

/// Creates the pass that tells debuggers of variables behind pointer arguments.
FunctionPass *createTPPointedVariablesPass();

/// Creates the pass that tags atomic operations before they are expanded.
FunctionPass *createTPAtomicTagsPass();

/// Creates the pass that makes the first loads of compare-exchange loops
/// atomic.
FunctionPass *createTPAtomicLoopsPass();

/// Creates the pass that gives the declarations of the TP builtins the
/// attributes that TPBuiltins.def promises.
ModulePass *createTPBuiltinAttributesPass();

/// Creates the pass that tells checkers of the objects of the stack, with
/// -tp-check-objects.
ModulePass *createTPCheckedObjectsPass();

/// Creates the pass that makes values loaded from global memory dear to spill.
FunctionPass *createTPGlobalLoadsPass();

/// Creates the pass that makes constrained arithmetic of half floats ordinary.
FunctionPass *createTPStrictHalfFloatsPass();

/// Adds the assembly printer to LLVM's target registry.
void registerTPAsmPrinter();

void initializeTPPointedVariablesPass(PassRegistry &);
void initializeTPAsmPrinterPass(PassRegistry &);
void initializeTPAtomicLoopsPass(PassRegistry &);
void initializeTPAtomicTagsPass(PassRegistry &);
void initializeTPBuiltinAttributesLegacyPass(PassRegistry &);
void initializeTPCheckedObjectsPass(PassRegistry &);
void initializeTPDAGToDAGISelLegacyPass(PassRegistry &);
void initializeTPGlobalLoadsPass(PassRegistry &);
void initializeTPStrictHalfFloatsPass(PassRegistry &);

} // namespace llvm

#endif // TP_LLVM_BACKEND_TP_H
