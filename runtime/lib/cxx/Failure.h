//===- Failure.h - The end of a program that cannot go on -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_RUNTIME_LIB_CXX_FAILURE_H
#define TP_RUNTIME_LIB_CXX_FAILURE_H

namespace tp {

/// Writes \p Message as an error and ends the program like abort().
[[noreturn]] void fail(const char *Message);

} // namespace tp

#endif // TP_RUNTIME_LIB_CXX_FAILURE_H
