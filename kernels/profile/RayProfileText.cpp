//===- RayProfileText.cpp - A ray profile for people ----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/profile/RayProfileText.h"

#include <cstdarg>
#include <cstdio>

namespace tp {

[[gnu::format(printf, 2, 3)]] static void append(std::string &Text,
                                                 const char *Format, ...) {
  char Line[200];
  va_list Arguments;
  va_start(Arguments, Format);
  std::vsnprintf(Line, sizeof(Line), Format, Arguments);
  va_end(Arguments);
  Text += Line;
}

static double ratio(double Part, double Whole) {
  return Whole == 0 ? 0 : Part / Whole;
}

std::string describe(const RayProfile &Profile) {
  const auto Rays = static_cast<double>(Profile.rays());
  std::string Text = "per ray              mean   most of a ray\n";
  const auto Row = [&](const char *Name, const PerRayCount &Count) {
    append(Text, "%-16s%9.2f%16u\n", Name,
           ratio(static_cast<double>(Count.Total), Rays), Count.Maximum);
  };
  Row("nodes", Profile.NodesVisited);
  Row("  from memory", Profile.NodesFromMemory);
  Row("triangles", Profile.TrianglesVisited);
  Row("  from memory", Profile.TrianglesFromMemory);
  if (!Profile.Cache)
    return Text;

  const CacheProfile &Cache = *Profile.Cache;
  append(Text, "cache           %u slots of %u bytes, at most %u in use\n",
         Cache.Shape.Slots, Cache.Shape.SlotBytes, Cache.PeakSlotsUsed);
  append(Text,
         "  per ray       %.2f visits, %.1f %% hits, %.2f loads, "
         "%.3f bypasses\n",
         ratio(static_cast<double>(Cache.Visits), Rays),
         100 * ratio(static_cast<double>(Cache.Hits),
                     static_cast<double>(Cache.Visits)),
         ratio(static_cast<double>(Cache.Loads), Rays),
         ratio(static_cast<double>(Cache.Bypasses), Rays));
  append(Text, "  deletions     %.3f per ray, each of %.1f slots (most: %u)\n",
         ratio(static_cast<double>(Cache.Deletions), Rays),
         ratio(static_cast<double>(Cache.SlotsFreed),
               static_cast<double>(Cache.Deletions)),
         Cache.MaxSlotsFreed);
  return Text;
}

} // namespace tp
