//===- Jit.h - The cycle engine's code generator ----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_JIT_JIT_H
#define TP_SIMULATOR_JIT_JIT_H

#include "simulator/core/CodeGenerator.h"

#include "llvm/Support/Error.h"

#include <memory>

namespace tp {

/// When code is compiled.
struct JitOptions {
  /// The engine's windows between two looks at what is hot.
  unsigned WindowsBetweenLooks = 16;
  /// An instruction must have been executed so often by the interpreter since
  /// the last look.
  uint64_t HotCount = 2000;
  /// Compile all that the entry point can reach before the first window, and
  /// wait for the compiler: for tests.
  bool EverythingAtOnce = false;
};

/// A generator that compiles with LLVM in a host thread of its own.
llvm::Expected<std::unique_ptr<CodeGenerator>>
makeJit(const JitOptions &Options = {});

} // namespace tp

#endif // TP_SIMULATOR_JIT_JIT_H
