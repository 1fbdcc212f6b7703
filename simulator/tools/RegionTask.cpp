//===- RegionTask.cpp - Measures only a part of a run ---------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/RegionTask.h"

using namespace llvm;

namespace tp {

RegionTask::RegionTask(const Options &Request, const RunSetup &Loaded)
    : Region(*Request.Regions), Loaded(Loaded), RaysInside(countRays().size()) {
}

std::vector<uint32_t> RegionTask::countRays() const {
  if (!Loaded.Source)
    return {};
  return readRayCounts(Loaded.Block, Loaded.ThreadCount, Loaded.Launch);
}

llvm::Error RegionTask::pause(Engine &Machine, RunResult::EndKind Now) {
  bool HasEnded = Now != RunResult::Paused;
  bool IsInside =
      !HasEnded && Machine.passes(Region.Begin) > Machine.passes(Region.End);
  if (IsInside == IsOpen)
    return llvm::Error::success();
  IsOpen = IsInside;
  if (IsOpen) {
    Before = Machine.statistics();
    RaysBefore = countRays();
    return llvm::Error::success();
  }
  Inside += Machine.statistics().since(Before);
  std::vector<uint32_t> Rays = countRays();
  for (size_t I = 0; I != Rays.size(); ++I)
    RaysInside[I] += Rays[I] - RaysBefore[I];
  return llvm::Error::success();
}

void RegionTask::serialize(Archive &A) {
  A(IsOpen);
  A(Before);
  A(RaysBefore);
  A(Inside);
  A(RaysInside);
}

Expected<Statistics> RegionTask::statistics(const Engine &Machine) const {
  if (!Inside.Threads.empty())
    return Inside;
  return createStringError(
      "--regions " + Twine(Region.Begin) + ":" + Twine(Region.End) +
      ": the program was never between these markers (passes of " +
      Twine(Region.Begin) + ": " + Twine(Machine.passes(Region.Begin)) +
      ", of " + Twine(Region.End) + ": " + Twine(Machine.passes(Region.End)) +
      ")");
}

} // namespace tp
