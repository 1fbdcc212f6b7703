//===- Streaming.cpp - All threads read through memory once ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Each load fetches a sector of 32 bytes that nobody has read, next to those of
// the neighbouring threads. Many are under way at once.
//
//===----------------------------------------------------------------------===//

#include "tp/thread.h"

using namespace tp;

namespace {
constexpr uint32_t SectorWords = 8;
constexpr uint32_t Sectors = 1 << 21;
constexpr uint32_t Unrolled = 2;
uint32_t Data[Sectors * SectorWords];
} // namespace

[[gnu::used]] uint32_t Results[8192];

int main() {
  const uint32_t Step = threadCount() * SectorWords;
  uint32_t Sum = 0;
  for (uint32_t Word = threadId() * SectorWords; Word < Sectors * SectorWords;
       Word += Unrolled * Step) {
    uint32_t Loaded[Unrolled];
#pragma clang loop unroll(full)
    for (uint32_t I = 0; I != Unrolled; ++I)
      Loaded[I] = static_cast<volatile uint32_t *>(Data)[Word + I * Step];
#pragma clang loop unroll(full)
    for (uint32_t I = 0; I != Unrolled; ++I)
      Sum += Loaded[I];
  }
  Results[threadId()] = Sum;
  return 0;
}
