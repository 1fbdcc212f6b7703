//===- QuantizeNodes.cpp - Quantizes random nodes and prints them ---------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/bvh/QuantizedBoxTester.h"
#include "kernels/bvh/QuantizedBvh.h"
#include "kernels/common/Random.h"

#include <stdio.h>

using namespace tp;

static constexpr float Largest = 100.0f;

/// From -1 to 1.
static float signedUnit(uint32_t Word) { return 2.0f * unitFloat(Word) - 1.0f; }

static WideBvhNode makeNode(uint32_t Number) {
  WideBvhNode Node = {};
  for (uint32_t Axis = 0; Axis != 3; ++Axis)
    for (uint32_t Child = 0; Child != kWideBvhWidth; ++Child) {
      const RandomWords Random = randomWords(Number, Axis, Child, 1);
      const bool Missing = Child == 3 && Number % 3 == 0;
      const float Lower = Largest * signedUnit(Random.X);
      const float Size = unitFloat(Random.Y) * 0.25f;
      Node.Bounds[Axis][0][Child] = Missing ? 1e20f : Lower;
      Node.Bounds[Axis][1][Child] = Missing ? -1e20f : Lower - Lower * Size;
      if (Lower < 0.0f || Missing)
        continue;
      Node.Bounds[Axis][0][Child] = Lower - Lower * Size;
      Node.Bounds[Axis][1][Child] = Lower;
    }
  return Node;
}

static void printWords(const void *Words, uint32_t Count) {
  for (uint32_t I = 0; I != Count; ++I)
    printf(" %08x", static_cast<unsigned>(
                        static_cast<const uint32_t *>(Words)[I]));
  printf("\n");
}

int main() {
  for (uint32_t Number = 0; Number != 20; ++Number) {
    const WideBvhNode Node = makeNode(Number);
    QuantizedBvhNode Quantized;
    quantizeBvh({&Node, 1, Largest, &Quantized});
    printf("node");
    printWords(&Quantized, sizeof(Quantized) / 4);
    const RandomWords From = randomWords(Number, 9, 9, 1);
    const RandomWords To = randomWords(Number, 9, 10, 1);
    const Ray R = {{Largest * signedUnit(From.X), Largest * signedUnit(From.Y),
                    Largest * signedUnit(From.Z)},
                   {signedUnit(To.X), signedUnit(To.Y), signedUnit(To.Z)}};
    const BoxDistances D = QuantizedBoxTester(R).test(
        reinterpret_cast<const char *>(&Quantized), 1000.0f);
    printf("ray");
    printWords(&D, sizeof(D) / 4);
  }
  return 0;
}
