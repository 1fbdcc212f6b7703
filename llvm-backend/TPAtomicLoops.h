//===- TPAtomicLoops.h - What atomic operations are meant for ---*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_TPATOMICLOOPS_H
#define TP_LLVM_BACKEND_TPATOMICLOOPS_H

namespace llvm {

class Instruction;

/// Whether \p I accesses a word atomically for the sake of some of its bytes.
bool isPartOfWord(const Instruction &I);

} // namespace llvm

#endif // TP_LLVM_BACKEND_TPATOMICLOOPS_H
