//===- Relaxation.cpp - Steps of a grid between barriers ------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Each cell becomes the mean of its neighbours; the threads share the rows and
// meet after each step. Also without any simulator's help the result is the
// same for every number of threads.
//
//===----------------------------------------------------------------------===//

#include "tp/barrier.h"
#include "tp/thread.h"

using namespace tp;

namespace {
constexpr uint32_t Width = 64, Height = 64, Steps = 4;
float Other[Width * Height];
} // namespace

[[gnu::used]] float Results[Width * Height];

static void relax(const float *From, float *To) {
  for (uint32_t Cell = threadId(); Cell < Width * Height;
       Cell += threadCount()) {
    const uint32_t X = Cell % Width, Y = Cell / Width;
    const bool IsEdge = X == 0 || Y == 0 || X == Width - 1 || Y == Height - 1;
    To[Cell] = IsEdge ? From[Cell]
                      : 0.25f * (From[Cell - 1] + From[Cell + 1] +
                                 From[Cell - Width] + From[Cell + Width]);
  }
  barrier();
}

int main() {
  for (uint32_t Cell = threadId(); Cell < Width * Height; Cell += threadCount())
    Results[Cell] = static_cast<float>(Cell * 2654435761u >> 20);
  barrier();
  for (uint32_t Step = 0; Step != Steps; ++Step) {
    relax(Results, Other);
    relax(Other, Results);
  }
  return 0;
}
