//===- HeapBlocks.h - What the program has allocated ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHECK_HEAPBLOCKS_H
#define TP_SIMULATOR_CHECK_HEAPBLOCKS_H

#include "simulator/check/CallContexts.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace tp {

/// Memory that a program asked an allocator for.
struct HeapBlock {
  uint32_t Begin = 0;
  /// As asked for.
  uint32_t Bytes = 0;
  CodePlace AllocatedAt;
  /// Where it was given back; nothing while it is in use.
  std::optional<CodePlace> FreedAt;

  /// Where \p Address lies, such as "4 bytes behind a heap block of 40 bytes".
  std::string describe(uint32_t Address) const;
};

/// The blocks in use, and those given back whose memory nobody has got yet.
class HeapBlocks {
public:
  /// Forgets blocks whose memory it takes.
  void add(const HeapBlock &Block);
  /// The block that begins at \p Begin, or null.
  HeapBlock *at(uint32_t Begin);
  /// The block that holds \p Address or, if none does, that is next to it; null
  /// if there is none.
  const HeapBlock *nearest(uint32_t Address) const;
  /// The end of the last block; 0 if there is none.
  uint32_t end() const;

private:
  std::map<uint32_t, HeapBlock> Blocks;
};

} // namespace tp

#endif // TP_SIMULATOR_CHECK_HEAPBLOCKS_H
