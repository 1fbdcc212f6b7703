//===- Driver.h - The compiler driver tpcc ----------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_DRIVER_H
#define TP_LLVM_BACKEND_CLANG_DRIVER_H

#include "llvm/ADT/ArrayRef.h"

namespace tp {

/// Does what a tpcc command line says: clang's options with the TP's defaults,
/// all jobs in this process.
/// \param Arguments the command line with the program's name as first element.
/// \param MainAddress the address of any function of the executable, by which
/// it finds its own path.
/// \returns the exit status: 0, or 1 after errors, which have been reported.
int runDriver(llvm::ArrayRef<const char *> Arguments, void *MainAddress);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_DRIVER_H
