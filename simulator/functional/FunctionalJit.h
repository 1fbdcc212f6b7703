//===- FunctionalJit.h - The functional mode's code generator ---*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_FUNCTIONAL_FUNCTIONALJIT_H
#define TP_SIMULATOR_FUNCTIONAL_FUNCTIONALJIT_H

#include "simulator/functional/FunctionalCode.h"

#include "llvm/Support/Error.h"

#include <memory>

namespace tp {

/// When code is compiled.
struct FunctionalJitOptions {
  /// Turns between two looks at what is hot.
  unsigned TurnsBetweenLooks = 32;
  /// An instruction is hot when it has been executed so often: then the
  /// interpreter has lost about the time that compiling it takes.
  uint64_t HotCount = 300'000;
  /// Wait for the compiler at each look: for tests.
  bool Waits = false;
};

/// A generator that compiles with LLVM in a host thread of its own.
llvm::Expected<std::unique_ptr<FunctionalCodeGenerator>>
makeFunctionalJit(const FunctionalJitOptions &Options = {});

} // namespace tp

#endif // TP_SIMULATOR_FUNCTIONAL_FUNCTIONALJIT_H
