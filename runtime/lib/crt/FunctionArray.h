//===- FunctionArray.h - Constructors and destructors -----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_RUNTIME_LIB_CRT_FUNCTIONARRAY_H
#define TP_RUNTIME_LIB_CRT_FUNCTIONARRAY_H

#include <stdint.h>

namespace tp {

using SimpleFunction = void (*)();

/// Length of the linker's array from \p Begin to \p End. Computed on numbers,
/// since two arrays of the program may not be compared.
inline uintptr_t functionCount(const SimpleFunction *Begin,
                               const SimpleFunction *End) {
  return (reinterpret_cast<uintptr_t>(End) -
          reinterpret_cast<uintptr_t>(Begin)) /
         sizeof(SimpleFunction);
}

} // namespace tp

#endif // TP_RUNTIME_LIB_CRT_FUNCTIONARRAY_H
