//===- StackCached.cpp - The stack-cached path tracer as a program --------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The baseline path tracer with a part of the tree kept in the local store:
// first the traversal stack, behind it the slots of the cache.
//
//   slots=N                     argument: use no more than N slots
//   -DTP_CACHE_POLICY=<class>   what is deleted (HighestBranch)
//   -DTP_CACHE_FORMAT=<class>   what a slot holds: FullSlots or QuantizedSlots
//                               (FullSlots)
//   -DTP_CACHE_CHECK            verify the cache after every deletion, and say
//                               how many there were; needs the .cpp files of
//                               kernels/treecache
//
//===----------------------------------------------------------------------===//

#include "kernels/common/EarlyLoad.h"
#include "kernels/pathtracer/PathTracer.h"
#include "kernels/stackcache/SlotArgument.h"
#include "kernels/treecache/CachedRayTracer.h"
#include "kernels/treecache/HighestBranch.h"
#include "kernels/treecache/KeepTop.h"
#include "kernels/treecache/LeastRecentlyUsed.h"
#include "tp/local_store.h"

#ifndef TP_CACHE_POLICY
#define TP_CACHE_POLICY HighestBranch
#endif
#ifndef TP_CACHE_FORMAT
#define TP_CACHE_FORMAT FullSlots
#endif

using namespace tp;

int main(int ArgumentCount, char **Arguments) {
  using RayTracer = CachedRayTracer<TP_CACHE_FORMAT, TP_CACHE_POLICY>;
  using Cache = RayTracer::Cache;

  const LaunchBlock Launch = loadTogether(launchBlock());
  const auto *Block = devicePointer<const SceneHeader>(Launch.Scene);
  const SceneHeader Header = loadTogether(*Block);
  const SceneView Scene(Block, Header);
  const LocalStoreSpace Space = freeLocalStore();
  const uint32_t StackBytes =
      traversalEntries(Scene.Header->BvhDepth) * sizeof(TraversalStack::Entry);
  const uint32_t Slots = readSlotArgument(
      ArgumentCount, Arguments,
      Space.Bytes < StackBytes ? 0 : Cache::slotsIn(Space.Bytes - StackBytes));
  if (Slots == 0)
    return 1;
  auto *Entries = reinterpret_cast<TraversalStack::Entry *>(Space.Begin);
  renderPixels(Launch, Scene,
               RayTracer(Scene,
                         Cache(Space.Begin + StackBytes, Slots,
                               TP_CACHE_FORMAT::Nodes::root(Scene)),
                         Entries));
#ifdef TP_CACHE_CHECK
  reportVerifiedDeletions();
#endif
  return 0;
}
