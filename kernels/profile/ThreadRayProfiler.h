//===- ThreadRayProfiler.h - What a thread's ray events mean ----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_PROFILE_THREADRAYPROFILER_H
#define TP_KERNELS_PROFILE_THREADRAYPROFILER_H

#include "kernels/common/RayEvents.h"
#include "kernels/profile/DeletionRecorder.h"

#include <memory>
#include <string>

namespace tp {

/// Counts what the ray events of one thread report, and checks that they fit
/// together.
class ThreadRayProfiler {
public:
  /// The thread reports \p Event with \p Value.
  void report(RayEvent Event, uint32_t Value);

  /// The counts of all rays that have begun.
  RayProfile profile() const;
  /// The first event that contradicted those before it, in words; empty if
  /// there was none. Nothing is counted from there on.
  const std::string &contradiction() const { return Error; }

  /// Records deletion \p Number, from 1.
  void recordDeletion(uint64_t Number) {
    Recorder = std::make_unique<DeletionRecorder>(Number);
  }
  /// Null if no deletion is to be recorded.
  const DeletionRecorder *recorder() const { return Recorder.get(); }

  /// A recorder, or none, must have been set before.
  template <class Archive> void serialize(Archive &A) {
    A(Counts);
    A(NodesVisited);
    A(TrianglesVisited);
    A(NodesFromMemory);
    A(TrianglesFromMemory);
    A(Shape);
    bool HasMirror = Mirror.has_value();
    A(HasMirror);
    if (!HasMirror)
      Mirror.reset();
    else if (!Mirror)
      Mirror.emplace(Shape);
    if (Mirror)
      A(*Mirror);
    A(LoadFrom);
    A(LoadParent);
    A(AwaitingRay);
    A(Last);
    A(EventNumber);
    A(Error);
    if (Recorder)
      Recorder->serialize(A, Shape);
  }

private:
  /// A PerRayCount in the making.
  struct Counter {
    PerRayCount Rays;
    uint32_t Current = 0;

    PerRayCount finished() const;
  };

  /// The thread's cache as it is, and what has been counted of it.
  struct CacheRecord {
    CacheMirror &Mirror;
    CacheProfile &Profile;
  };

  Contradiction process(RayEvent Event, uint32_t Value);
  Contradiction processCacheEvent(const CacheRecord &Cache, RayEvent Event,
                                  uint32_t Value);
  Contradiction processShape(RayEvent Event, uint32_t Value);
  Contradiction beginRay(uint32_t Kind);
  Contradiction load(const CacheRecord &Cache, CacheLink Into);
  Contradiction visit(const CacheRecord &Cache, CacheLink Link);
  Contradiction beginDeletion(const CacheRecord &Cache, uint32_t Word);
  Contradiction freeSlot(const CacheRecord &Cache, uint32_t Offset);
  Contradiction endDeletion(const CacheRecord &Cache, uint32_t Count);
  /// The events that may follow the last one, if only some may.
  bool mayFollow(RayEvent Event) const;

  RayProfile Counts;
  Counter NodesVisited, TrianglesVisited;
  Counter NodesFromMemory, TrianglesFromMemory;

  CacheShape Shape;
  std::optional<CacheMirror> Mirror;
  /// The load at hand.
  BvhReference LoadFrom = 0;
  uint32_t LoadParent = 0;
  /// By slot, the ray for which it was loaded if that has not visited it yet.
  std::vector<uint64_t> AwaitingRay;
  std::optional<RayEvent> Last;
  uint64_t EventNumber = 0;

  std::string Error;
  std::unique_ptr<DeletionRecorder> Recorder;
};

} // namespace tp

#endif // TP_KERNELS_PROFILE_THREADRAYPROFILER_H
