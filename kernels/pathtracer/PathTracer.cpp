//===- PathTracer.cpp - The baseline path tracer as a program -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
//   -DTP_NODE_FORMAT=<class>    the nodes that rays traverse: FullNodes or
//                               QuantizedNodes (FullNodes)
//
//===----------------------------------------------------------------------===//

#include "kernels/bvh/QuantizedNodes.h"
#include "kernels/common/EarlyLoad.h"
#include "kernels/pathtracer/MemoryRayTracer.h"

#ifndef TP_NODE_FORMAT
#define TP_NODE_FORMAT FullNodes
#endif

int main() {
  const tp::LaunchBlock Launch = tp::loadTogether(tp::launchBlock());
  tp::renderPixelsFromMemory<tp::TP_NODE_FORMAT>(Launch);
  return 0;
}
