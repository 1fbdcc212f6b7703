//===- ScopeList.h - Lists what fast math may change ----------- -*- C++
//-*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_FLOATINGPOINT_SCOPE_SCOPELIST_H
#define TP_LLVM_BACKEND_FLOATINGPOINT_SCOPE_SCOPELIST_H

#include "llvm/ADT/ArrayRef.h"
#include "llvm/ADT/StringRef.h"
#include "llvm/Support/Error.h"

namespace llvm {

class Function;

/// Appends to \p Path a line of JSON for each of \p Functions that has items
/// (see ScopeItems.h):
/// \code
///   {"source": ..., "function": <mangled>, "name": <demangled>,
///    "local": <no other file can call it>, "file": ..., "line": ...,
///    "items": [{"what": <opcode, callee or "promises">, "flags": ...,
///               "file": ..., "line": ..., "column": ...}, ...]}
/// \endcode
/// Places are there if the module has line tables.
Error appendScopeList(ArrayRef<Function *> Functions, StringRef Path);

} // namespace llvm

#endif // TP_LLVM_BACKEND_FLOATINGPOINT_SCOPE_SCOPELIST_H
