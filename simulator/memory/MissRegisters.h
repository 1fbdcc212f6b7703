//===- MissRegisters.h - Misses of a cache under way ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_MEMORY_MISSREGISTERS_H
#define TP_SIMULATOR_MEMORY_MISSREGISTERS_H

#include "simulator/core/Archive.h"
#include "simulator/memory/AccessPool.h"

#include <cstdint>
#include <vector>

namespace tp {

/// A sector that has been asked for and is not there yet.
struct MissRegister {
  /// Address / SectorBytes.
  uint32_t Sector = 0;
  /// In the list of its hash bucket, or of the free ones.
  uint32_t Next = NoIndex;
  /// Those whose answer is not known yet.
  AccessList Waiting;
  /// When the sector arrives, of the parts that are known; and who had it.
  uint64_t ArrivalCycle = 0;
  /// Accesses that joined, the first included.
  uint16_t Joined = 0;
  /// Parts that the next level has not answered yet; the arrival is known when
  /// there are none.
  uint16_t Remaining = 0;
  ServedBy Level = ServedBy::L1;
  /// Whether the sector will be dirty.
  bool Dirty = false;
};

/// The registers of a cache, found by the number of the sector.
class MissRegisters {
public:
  explicit MissRegisters(uint32_t Count);

  MissRegister &operator[](uint32_t Index) { return Registers[Index]; }
  bool isFull() const { return FirstFree == NoIndex; }

  /// The register of a sector, or NoIndex.
  uint32_t find(uint32_t Sector) const {
    uint32_t Index = Buckets[Sector & BucketMask];
    while (Index != NoIndex && Registers[Index].Sector != Sector)
      Index = Registers[Index].Next;
    return Index;
  }

  /// Takes a free register for a sector that has none.
  uint32_t take(uint32_t Sector);
  void release(uint32_t Index);

  void serialize(Archive &A) {
    A(Registers);
    A(Buckets);
    A(FirstFree);
  }

private:
  std::vector<MissRegister> Registers;
  std::vector<uint32_t> Buckets;
  uint32_t BucketMask;
  uint32_t FirstFree = 0;
};

} // namespace tp

#endif // TP_SIMULATOR_MEMORY_MISSREGISTERS_H
