//===- ThreadRayProfiler.cpp - What a thread's ray events mean ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/profile/ThreadRayProfiler.h"

#include <algorithm>
#include <bit>
#include <cinttypes>
#include <cstdio>

namespace tp {

static const char *nameOf(RayEvent Event) {
  switch (Event) {
#define TP_RAY_EVENT(Name, Marker)                                             \
  case RayEvent::Name:                                                         \
    return #Name;
#include "kernels/common/RayEvents.def"
  }
  return "?";
}

static void countAt(std::vector<uint64_t> &Counts, size_t Index) {
  if (Index >= Counts.size())
    Counts.resize(Index + 1);
  ++Counts[Index];
}

PerRayCount ThreadRayProfiler::Counter::finished() const {
  return {Rays.Total + Current, std::max(Rays.Maximum, Current)};
}

RayProfile ThreadRayProfiler::profile() const {
  RayProfile Result = Counts;
  Result.NodesVisited = NodesVisited.finished();
  Result.TrianglesVisited = TrianglesVisited.finished();
  Result.NodesFromMemory = NodesFromMemory.finished();
  Result.TrianglesFromMemory = TrianglesFromMemory.finished();
  return Result;
}

void ThreadRayProfiler::report(RayEvent Event, uint32_t Value) {
  ++EventNumber;
  if (!Error.empty())
    return;
  if (const Contradiction Found = process(Event, Value)) {
    char Text[200];
    std::snprintf(Text, sizeof(Text),
                  "event %" PRIu64 ", %s(0x%08" PRIx32 ") in ray %" PRIu64
                  ": %s",
                  EventNumber, nameOf(Event), Value, Counts.rays(), Found);
    Error = Text;
  }
  Last = Event;
}

bool ThreadRayProfiler::mayFollow(RayEvent Event) const {
  if (Last == RayEvent::SlotLoadFrom)
    return Event == RayEvent::SlotLoadParent;
  if (Last == RayEvent::SlotLoadParent)
    return Event == RayEvent::SlotLoadInto;
  if (Last == RayEvent::DeletionBegin || Last == RayEvent::SlotFreed)
    return Event == RayEvent::SlotFreed || Event == RayEvent::DeletionEnd;
  return Event != RayEvent::SlotLoadParent && Event != RayEvent::SlotLoadInto &&
         Event != RayEvent::SlotFreed && Event != RayEvent::DeletionEnd;
}

Contradiction ThreadRayProfiler::process(RayEvent Event, uint32_t Value) {
  if (!mayFollow(Event))
    return "it cannot follow the event before it";
  switch (Event) {
  case RayEvent::RayBegin:
    return beginRay(Value);
  case RayEvent::CacheSlots:
  case RayEvent::CacheSlotBytes:
  case RayEvent::CacheSlotTriangles:
  case RayEvent::CacheChildOffset:
    return processShape(Event, Value);
  default:
    break;
  }
  if (Counts.rays() == 0)
    return "no ray has begun";
  if (Event == RayEvent::NodeFromMemory) {
    ++NodesVisited.Current;
    ++NodesFromMemory.Current;
    return isLeaf(Value) ? "a leaf is not a node" : nullptr;
  }
  if (Event == RayEvent::TrianglesFromMemory) {
    TrianglesVisited.Current += leafCount(Value);
    TrianglesFromMemory.Current += leafCount(Value);
    return isLeaf(Value) ? nullptr : "an inner node has no triangles";
  }
  if (!Mirror || !Counts.Cache)
    return "the thread has not said that it has a cache";
  return processCacheEvent({*Mirror, *Counts.Cache}, Event, Value);
}

Contradiction ThreadRayProfiler::processCacheEvent(const CacheRecord &Cache,
                                                   RayEvent Event,
                                                   uint32_t Value) {
  switch (Event) {
  case RayEvent::SlotLoadFrom:
    LoadFrom = Value;
    return nullptr;
  case RayEvent::SlotLoadParent:
    LoadParent = Value;
    return nullptr;
  case RayEvent::SlotLoadInto:
    return load(Cache, Value);
  case RayEvent::SlotVisit:
    return visit(Cache, Value);
  case RayEvent::DeletionBegin:
    return beginDeletion(Cache, Value);
  case RayEvent::SlotFreed:
    return freeSlot(Cache, Value);
  case RayEvent::DeletionEnd:
    return endDeletion(Cache, Value);
  case RayEvent::Bypass:
    ++Cache.Profile.Bypasses;
    return nullptr;
  default:
    return "it is unknown";
  }
}

/// The four events that describe the cache, in this order.
Contradiction ThreadRayProfiler::processShape(RayEvent Event, uint32_t Value) {
  if (Counts.rays() != 0)
    return "a ray has begun before";
  constexpr RayEvent Order[] = {RayEvent::CacheSlots, RayEvent::CacheSlotBytes,
                                RayEvent::CacheSlotTriangles,
                                RayEvent::CacheChildOffset};
  uint32_t *const Members[] = {&Shape.Slots, &Shape.SlotBytes,
                               &Shape.SlotTriangles, &Shape.ChildOffset};
  const size_t Index = std::find(Order, std::end(Order), Event) - Order;
  if (Mirror || (Index == 0 ? Last.has_value() : Last != Order[Index - 1]))
    return "the events that describe the cache do not come once and in order";
  *Members[Index] = Value;
  if (Event != RayEvent::CacheChildOffset)
    return nullptr;
  if (const Contradiction Found = CacheMirror::check(Shape))
    return Found;
  Mirror.emplace(Shape);
  AwaitingRay.resize(Shape.Slots);
  Counts.Cache.emplace().Shape = Shape;
  return nullptr;
}

Contradiction ThreadRayProfiler::beginRay(uint32_t Kind) {
  if (Kind > 1)
    return "there is no such kind of ray";
  if (Shape.Slots != 0 && !Mirror)
    return "the cache is described in part only";
  for (Counter *C : {&NodesVisited, &TrianglesVisited, &NodesFromMemory,
                     &TrianglesFromMemory}) {
    C->Rays = C->finished();
    C->Current = 0;
  }
  ++(Kind == 0 ? Counts.ClosestHitRays : Counts.AnyHitRays);
  return nullptr;
}

Contradiction ThreadRayProfiler::load(const CacheRecord &Cache,
                                      CacheLink Into) {
  if (const Contradiction Found = Cache.Mirror.load(LoadFrom, LoadParent, Into))
    return Found;
  const CacheMirror::Slot &Slot =
      Cache.Mirror.slots()[Cache.Mirror.slotOf(Into)];
  if (isLeaf(LoadFrom))
    TrianglesFromMemory.Current += Cache.Mirror.trianglesIn(Slot);
  else
    ++NodesFromMemory.Current;
  ++Cache.Profile.Loads;
  countAt(Cache.Profile.LoadsByDepth, Slot.Depth);
  Cache.Profile.PeakSlotsUsed =
      std::max(Cache.Profile.PeakSlotsUsed, Cache.Mirror.usedSlots());
  AwaitingRay[Cache.Mirror.slotOf(Into)] = Counts.rays();
  if (Recorder)
    Recorder->load(Cache.Mirror, LoadParent);
  return nullptr;
}

Contradiction ThreadRayProfiler::visit(const CacheRecord &Cache,
                                       CacheLink Link) {
  if (const Contradiction Found = Cache.Mirror.visit(Link))
    return Found;
  const CacheMirror::Slot &Slot =
      Cache.Mirror.slots()[Cache.Mirror.slotOf(Link)];
  if (Slot.Is == CacheMirror::Slot::Leaf)
    TrianglesVisited.Current += Cache.Mirror.trianglesIn(Slot);
  else
    ++NodesVisited.Current;
  ++Cache.Profile.Visits;
  uint64_t &LoadedFor = AwaitingRay[Cache.Mirror.slotOf(Link)];
  if (LoadedFor != Counts.rays()) {
    ++Cache.Profile.Hits;
    countAt(Cache.Profile.HitsByDepth, Slot.Depth);
    if (Recorder)
      Recorder->visit();
  }
  LoadedFor = 0;
  return nullptr;
}

Contradiction ThreadRayProfiler::beginDeletion(const CacheRecord &Cache,
                                               uint32_t Word) {
  if (Recorder)
    Recorder->begin(Cache.Mirror, Counts.rays());
  return Cache.Mirror.beginDeletion(Word);
}

Contradiction ThreadRayProfiler::freeSlot(const CacheRecord &Cache,
                                          uint32_t Offset) {
  if (const Contradiction Found = Cache.Mirror.freeSlot(Offset))
    return Found;
  if (Recorder)
    Recorder->freeSlot(Cache.Mirror.slotOf(Offset));
  return nullptr;
}

Contradiction ThreadRayProfiler::endDeletion(const CacheRecord &Cache,
                                             uint32_t Count) {
  if (const Contradiction Found = Cache.Mirror.endDeletion(Count))
    return Found;
  ++Cache.Profile.Deletions;
  Cache.Profile.SlotsFreed += Count;
  Cache.Profile.MaxSlotsFreed = std::max(Cache.Profile.MaxSlotsFreed, Count);
  ++Cache.Profile.DeletionsBySlotsFreed[std::bit_width(Count) - 1];
  if (Recorder)
    Recorder->end(Cache.Mirror);
  return nullptr;
}

} // namespace tp
