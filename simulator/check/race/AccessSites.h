//===- AccessSites.h - Numbers for places in the program --------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHECK_RACE_ACCESSSITES_H
#define TP_SIMULATOR_CHECK_RACE_ACCESSSITES_H

#include "simulator/check/CallContexts.h"
#include "simulator/check/race/AccessRecord.h"

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace tp {

/// An instruction and the calls that led to it.
struct AccessPlace {
  uint32_t Pc = 0;
  CallContext Context = 0;
};

/// Gives places numbers that fit into an AccessRecord.
class AccessSites {
public:
  /// For a text of \p TextWords words. When \p MaxSites numbers are not enough
  /// for all, the calls of further places are not told apart.
  explicit AccessSites(uint32_t TextWords,
                       size_t MaxSites = size_t(1) << AccessRecord::SiteBits)
      : MaxWithCalls(MaxSites > TextWords ? MaxSites - TextWords : 0) {}

  AccessSite of(AccessPlace Place) {
    const uint64_t Key = uint64_t(Place.Context) << 32 | Place.Pc;
    Recent &Slot = Cache[(Place.Pc / 4 + Place.Context * 61) % Cache.size()];
    if (Slot.Key != Key)
      Slot = {Key, find(Place, Key)};
    return Slot.Site;
  }
  AccessPlace place(AccessSite Site) const { return Places[Site]; }

private:
  struct Recent {
    uint64_t Key = ~uint64_t(0);
    AccessSite Site = 0;
  };

  AccessSite find(AccessPlace Place, uint64_t Key);

  size_t MaxWithCalls;
  std::vector<AccessPlace> Places;
  std::unordered_map<uint64_t, AccessSite> Numbers;
  std::array<Recent, 4096> Cache;
};

} // namespace tp

#endif // TP_SIMULATOR_CHECK_RACE_ACCESSSITES_H
