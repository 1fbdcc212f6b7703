//===- JsonThreads.cpp - What each thread did, as JSON --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/stats/JsonBlocks.h"

using namespace llvm;

namespace tp {

static void writeProfiles(ArrayRef<RayProfile> Profiles, json::OStream &Json) {
  auto Write = [&](StringRef Name, auto Count) {
    writeFlatArray(Name, map_range(Profiles, Count), Json);
  };
  using Profile = const RayProfile &;
  Write("nodes_visited", [](Profile P) { return P.NodesVisited.Total; });
  Write("triangles_visited",
        [](Profile P) { return P.TrianglesVisited.Total; });
  Write("nodes_from_memory", [](Profile P) { return P.NodesFromMemory.Total; });
  Write("triangles_from_memory",
        [](Profile P) { return P.TrianglesFromMemory.Total; });
  if (none_of(Profiles, [](Profile P) { return P.Cache.has_value(); }))
    return;
  auto Cached = [](uint64_t CacheProfile::*Count) {
    return [Count](Profile P) { return P.Cache ? (*P.Cache).*Count : 0; };
  };
  Write("cache_visits", Cached(&CacheProfile::Visits));
  Write("cache_hits", Cached(&CacheProfile::Hits));
  Write("cache_deletions", Cached(&CacheProfile::Deletions));
}

void writeThreads(const RunSummary &Run, json::OStream &Json) {
  using Thread = const ThreadStatistics &;
  Json.attributeObject("threads", [&] {
    auto Write = [&](StringRef Name, auto Count) {
      writeFlatArray(Name, map_range(Run.Stats.Threads, Count), Json);
    };
    Write("instructions", [](Thread T) { return T.Instructions; });
    Write("finish_cycle", [](Thread T) { return T.FinishCycle; });
    Write("own_cycles", [&](Thread T) { return Run.ownCycles(T); });
    if (!Run.Rays.empty())
      writeFlatArray("rays", Run.Rays, Json);
    if (!Run.RayProfiles.empty())
      writeProfiles(Run.RayProfiles, Json);
  });
}

} // namespace tp
