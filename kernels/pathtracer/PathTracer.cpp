//===- PathTracer.cpp - The baseline path tracer as a program -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/pathtracer/MemoryRayTracer.h"

int main() {
  const tp::LaunchBlock Launch = tp::launchBlock();
  tp::renderPixelsFromMemory(Launch);
  return 0;
}
