//===- StackBound.h - How deep a program's stack may get --------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_LINK_STACKBOUND_H
#define TP_LLVM_BACKEND_CLANG_LINK_STACKBOUND_H

#include "llvm-backend/clang/link/CallGraph.h"

#include <optional>
#include <string>
#include <vector>

namespace tp {

/// What the calls of a program say of its stack.
struct StackBound {
  struct Step {
    std::string Function;
    /// Bytes of the function's frame, or 0 if it gives the frame back before
    /// the next step.
    uint32_t FrameBytes;
  };

  /// The most bytes that the stack of a thread may take, a multiple of
  /// memorymap::StackAlignment; nothing if there is no bound.
  std::optional<uint32_t> Bytes;
  /// From the entry, the calls that take the most.
  std::vector<Step> DeepestChain;
  /// Why there is no bound, in lines of two spaces and text, without the last
  /// end of line.
  std::string Reason;
};

/// Bounds the stack of a thread that starts at the entry of \p Graph.
StackBound boundStack(const CallGraph &Graph);

/// The calls of \p Bound in the form `a -> b -> c`.
std::string describeChain(const StackBound &Bound);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_LINK_STACKBOUND_H
