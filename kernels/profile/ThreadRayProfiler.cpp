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
  if (!Mirror)
    return "the thread has not said that it has a cache";
  return processCacheEvent(Event, Value);
}

Contradiction ThreadRayProfiler::processCacheEvent(RayEvent Event,
                                                   uint32_t Value) {
  switch (Event) {
  case RayEvent::SlotLoadFrom:
    LoadFrom = Value;
    return nullptr;
  case RayEvent::SlotLoadParent:
    LoadParent = Value;
    return nullptr;
  case RayEvent::SlotLoadInto:
    return load(Value);
  case RayEvent::SlotVisit:
    return visit(Value);
  case RayEvent::DeletionBegin:
    return beginDeletion(Value);
  case RayEvent::SlotFreed:
    return freeSlot(Value);
  case RayEvent::DeletionEnd:
    return endDeletion(Value);
  case RayEvent::Bypass:
    ++Counts.Cache->Bypasses;
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
  Counts.Cache.emplace();
  Counts.Cache->Shape = Shape;
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

Contradiction ThreadRayProfiler::load(CacheLink Into) {
  if (const Contradiction Found = Mirror->load(LoadFrom, LoadParent, Into))
    return Found;
  const CacheMirror::Slot &Slot = Mirror->slots()[Mirror->slotOf(Into)];
  if (isLeaf(LoadFrom))
    TrianglesFromMemory.Current += Mirror->trianglesIn(Slot);
  else
    ++NodesFromMemory.Current;
  CacheProfile &Cache = *Counts.Cache;
  ++Cache.Loads;
  countAt(Cache.LoadsByDepth, Slot.Depth);
  Cache.PeakSlotsUsed = std::max(Cache.PeakSlotsUsed, Mirror->usedSlots());
  AwaitingRay[Mirror->slotOf(Into)] = Counts.rays();
  if (Recorder)
    Recorder->load(*Mirror, LoadParent);
  return nullptr;
}

Contradiction ThreadRayProfiler::visit(CacheLink Link) {
  if (const Contradiction Found = Mirror->visit(Link))
    return Found;
  const CacheMirror::Slot &Slot = Mirror->slots()[Mirror->slotOf(Link)];
  if (Slot.Is == CacheMirror::Slot::Leaf)
    TrianglesVisited.Current += Mirror->trianglesIn(Slot);
  else
    ++NodesVisited.Current;
  CacheProfile &Cache = *Counts.Cache;
  ++Cache.Visits;
  uint64_t &LoadedFor = AwaitingRay[Mirror->slotOf(Link)];
  if (LoadedFor != Counts.rays()) {
    ++Cache.Hits;
    countAt(Cache.HitsByDepth, Slot.Depth);
    if (Recorder)
      Recorder->visit();
  }
  LoadedFor = 0;
  return nullptr;
}

Contradiction ThreadRayProfiler::beginDeletion(uint32_t Word) {
  if (Recorder)
    Recorder->begin(*Mirror, Counts.rays());
  return Mirror->beginDeletion(Word);
}

Contradiction ThreadRayProfiler::freeSlot(uint32_t Offset) {
  if (const Contradiction Found = Mirror->freeSlot(Offset))
    return Found;
  if (Recorder)
    Recorder->freeSlot(Mirror->slotOf(Offset));
  return nullptr;
}

Contradiction ThreadRayProfiler::endDeletion(uint32_t Count) {
  if (const Contradiction Found = Mirror->endDeletion(Count))
    return Found;
  CacheProfile &Cache = *Counts.Cache;
  ++Cache.Deletions;
  Cache.SlotsFreed += Count;
  Cache.MaxSlotsFreed = std::max(Cache.MaxSlotsFreed, Count);
  ++Cache.DeletionsBySlotsFreed[std::bit_width(Count) - 1];
  if (Recorder)
    Recorder->end(*Mirror);
  return nullptr;
}

} // namespace tp
