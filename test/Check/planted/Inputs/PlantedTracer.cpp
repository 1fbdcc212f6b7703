//===- PlantedTracer.cpp - A path tracer with faults to be found ----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The path tracer with a ray tracer of its own: thread 0 copies the tree into
// the heap, all traverse it by recursion. Each -DFAULT_... plants one fault,
// which the test of that name finds; without, there is nothing to report.
//
//===----------------------------------------------------------------------===//

#include "kernels/bvh/RayBoxTester.h"
#include "kernels/bvh/RayTriangleTester.h"
#include "kernels/pathtracer/PathTracer.h"

using namespace tp;

/// The tree in the heap.
static WideBvhNode *Nodes;
/// Of each thread, how many nodes its rays have met.
static uint32_t *Visits;

static void copyTree(const SceneView &Scene) {
  const uint32_t Count = Scene.Header->NodeCount;
  const auto *Sources = reinterpret_cast<const WideBvhNode *>(Scene.Nodes);
  WideBvhNode *Copy = new WideBvhNode[Count];
#ifdef FAULT_OFF_BY_ONE
  for (uint32_t I = 0; I <= Count; ++I)
#else
  for (uint32_t I = 0; I != Count; ++I)
#endif
    for (unsigned Child = 0; Child != kWideBvhWidth; ++Child) {
      for (unsigned Axis = 0; Axis != 3; ++Axis)
        for (unsigned Side = 0; Side != 2; ++Side)
          // OFF: PlantedTracer.cpp:[[#@LINE+1]]
          Copy[I].Bounds[Axis][Side][Child] =
              Sources[I].Bounds[Axis][Side][Child];
      // BARRIER: PlantedTracer.cpp:[[#@LINE+1]]
      Copy[I].Child[Child] = Sources[I].Child[Child];
    }
  Nodes = Copy;
}

namespace {

class RecursiveRayTracer {
public:
  explicit RecursiveRayTracer(const SceneView &Scene) : Scene(Scene) {}

  Hit findClosestHit(const Ray &R, float MaxDistance) {
    const RayTriangleTester Triangles(R);
    const RayBoxTester Boxes(R);
    Hit Found;
    Found.Distance = MaxDistance;
#ifndef FAULT_HIT_RECORD
    Found.Triangle = kNoTriangle;
#endif
    visit(Scene.Header->Root, Triangles, Boxes, Found);
    return Found;
  }

  bool isBlocked(const Ray &R, float MaxDistance) {
    // HIT: PlantedTracer.cpp:[[#@LINE+1]]
    return findClosestHit(R, MaxDistance).Triangle != kNoTriangle;
  }

private:
  [[gnu::noinline]] void visit(BvhReference Reference,
                               const RayTriangleTester &Triangles,
                               const RayBoxTester &Boxes, Hit &Found);

  const SceneView &Scene;
};

} // namespace

void RecursiveRayTracer::visit(BvhReference Reference,
                               const RayTriangleTester &Triangles,
                               const RayBoxTester &Boxes, Hit &Found) {
  // RECURSION: PlantedTracer.cpp:[[#@LINE-1]]
  if (isLeaf(Reference)) {
    const uint32_t First = leafFirst(Reference);
    for (uint32_t I = First; I != First + leafCount(Reference); ++I)
      Triangles.test<1>(reinterpret_cast<const char *>(Scene.Triangles + I),
                        sizeof(TriangleRecord), I, Found);
    return;
  }
  const WideBvhNode &Node = Nodes[Reference / sizeof(WideBvhNode)];
  ++Visits[threadId()];
#ifdef FAULT_STRAY_WRITE
  if (threadId() == 5 && Visits[5] == 20)
    // STRAY: PlantedTracer.cpp:[[#@LINE+1]]
    Nodes->Reserved[0] = Nodes->Child[1] = Visits[5];
#endif
#ifdef FAULT_RECURSION
  BoxDistances Kept[48] = {};
  asm volatile("" : : "r"(Kept) : "memory");
#endif
  const BoxDistances D =
      Boxes.test(reinterpret_cast<const char *>(&Node), Found.Distance);
  for (unsigned Child = 0; Child != kWideBvhWidth; ++Child)
    if (D.isHit(Child) && D.Enter[Child] <= Found.Distance)
      // RECURSION: #1 in {{.*}}PlantedTracer.cpp:[[#@LINE+1]]
      visit(Node.Child[Child], Triangles, Boxes, Found);
}

int main() {
  const LaunchBlock Launch = launchBlock();
  const SceneView Scene(devicePointer<const SceneHeader>(Launch.Scene));
  if (threadId() == 0) {
    Visits = new uint32_t[threadCount()]();
    copyTree(Scene);
  }
#ifndef FAULT_BARRIER
  barrier();
#endif
#ifdef FAULT_FREE
  // FREE: PlantedTracer.cpp:[[#@LINE+2]]
  if (threadId() == 0)
    delete[] Nodes;
#endif
  renderPixels(Launch, Scene, RecursiveRayTracer(Scene));
#ifndef FAULT_FREE
  if (threadId() == 0)
    delete[] Nodes;
#endif
  return 0;
}
