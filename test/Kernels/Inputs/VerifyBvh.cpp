//===- VerifyBvh.cpp - Verifies a tree on the chip ------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Builds the tree of a row of boxes, verifies it, breaks it, verifies again.
//
//===----------------------------------------------------------------------===//

#include "kernels/bvh/BvhVerifier.h"

#include <stdio.h>

using namespace tp;

static constexpr uint32_t Count = 100;
static BoundingBox Boxes[Count];
static uint32_t Order[Count];
static BvhNode Nodes[Count];
static uint32_t Scratch[bvhVerifierWords(Count, Count)];

static void report(const BvhStorage &Storage, BvhReference Root) {
  const BvhFindings Findings = verifyBvh(Storage, Root, Scratch);
  char Sentence[160];
  describeViolation(Findings.First, Sentence, sizeof(Sentence));
  printf("%s; %u lost, %u repeated\n", Sentence,
         unsigned(Findings.LostPrimitives),
         unsigned(Findings.RepeatedPrimitives));
}

int main() {
  for (uint32_t Number = 0; Number != Count; ++Number) {
    const float Place = static_cast<float>(Number);
    Boxes[Number] = {{Place, 0, 0}, {Place + 1, 1, 1}};
  }
  BvhStorage Storage{Boxes, Count, Order, Nodes, 0};
  const BvhReference Root = buildBvh(Storage);
  report(Storage, Root);
  Order[7] = Order[6];
  report(Storage, Root);
  return 0;
}
