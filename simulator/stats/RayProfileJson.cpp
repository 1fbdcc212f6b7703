//===- RayProfileJson.cpp - A ray profile for programs --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/stats/RayProfileJson.h"

#include "llvm/ADT/ArrayRef.h"
#include "llvm/ADT/StringRef.h"

using namespace llvm;

namespace tp {

static void writeArray(json::OStream &Json, StringRef Name,
                       ArrayRef<uint64_t> Values) {
  Json.attributeArray(Name, [&] {
    for (uint64_t Value : Values)
      Json.value(Value);
  });
}

static void writeCache(const CacheProfile &Cache, json::OStream &Json) {
  Json.attributeObject("cache", [&] {
    Json.attribute("slots", Cache.Shape.Slots);
    Json.attribute("slot_bytes", Cache.Shape.SlotBytes);
    Json.attribute("visits", Cache.Visits);
    Json.attribute("hits", Cache.Hits);
    Json.attribute("loads", Cache.Loads);
    Json.attribute("bypasses", Cache.Bypasses);
    writeArray(Json, "hits_by_depth", Cache.HitsByDepth);
    writeArray(Json, "loads_by_depth", Cache.LoadsByDepth);
    Json.attribute("deletions", Cache.Deletions);
    Json.attributeObject("slots_freed", [&] {
      double Mean = Cache.Deletions == 0
                        ? 0
                        : double(Cache.SlotsFreed) / double(Cache.Deletions);
      Json.attribute("mean", Mean);
      Json.attribute("maximum", Cache.MaxSlotsFreed);
      ArrayRef<uint64_t> Histogram = Cache.DeletionsBySlotsFreed;
      while (!Histogram.empty() && Histogram.back() == 0)
        Histogram = Histogram.drop_back();
      writeArray(Json, "histogram", Histogram);
    });
    Json.attribute("peak_slots_used", Cache.PeakSlotsUsed);
  });
}

void writeRayProfile(const RayProfile &Profile, json::OStream &Json) {
  const std::pair<const char *, const PerRayCount &> Counts[] = {
      {"nodes_visited", Profile.NodesVisited},
      {"triangles_visited", Profile.TrianglesVisited},
      {"nodes_from_memory", Profile.NodesFromMemory},
      {"triangles_from_memory", Profile.TrianglesFromMemory},
  };
  Json.attributeObject("ray_profile", [&] {
    Json.attributeObject("rays", [&] {
      Json.attribute("closest", Profile.ClosestHitRays);
      Json.attribute("any", Profile.AnyHitRays);
    });
    Json.attributeObject("per_ray", [&] {
      for (const auto &[Name, Count] : Counts)
        Json.attributeObject(Name, [&, &Count = Count] {
          Json.attribute("mean", double(Count.Total) / double(Profile.rays()));
          Json.attribute("maximum", Count.Maximum);
        });
    });
    for (const auto &[Name, Count] : Counts)
      Json.attribute(Name, Count.Total);
    if (Profile.Cache)
      writeCache(*Profile.Cache, Json);
  });
}

} // namespace tp
