//===- CallContexts.h - The calls that led to any moment --------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The stacks of all threads at all times form a tree of calls. A number names a
// node of it, so that the stack of a moment can be kept in one word.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHECK_CALLCONTEXTS_H
#define TP_SIMULATOR_CHECK_CALLCONTEXTS_H

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace tp {

/// The calls under way; 0: none, or nobody knows.
using CallContext = uint32_t;

/// A place in the program's run.
struct CodePlace {
  uint32_t Thread = 0;
  uint32_t Pc = 0;
  CallContext Calls = 0;
};

/// The tree of calls.
class CallContexts {
public:
  CallContexts() : Nodes(1) {}

  /// Behind the call at \p CallPc in \p Context.
  CallContext child(CallContext Context, uint32_t CallPc);

  /// The addresses of the calls that led to \p Context, the innermost first.
  std::vector<uint32_t> calls(CallContext Context) const;
  /// The same behind the instruction at \p Pc: the stack there.
  std::vector<uint32_t> stackAt(uint32_t Pc, CallContext Context) const;

private:
  /// Deeper and other calls than these are not told apart: what follows them
  /// has an empty stack.
  static constexpr std::size_t MaxNodes = 1 << 22;

  struct Node {
    CallContext Caller = 0;
    uint32_t CallPc = 0;
  };
  std::vector<Node> Nodes;
  /// By caller and address of the call.
  std::unordered_map<uint64_t, CallContext> Children;
};

/// The calls that one thread is in.
class ThreadCallStack {
public:
  CallContext context() const { return Frames.empty() ? 0 : Frames.back().In; }

  /// A call at \p CallPc with the stack pointer \p StackPointer, that returns
  /// to \p ReturnPc.
  void called(CallContexts &Contexts, uint32_t CallPc, uint32_t ReturnPc,
              uint32_t StackPointer) {
    // What has not saved its return address cannot call again and return.
    while (!Frames.empty() && (Frames.back().StackPointer < StackPointer ||
                               (Frames.back().StackPointer == StackPointer &&
                                Frames.back().ReturnPc == ReturnPc)))
      Frames.pop_back();
    Frames.push_back(
        {ReturnPc, StackPointer, Contexts.child(context(), CallPc)});
  }
  /// A jump to an address in a register: it may be a return, or that of
  /// longjmp.
  void jumped(uint32_t Target, uint32_t StackPointer) {
    while (!Frames.empty() && Frames.back().StackPointer < StackPointer)
      Frames.pop_back();
    if (!Frames.empty() && Frames.back().ReturnPc == Target)
      Frames.pop_back();
  }

private:
  struct Frame {
    uint32_t ReturnPc;
    uint32_t StackPointer;
    CallContext In;
  };
  std::vector<Frame> Frames;
};

} // namespace tp

#endif // TP_SIMULATOR_CHECK_CALLCONTEXTS_H
