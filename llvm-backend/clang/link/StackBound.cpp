//===- StackBound.cpp - How deep a program's stack may get ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/link/StackBound.h"
#include "llvm-backend/clang/link/MemoryMap.h"
#include "llvm/ADT/DenseSet.h"
#include "llvm/ADT/GraphTraits.h"
#include "llvm/ADT/SCCIterator.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/Support/MathExtras.h"

using namespace llvm;

template <> struct llvm::GraphTraits<const tp::CallGraph *> {
  using NodeRef = const tp::CallGraphNode *;
  static NodeRef callee(const tp::Call &C) { return C.Callee; }
  using ChildIteratorType =
      mapped_iterator<std::vector<tp::Call>::const_iterator,
                      NodeRef (*)(const tp::Call &)>;
  static NodeRef getEntryNode(const tp::CallGraph *Graph) {
    return Graph->Entry;
  }
  // NOLINTBEGIN(readability-identifier-naming): LLVM's names.
  static ChildIteratorType child_begin(NodeRef Node) {
    return {Node->Calls.begin(), &callee};
  }
  static ChildIteratorType child_end(NodeRef Node) {
    return {Node->Calls.end(), &callee};
  }
  // NOLINTEND(readability-identifier-naming)
};

namespace tp {

namespace {

using NodePath = std::vector<const CallGraphNode *>;

/// Functions that reach each other, or a single one.
using Component = std::vector<const CallGraphNode *>;

class Bounder {
public:
  explicit Bounder(const CallGraph &Graph) : Graph(Graph) {}
  StackBound bound();

private:
  struct Depth {
    uint64_t Bytes = 0;
    /// Null where the node itself is the deepest.
    const CallGraphNode *Next = nullptr;
    uint32_t FrameBytes = 0;
  };

  bool reject(const Component &Members);
  bool rejectRecursion(const Component &Members);
  void measure(const Component &Members);
  NodePath path(const CallGraphNode *From, const CallGraphNode *To,
                const Component *Within) const;
  void setReason(const Twine &What, const CallGraphNode *Culprit);

  const CallGraph &Graph;
  DenseMap<const CallGraphNode *, Depth> Depths;
  StackBound Result;
};

} // namespace

static std::string join(const NodePath &Path) {
  std::string Text;
  for (const CallGraphNode *Node : Path)
    Text += (Text.empty() ? "" : " -> ") + Node->Name;
  return Text;
}

// A shortest path with at least one call, through members of \p Within if it is
// not null. There is one.
NodePath Bounder::path(const CallGraphNode *From, const CallGraphNode *To,
                       const Component *Within) const {
  DenseMap<const CallGraphNode *, const CallGraphNode *> CallerOf;
  NodePath Reached = {From};
  for (size_t I = 0; I != Reached.size() && !CallerOf.contains(To); ++I)
    for (const Call &C : Reached[I]->Calls)
      if ((!Within || is_contained(*Within, C.Callee)) &&
          CallerOf.try_emplace(C.Callee, Reached[I]).second)
        Reached.push_back(C.Callee);
  NodePath Path = {To};
  do
    Path.push_back(CallerOf.lookup(Path.back()));
  while (Path.back() != From);
  std::reverse(Path.begin(), Path.end());
  return Path;
}

void Bounder::setReason(const Twine &What, const CallGraphNode *Culprit) {
  Result.Reason = ("  " + What).str();
  if (Culprit != Graph.Entry)
    Result.Reason +=
        "\n  reached by " + join(path(Graph.Entry, Culprit, nullptr));
}

bool Bounder::reject(const Component &Members) {
  for (const CallGraphNode *Node : Members) {
    switch (Node->Kind) {
    case CallGraphNode::Frame::Known:
      continue;
    case CallGraphNode::Frame::Dynamic:
      setReason(Node->Name + " takes stack of a size that it computes (alloca "
                             "or an array of variable length)",
                Node);
      return true;
    case CallGraphNode::Frame::Unstated:
      setReason(Node->Name + " is not compiled and does not state what it "
                             "takes of the stack (section .tp.frames)",
                Node);
      return true;
    }
  }
  return rejectRecursion(Members);
}

// Calls in a circle that cost nothing, as tail calls do, go as deep as one.
bool Bounder::rejectRecursion(const Component &Members) {
  const DenseSet<const CallGraphNode *> Set(Members.begin(), Members.end());
  for (const CallGraphNode *Node : Members)
    for (const Call &C : Node->Calls)
      if (!C.IsTail && Node->FrameBytes != 0 && Set.contains(C.Callee)) {
        NodePath Circle = {Node};
        if (C.Callee != Node)
          append_range(Circle, path(C.Callee, Node, &Members));
        else
          Circle.push_back(Node);
        setReason("recursion: " + join(Circle), Node);
        return true;
      }
  return false;
}

void Bounder::measure(const Component &Members) {
  const DenseSet<const CallGraphNode *> Set(Members.begin(), Members.end());
  const CallGraphNode *Deepest = Members.front();
  for (const CallGraphNode *Node : Members) {
    Depth Own{Node->FrameBytes, nullptr, Node->FrameBytes};
    for (const Call &C : Node->Calls) {
      if (Set.contains(C.Callee))
        continue;
      const uint32_t Frame = C.IsTail ? 0 : Node->FrameBytes;
      const uint64_t Bytes = Frame + Depths.lookup(C.Callee).Bytes;
      if (Bytes > Own.Bytes)
        Own = {Bytes, C.Callee, Frame};
    }
    Depths[Node] = Own;
    if (Own.Bytes > Depths[Deepest].Bytes)
      Deepest = Node;
  }
  const uint64_t Bytes = Depths[Deepest].Bytes;
  for (const CallGraphNode *Node : Members)
    if (Node != Deepest)
      Depths[Node] = {Bytes, Deepest, 0};
}

StackBound Bounder::bound() {
  // Callees come before callers.
  for (auto I = scc_begin(&Graph); !I.isAtEnd(); ++I) {
    if (reject(*I))
      return Result;
    measure(*I);
  }
  const uint64_t Bytes =
      alignTo(Depths[Graph.Entry].Bytes, uint64_t(memorymap::StackAlignment));
  if (Bytes > kLocalStoreBytesMax) {
    setReason("it may take " + Twine(Bytes) +
                  " bytes, more than the largest local store has",
              Graph.Entry);
    return Result;
  }
  Result.Bytes = static_cast<uint32_t>(Bytes);
  for (const CallGraphNode *Node = Graph.Entry; Node; Node = Depths[Node].Next)
    Result.DeepestChain.push_back({Node->Name, Depths[Node].FrameBytes});
  return Result;
}

StackBound boundStack(const CallGraph &Graph) { return Bounder(Graph).bound(); }

std::string describeChain(const StackBound &Bound) {
  std::string Text;
  for (const StackBound::Step &Step : Bound.DeepestChain)
    Text += (Text.empty() ? "" : " -> ") + Step.Function;
  return Text;
}

} // namespace tp
