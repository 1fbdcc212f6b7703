//===- RayProfiler.cpp - Interprets the ray events of all threads ---------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/profile/RayProfiler.h"

namespace tp {

static bool isRayEvent(uint32_t Marker) {
  switch (static_cast<RayEvent>(Marker)) {
#define TP_RAY_EVENT(Name, Marker) case RayEvent::Name:
#include "kernels/common/RayEvents.def"
    return true;
  }
  return false;
}

void RayProfiler::profileValue(uint32_t Thread, uint32_t Marker,
                               uint32_t Value) {
  if (isRayEvent(Marker))
    Threads[Thread].report(static_cast<RayEvent>(Marker), Value);
}

void RayProfiler::recordDeletion(const DeletionRequest &Request) {
  Recorded = Request;
  Threads[Request.Thread].recordDeletion(Request.Deletion);
}

ErrorOr<const DeletionRecord *> RayProfiler::recordedDeletion() const {
  const ThreadRayProfiler &Thread = Threads[Recorded.Thread];
  if (const std::optional<DeletionRecord> &Found = Thread.recorder()->record())
    return &*Found;
  const RayProfile Profile = Thread.profile();
  const std::string Name = "thread " + std::to_string(Recorded.Thread);
  if (!Profile.Cache)
    return Error{Name + " has no cache of the BVH"};
  return Error{Name + " has no deletion " + std::to_string(Recorded.Deletion) +
               ": it made " + std::to_string(Profile.Cache->Deletions)};
}

std::vector<RayProfile> RayProfiler::threads() const {
  std::vector<RayProfile> Profiles;
  Profiles.reserve(Threads.size());
  for (const ThreadRayProfiler &Thread : Threads)
    Profiles.push_back(Thread.profile());
  return Profiles;
}

Status RayProfiler::check() const {
  std::optional<CacheShape> Shape;
  for (size_t Number = 0; Number != Threads.size(); ++Number) {
    const std::string Name = "ray events of thread " + std::to_string(Number);
    const ThreadRayProfiler &Thread = Threads[Number];
    if (!Thread.contradiction().empty())
      return Error{Name + " contradict each other: " + Thread.contradiction()};
    const RayProfile Profile = Thread.profile();
    if (!Profile.Cache)
      continue;
    if (Shape && *Shape != Profile.Cache->Shape)
      return Error{Name + ": its cache is not like those of others"};
    Shape = Profile.Cache->Shape;
  }
  return success();
}

std::optional<RayProfile> sumOf(const std::vector<RayProfile> &Threads) {
  RayProfile Sum;
  for (const RayProfile &Thread : Threads)
    Sum.add(Thread);
  if (Sum.rays() == 0)
    return std::nullopt;
  return Sum;
}

} // namespace tp
