//===- BuildAndTrace.cpp - Builds the tree, then renders ------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The path tracer on a tree that was built on the spot (--bvh kernel).
//
//===----------------------------------------------------------------------===//

#include "kernels/bvhbuilder/SceneBvh.h"
#include "kernels/pathtracer/MemoryRayTracer.h"
#include "tp/launch.h"
#include "tp/memory.h"

int main() {
  const tp::LaunchBlock Launch = tp::launchBlock();
  if (!tp::buildSceneBvh(tp::devicePointer<void>(Launch.Scene)))
    return 1;
  tp::renderPixelsFromMemory(Launch);
  return 0;
}
