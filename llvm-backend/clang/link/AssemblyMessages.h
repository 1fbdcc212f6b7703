//===- AssemblyMessages.h - Messages about inline assembly ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_LINK_ASSEMBLYMESSAGES_H
#define TP_LLVM_BACKEND_CLANG_LINK_ASSEMBLYMESSAGES_H

#include "llvm-backend/clang/link/LinkDiagnostics.h"
#include "llvm/ADT/STLFunctionalExtras.h"
#include "llvm/IR/DiagnosticInfo.h"
#include "llvm/IR/Module.h"

namespace tp {

/// Notes in \p Unit where the lines of its inline assembly are in the source.
/// \p PlaceOf knows the place that one of clang's numbers in `!srcloc` means.
void setAssemblyPlaces(llvm::Module &Unit,
                       llvm::function_ref<SourcePlace(uint64_t)> PlaceOf);

/// Reports \p Info at its place if it concerns inline assembly of \p Program.
/// \returns whether it does.
bool reportAssemblyMessage(const llvm::DiagnosticInfo &Info,
                           const llvm::Module &Program, LinkDiagnostics &Diags);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_LINK_ASSEMBLYMESSAGES_H
