//===- StreamAccess.h - Rings of words in memory ----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// A stream is a descriptor of four words {words popped, words pushed, capacity
// (a power of two), reserved} with its ring of `capacity` words behind it.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_ISA_STREAMACCESS_H
#define TP_SIMULATOR_ISA_STREAMACCESS_H

#include <bit>
#include <cstdint>

namespace tp {

/// Behind them are the stream's words.
inline constexpr uint32_t StreamDescriptorBytes = 16;

/// What a pop of an empty stream gives.
inline constexpr uint32_t EmptyStreamValue = 0xFFFFFFFF;

/// Memory as stream operations see it while they have it for themselves.
class StreamMemory {
public:
  virtual ~StreamMemory() = default;
  /// The word at an address; 0 once an access has failed.
  virtual uint32_t load(uint32_t Address) = 0;
  virtual void store(uint32_t Address, uint32_t Value) = 0;
  /// The descriptor makes no stream: the instruction traps.
  virtual void reject() = 0;
};

/// Address of the word with running number \p Index in the ring; rejects a
/// capacity that is no power of two.
inline uint32_t streamWord(StreamMemory &Memory, uint32_t Descriptor,
                           uint32_t Index) {
  uint32_t Capacity = Memory.load(Descriptor + 8);
  if (!std::has_single_bit(Capacity))
    Memory.reject();
  return Descriptor + StreamDescriptorBytes + (Index & (Capacity - 1)) * 4;
}

} // namespace tp

#endif // TP_SIMULATOR_ISA_STREAMACCESS_H
