//===- CallGraph.h - Which code of a program calls which --------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_LINK_CALLGRAPH_H
#define TP_LLVM_BACKEND_CLANG_LINK_CALLGRAPH_H

#include "llvm-backend/clang/link/ElfInput.h"

#include <deque>

namespace tp {

struct CallGraphNode;

struct Call {
  const CallGraphNode *Callee;
  /// Whether the caller has given back its frame before.
  bool IsTail;
};

/// A function, or the place of all functions that a call through a pointer may
/// reach, which takes nothing itself and "tail calls" them.
struct CallGraphNode {
  enum class Frame {
    Known,
    /// Its size depends on values at run time (alloca).
    Dynamic,
    /// Assembly that moves the stack pointer and has no record.
    Unstated,
  };

  /// Null for the place of a pointer's functions.
  const InputSection *Section = nullptr;
  /// Offsets in the section.
  uint32_t Begin = 0;
  uint32_t End = 0;
  /// As the source says it.
  std::string Name;
  Frame Kind = Frame::Known;
  /// Bytes of the stack, without those of the functions that it calls.
  uint32_t FrameBytes = 0;
  std::vector<Call> Calls;
};

/// The code that is in the program.
struct CallGraph {
  /// Sorted by section and place; then those without section.
  std::deque<CallGraphNode> Nodes;
  const CallGraphNode *Entry = nullptr;
};

/// Finds the functions of the live sections of \p Objects and their calls: in
/// the instructions themselves, so that assembly counts, and through pointers
/// to every function of a fitting type whose address something takes.
CallGraph buildCallGraph(llvm::ArrayRef<std::unique_ptr<ElfObject>> Objects,
                         const SymbolTable &Globals, const Symbol &Entry,
                         LinkDiagnostics &Diags);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_LINK_CALLGRAPH_H
