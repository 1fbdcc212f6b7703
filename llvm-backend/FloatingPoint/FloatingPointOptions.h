//===- FloatingPointOptions.h - Options of the passes --------- -*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_FLOATINGPOINT_FLOATINGPOINTOPTIONS_H
#define TP_LLVM_BACKEND_FLOATINGPOINT_FLOATINGPOINTOPTIONS_H

#include "llvm/ADT/StringRef.h"

namespace llvm {

/// Whether the canonicalizer runs (-tp-fp-canonicalize, on unless it is 0).
bool isFloatingPointCanonicalizationEnabled();

/// The file that says which instructions keep their fast-math flags
/// (-tp-fp-scope=); empty means all do.
StringRef getFloatingPointScopeFile();

/// The file that gets the list of what such a file can name
/// (-tp-fp-scope-list=); empty means none does.
StringRef getFloatingPointScopeListFile();

/// Whether the checked mode is on (-tp-fp-check).
bool isFloatingPointCheckEnabled();

} // namespace llvm

#endif // TP_LLVM_BACKEND_FLOATINGPOINT_FLOATINGPOINTOPTIONS_H
