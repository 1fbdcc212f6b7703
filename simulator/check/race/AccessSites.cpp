//===- AccessSites.cpp - Numbers for places in the program ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/check/race/AccessSites.h"

namespace tp {

AccessSite AccessSites::find(AccessPlace Place, uint64_t Key) {
  if (auto Known = Numbers.find(Key); Known != Numbers.end())
    return Known->second;
  if (Place.Context != 0 && Places.size() >= MaxWithCalls)
    return find({Place.Pc, 0}, Place.Pc);
  Places.push_back(Place);
  return Numbers[Key] = AccessSite(Places.size() - 1);
}

} // namespace tp
