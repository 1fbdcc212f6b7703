//===- MissRegisters.cpp - The misses of a cache under way ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/memory/MissRegisters.h"

#include <bit>

namespace tp {

MissRegisters::MissRegisters(uint32_t Count)
    : Registers(Count), Buckets(std::bit_ceil(Count) * size_t(2), NoIndex),
      BucketMask(uint32_t(Buckets.size()) - 1) {
  for (uint32_t Index = 0; Index + 1 != Count; ++Index)
    Registers[Index].Next = Index + 1;
}

uint32_t MissRegisters::take(uint32_t Sector) {
  uint32_t Index = FirstFree;
  FirstFree = Registers[Index].Next;
  uint32_t &Bucket = Buckets[Sector & BucketMask];
  Registers[Index] = MissRegister();
  Registers[Index].Sector = Sector;
  Registers[Index].Next = Bucket;
  Bucket = Index;
  return Index;
}

void MissRegisters::release(uint32_t Index) {
  uint32_t *Link = &Buckets[Registers[Index].Sector & BucketMask];
  while (*Link != Index)
    Link = &Registers[*Link].Next;
  *Link = Registers[Index].Next;
  Registers[Index].Next = FirstFree;
  FirstFree = Index;
}

} // namespace tp
