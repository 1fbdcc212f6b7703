//===- CallTree.cpp - Chains of calls that threads are in -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/core/CallTree.h"

#include <algorithm>

namespace tp {

CallTree::CallTree() : Nodes(MaxEdges), Edges(MaxEdges), Table(TableSize) {}

static uint32_t hashOf(const CallTree::Node &Node) {
  uint64_t Hash = (uint64_t(Node.Caller) << 32 | Node.Site) +
                  uint64_t(Node.Function) * 0x9E3779B97F4A7C15;
  Hash *= 0xBF58476D1CE4E5B9;
  return uint32_t(Hash >> 32);
}

uint32_t CallTree::numberOf(const Node &Wanted) {
  for (uint32_t Place = hashOf(Wanted) % TableSize;;
       Place = (Place + 1) % TableSize) {
    uint32_t Found = Table[Place].load(std::memory_order_acquire);
    if (Found == 0)
      return add(Wanted);
    if (Edges[Found - 1].Called == Wanted)
      return Edges[Found - 1].Number;
  }
}

uint32_t CallTree::nodeFor(const Node &Wanted) {
  for (uint32_t Outer = Wanted.Caller; Outer != NoNode;
       Outer = Nodes[Outer].Caller)
    if (Nodes[Outer].Function == Wanted.Function)
      return Outer;
  Nodes[Count] = Wanted;
  return Count++;
}

uint32_t CallTree::add(const Node &Wanted) {
  std::lock_guard Lock(Mutex);
  uint32_t Place = hashOf(Wanted) % TableSize;
  for (; uint32_t Found = Table[Place].load(std::memory_order_relaxed);
       Place = (Place + 1) % TableSize)
    if (Edges[Found - 1].Called == Wanted)
      return Edges[Found - 1].Number;
  // The last ones are for functions without a caller.
  constexpr uint32_t MaxCalled = MaxEdges / 2;
  if (EdgeCount >= MaxCalled && Wanted.Caller != NoNode) {
    IsCut = true;
    return Wanted.Caller;
  }
  if (EdgeCount == MaxEdges) {
    IsCut = true;
    return 0;
  }
  uint32_t Number = nodeFor(Wanted);
  Edges[EdgeCount] = {Wanted, Number};
  Table[Place].store(++EdgeCount, std::memory_order_release);
  return Number;
}

void CallTree::serialize(Archive &A) {
  uint32_t Saved = EdgeCount;
  A(Saved);
  for (uint32_t I = 0; I != std::min(Saved, MaxEdges); ++I) {
    Node Called = Edges[I].Called;
    A(Called);
    // In the same order they lead to the same nodes.
    if (A.isRestoring())
      add(Called);
  }
  bool WasCut = IsCut;
  A(WasCut);
  IsCut = WasCut;
}

} // namespace tp
