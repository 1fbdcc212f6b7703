//===- CacheTrace.h - A deletion in a cache of the BVH ----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_TOOLS_CACHETRACE_H
#define TP_SIMULATOR_TOOLS_CACHETRACE_H

#include "kernels/common/LaunchSetup.h"
#include "kernels/profile/DeletionRecorder.h"

#include "llvm/Support/Error.h"
#include "llvm/Support/raw_ostream.h"

namespace tp {

/// A pointer of a slot.
struct TracedPointer {
  enum { Nothing, InMemory, InSlot } To = Nothing;
  /// The number of the slot.
  uint32_t Slot = 0;
  /// The node or leaf in memory.
  BvhReference Reference = 0;
};

/// A slot of a cache before or after a deletion.
struct TracedSlot {
  bool Loaded = false;
  bool IsLeaf = false;
  /// On the way from the root to the node whose child is to be loaded.
  bool OnPath = false;
  uint32_t Depth = 0;
  /// Number of the slot above; CacheMirror::None for the root.
  uint32_t Parent = 0;
  BvhReference Source = 0;
  /// Four of an inner node, one of a leaf.
  std::vector<TracedPointer> Pointers;
};

/// What the report of a deletion shows.
struct CacheTrace {
  DeletionRequest Which;
  const DeletionRecord *Record = nullptr;
  std::vector<TracedSlot> Before;
  std::vector<TracedSlot> After;
};

/// Looks up in the scene's tree what the pointers of \p Record's slots name
/// that is not loaded. Fails if a slot's node is not in the tree.
llvm::Expected<CacheTrace> traceDeletion(const DeletionRequest &Which,
                                         const DeletionRecord &Record,
                                         const LaunchBlock &Launch,
                                         const LaunchMemory &Memory);

/// Prints the slots before and after the deletion as tables.
void writeTable(const CacheTrace &Trace, llvm::raw_ostream &OS);

/// Writes the same as JSON; docs/tpsim.md lists the names.
void writeJson(const CacheTrace &Trace, llvm::raw_ostream &OS);

} // namespace tp

#endif // TP_SIMULATOR_TOOLS_CACHETRACE_H
