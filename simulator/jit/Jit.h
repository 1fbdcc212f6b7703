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
  /// something was last found hot: then the interpreter has lost about the time
  /// that compiling it takes.
  uint64_t HotCount = 100'000;
  /// The most that the compiler may take of a host thread, as a share of the
  /// time since the start: a short run must not pay for code that it will
  /// hardly use.
  double CompilerShare = 0.25;
  /// Compile all that the entry point can reach before the first window, and
  /// wait for the compiler, whatever it takes: for tests.
  bool EverythingAtOnce = false;
};

/// A generator that compiles with LLVM in a host thread of its own.
llvm::Expected<std::unique_ptr<CodeGenerator>>
makeJit(const JitOptions &Options = {});

} // namespace tp

#endif // TP_SIMULATOR_JIT_JIT_H
