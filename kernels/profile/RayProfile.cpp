//===- RayProfile.cpp - What rays and their cache did ---------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/profile/RayProfile.h"

#include <algorithm>

namespace tp {

static void add(PerRayCount &Sum, const PerRayCount &Other) {
  Sum.Total += Other.Total;
  Sum.Maximum = std::max(Sum.Maximum, Other.Maximum);
}

template <typename Counts>
static void addEach(Counts &Sums, const Counts &Others) {
  for (size_t I = 0; I != Others.size(); ++I)
    Sums[I] += Others[I];
}

static void addByDepth(std::vector<uint64_t> &Sums,
                       const std::vector<uint64_t> &Others) {
  Sums.resize(std::max(Sums.size(), Others.size()));
  addEach(Sums, Others);
}

static void add(CacheProfile &Sum, const CacheProfile &Other) {
  Sum.Visits += Other.Visits;
  Sum.Hits += Other.Hits;
  Sum.Loads += Other.Loads;
  Sum.Bypasses += Other.Bypasses;
  addByDepth(Sum.HitsByDepth, Other.HitsByDepth);
  addByDepth(Sum.LoadsByDepth, Other.LoadsByDepth);
  Sum.Deletions += Other.Deletions;
  Sum.SlotsFreed += Other.SlotsFreed;
  Sum.MaxSlotsFreed = std::max(Sum.MaxSlotsFreed, Other.MaxSlotsFreed);
  addEach(Sum.DeletionsBySlotsFreed, Other.DeletionsBySlotsFreed);
  Sum.PeakSlotsUsed = std::max(Sum.PeakSlotsUsed, Other.PeakSlotsUsed);
}

void RayProfile::add(const RayProfile &Other) {
  ClosestHitRays += Other.ClosestHitRays;
  AnyHitRays += Other.AnyHitRays;
  tp::add(NodesVisited, Other.NodesVisited);
  tp::add(TrianglesVisited, Other.TrianglesVisited);
  tp::add(NodesFromMemory, Other.NodesFromMemory);
  tp::add(TrianglesFromMemory, Other.TrianglesFromMemory);
  if (!Other.Cache)
    return;
  if (Cache)
    tp::add(*Cache, *Other.Cache);
  else
    Cache = Other.Cache;
}

} // namespace tp
