//===- CallTree.h - Chains of calls that threads are in ---------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_CALLTREE_H
#define TP_SIMULATOR_CORE_CALLTREE_H

#include "simulator/core/Archive.h"

#include <atomic>
#include <cstdint>
#include <mutex>
#include <vector>

namespace tp {

/// Numbers chains of calls as they are found. Host threads may ask at once.
class CallTree {
public:
  static constexpr uint32_t NoNode = ~uint32_t(0);

  struct Node {
    /// NoNode of functions of which no call was seen.
    uint32_t Caller = NoNode;
    /// The word that called.
    uint32_t Site = 0;
    uint32_t Function = 0;

    bool operator==(const Node &) const = default;
  };

  CallTree();

  /// The number of a node, which is new if there was none. Of a function that
  /// is in its caller's chain already it is the node there: recursion is one
  /// node. If there are too many nodes it is that of the caller, or the
  /// first one, and isCut() from then on.
  uint32_t numberOf(const Node &Wanted);
  const Node &node(uint32_t Number) const { return Nodes[Number]; }
  /// When no host thread asks.
  uint32_t size() const { return Count; }
  bool isCut() const { return IsCut; }
  /// When no host thread asks.
  void serialize(Archive &A);

private:
  static constexpr uint32_t MaxEdges = 1 << 16;
  static constexpr uint32_t TableSize = 2 * MaxEdges;

  /// Who called whom, and the node that this leads to.
  struct Edge {
    Node Called;
    uint32_t Number = NoNode;
  };

  uint32_t add(const Node &Wanted);
  /// The node of a new edge.
  uint32_t nodeFor(const Node &Wanted);

  std::mutex Mutex;
  std::atomic<bool> IsCut = false;
  uint32_t Count = 0, EdgeCount = 0;
  std::vector<Node> Nodes;
  std::vector<Edge> Edges;
  /// Hash table of numbers of edges plus 1. An entry never changes once it is
  /// not 0, and by then edge and node are there.
  std::vector<std::atomic<uint32_t>> Table;
};

} // namespace tp

#endif // TP_SIMULATOR_CORE_CALLTREE_H
