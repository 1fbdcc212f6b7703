//===- HeapBlocks.cpp - What the program has allocated --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/check/HeapBlocks.h"

#include "simulator/check/ObjectPlace.h"

#include <iterator>

namespace tp {

std::string HeapBlock::describe(uint32_t Address) const {
  return describePlace(Address, Begin, Bytes, "a heap block") +
         (FreedAt ? " that was given back" : "");
}

void HeapBlocks::add(const HeapBlock &Block) {
  auto First = Blocks.lower_bound(Block.Begin);
  if (First != Blocks.begin()) {
    auto Before = std::prev(First);
    if (Block.Begin - Before->first < Before->second.Bytes)
      First = Before;
  }
  auto Last = First;
  while (Last != Blocks.end() && (Last->first <= Block.Begin ||
                                  Last->first - Block.Begin < Block.Bytes))
    ++Last;
  Blocks.erase(First, Last);
  Blocks[Block.Begin] = Block;
}

HeapBlock *HeapBlocks::at(uint32_t Begin) {
  auto Found = Blocks.find(Begin);
  return Found == Blocks.end() ? nullptr : &Found->second;
}

const HeapBlock *HeapBlocks::nearest(uint32_t Address) const {
  auto Behind = Blocks.upper_bound(Address);
  if (Behind == Blocks.begin())
    return Behind == Blocks.end() ? nullptr : &Behind->second;
  const HeapBlock &Before = std::prev(Behind)->second;
  if (Behind == Blocks.end() || Address - Before.Begin < Before.Bytes)
    return &Before;
  uint32_t Distance = Address - Before.Begin - Before.Bytes;
  return Distance <= Behind->first - Address ? &Before : &Behind->second;
}

uint32_t HeapBlocks::end() const {
  if (Blocks.empty())
    return 0;
  const HeapBlock &Last = std::prev(Blocks.end())->second;
  return Last.Begin + Last.Bytes;
}

} // namespace tp
