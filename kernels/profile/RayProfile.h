//===- RayProfile.h - What rays and their cache did -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_PROFILE_RAYPROFILE_H
#define TP_KERNELS_PROFILE_RAYPROFILE_H

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace tp {

/// Something that is counted ray by ray.
struct PerRayCount {
  uint64_t Total = 0;
  /// The largest count of one ray.
  uint32_t Maximum = 0;
};

/// A tree of slots that holds a part of the BVH.
struct CacheShape {
  uint32_t Slots = 0;
  uint32_t SlotBytes = 0;
  /// Triangles of a leaf that fit into a slot.
  uint32_t SlotTriangles = 0;
  /// Offset in a slot of the links of an inner node, in bytes; that of the
  /// references in the node in memory, too.
  uint32_t ChildOffset = 0;

  bool operator==(const CacheShape &) const = default;
};

/// What happened to the caches of some threads.
struct CacheProfile {
  CacheShape Shape;
  /// Of nodes and parts of leaves in slots; a hit is one that the ray need not
  /// load for it.
  uint64_t Visits = 0;
  uint64_t Hits = 0;
  uint64_t Loads = 0;
  /// Subtrees visited in memory for want of a slot.
  uint64_t Bypasses = 0;
  /// By depth in the cache's tree; that of the root is 0.
  std::vector<uint64_t> HitsByDepth;
  std::vector<uint64_t> LoadsByDepth;
  uint64_t Deletions = 0;
  uint64_t SlotsFreed = 0;
  /// By one deletion.
  uint32_t MaxSlotsFreed = 0;
  /// Deletions that freed 2^i to 2^(i+1)-1 slots.
  std::array<uint64_t, 16> DeletionsBySlotsFreed{};
  /// The most that one thread had at a time.
  uint32_t PeakSlotsUsed = 0;

  /// Saves or restores (simulator/core/Archive.h); so below.
  template <class Archive> void serialize(Archive &A) {
    A(Shape);
    A(Visits);
    A(Hits);
    A(Loads);
    A(Bypasses);
    A(HitsByDepth);
    A(LoadsByDepth);
    A(Deletions);
    A(SlotsFreed);
    A(MaxSlotsFreed);
    A(DeletionsBySlotsFreed);
    A(PeakSlotsUsed);
  }
};

/// What the rays of some threads did.
struct RayProfile {
  uint64_t ClosestHitRays = 0;
  uint64_t AnyHitRays = 0;
  /// Inner nodes and triangles that were tested, and those that were read from
  /// global memory.
  PerRayCount NodesVisited;
  PerRayCount TrianglesVisited;
  PerRayCount NodesFromMemory;
  PerRayCount TrianglesFromMemory;
  /// If there is a cache.
  std::optional<CacheProfile> Cache;

  uint64_t rays() const { return ClosestHitRays + AnyHitRays; }

  template <class Archive> void serialize(Archive &A) {
    A(ClosestHitRays);
    A(AnyHitRays);
    A(NodesVisited);
    A(TrianglesVisited);
    A(NodesFromMemory);
    A(TrianglesFromMemory);
    A(Cache);
  }

  /// Adds another thread's. The shapes of the caches must be equal.
  void add(const RayProfile &Other);
};

} // namespace tp

#endif // TP_KERNELS_PROFILE_RAYPROFILE_H
