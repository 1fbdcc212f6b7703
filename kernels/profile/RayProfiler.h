//===- RayProfiler.h - Interprets the ray events of all threads -*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_PROFILE_RAYPROFILER_H
#define TP_KERNELS_PROFILE_RAYPROFILER_H

#include "kernels/profile/ThreadRayProfiler.h"
#include "runtime/include/tp/profile.h"
#include "scenes/ErrorOr.h"

namespace tp {

/// Counts what the rays of a run do. Each thread of the program has its own
/// counts, so that it does not matter which threads of the host report them.
class RayProfiler final : public ProfileObserver {
public:
  explicit RayProfiler(uint32_t ThreadCount) : Threads(ThreadCount) {}

  /// Values of markers that are no ray events are ignored.
  void profileValue(uint32_t Thread, uint32_t Marker, uint32_t Value) override;

  /// Keeps the slots before and after a deletion for recordedDeletion(). The
  /// thread must exist.
  void recordDeletion(const DeletionRequest &Request);
  /// What recordDeletion() asked for; an error says why there is no such
  /// deletion.
  ErrorOr<const DeletionRecord *> recordedDeletion() const;

  /// What was to be recorded must have been said before.
  template <class Archive> void serialize(Archive &A) {
    for (PaddedThread &Thread : Threads)
      Thread.serialize(A);
  }

  /// By thread, after the run.
  std::vector<RayProfile> threads() const;
  /// Fails if the events of a thread contradict each other, or the caches of
  /// two threads are different.
  Status check() const;

private:
  struct alignas(64) PaddedThread : ThreadRayProfiler {};

  std::vector<PaddedThread> Threads;
  DeletionRequest Recorded;
};

/// The sum over threads whose caches are alike; std::nullopt if there is no
/// ray.
std::optional<RayProfile> sumOf(const std::vector<RayProfile> &Threads);

} // namespace tp

#endif // TP_KERNELS_PROFILE_RAYPROFILER_H
