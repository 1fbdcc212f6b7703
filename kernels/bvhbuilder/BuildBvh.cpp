//===- BuildBvh.cpp - Builds a scene's tree -------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Builds the tree of the scene, and nothing else: tpsim and the native runner
// verify it and write it to a file (--bvh kernel --bvh-output FILE).
//
//===----------------------------------------------------------------------===//

#include "kernels/bvhbuilder/SceneBvh.h"
#include "tp/launch.h"
#include "tp/memory.h"

int main() {
  const tp::LaunchBlock Launch = tp::launchBlock();
  if (!tp::buildSceneBvh(tp::devicePointer<void>(Launch.Scene)))
    return 1;
  return 0;
}
