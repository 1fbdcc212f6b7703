//===- StackTree.h - Cycles by chain of calls -------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_PROFILE_STACKTREE_H
#define TP_SIMULATOR_PROFILE_STACKTREE_H

#include "simulator/profile/Profile.h"

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tp {

/// A function as it was reached through one chain of functions.
struct StackNode {
  uint32_t Function = 0;
  /// Of the nodes, an earlier one.
  std::optional<uint32_t> Outer;
  /// Without inner nodes.
  ProfileCounts Self;
  MemoryBehaviour Memory;
};

/// The call tree and the inlined functions in one: how a source-level view has
/// them. Nodes add up to all instructions of the profile.
///
/// It is known exactly what each function of the text did in each chain of
/// calls, and what each of its instructions did in all of them. The counts of
/// an instruction of a function with several chains are shared out as those of
/// the function are.
class StackTree {
public:
  explicit StackTree(const Profile &Data);

  const std::vector<StackNode> &nodes() const { return Nodes; }
  /// The functions of a node from the outermost to itself.
  std::vector<uint32_t> functionsOf(uint32_t Node) const;

private:
  uint32_t child(std::optional<uint32_t> Outer, uint32_t Function);
  /// The node of a frame whose outermost function was called from \p Base.
  uint32_t nodeOf(std::optional<uint32_t> Base, uint32_t Frame);
  void addCalls();
  void addInstruction(const ProfileInstruction &Instruction);

  const Profile &Data;
  std::vector<StackNode> Nodes;
  std::map<std::pair<std::optional<uint32_t>, uint32_t>, uint32_t> Children;
  /// Of each call the node that called, and of each function its calls.
  std::vector<std::optional<uint32_t>> Bases;
  std::map<uint32_t, std::vector<uint32_t>> CallsOf;
};

} // namespace tp

#endif // TP_SIMULATOR_PROFILE_STACKTREE_H
