// Ray events that contradict each other end the run with an error; values of
// other markers are nobody's business.
//
// RUN: tpcc -O2 -I%source_dir %s -o %t.elf
// RUN: not tpsim --chip 1x1 %t.elf 2>&1 | FileCheck %s
// RUN: not tpsim --chip 1x1 --quiet --stats %t.json %t.elf 2>&1 | FileCheck %s
// RUN: FileCheck %s --check-prefix=JSON < %t.json
// CHECK: tpsim: error: ray events of thread 0 contradict each other: event 10, SlotVisit(0x00000079) in ray 1: a visit is to a slot that is not loaded
// JSON-NOT: ray_profile
//
// RUN: tpcc -O2 -DOTHER -I%source_dir %s -o %t.other.elf
// RUN: tpsim --chip 1x1 %t.other.elf

#include "kernels/common/RayEvents.h"

using tp::RayEvent;
using tp::rayEvent;

int main() {
#ifdef OTHER
  tp::profileValue<5>(17);
  return 0;
#endif
  rayEvent(RayEvent::CacheSlots, 3);
  rayEvent(RayEvent::CacheSlotBytes, 120);
  rayEvent(RayEvent::CacheSlotTriangles, 2);
  rayEvent(RayEvent::CacheChildOffset, 96);
  rayEvent(RayEvent::RayBegin, 0);
  rayEvent(RayEvent::SlotLoadFrom, 0);
  rayEvent(RayEvent::SlotLoadParent, 0xFFFFFFFC);
  rayEvent(RayEvent::SlotLoadInto, 1);
  rayEvent(RayEvent::SlotVisit, 1);
  rayEvent(RayEvent::SlotVisit, 121);
  rayEvent(RayEvent::SlotVisit, 5);
  return 0;
}
