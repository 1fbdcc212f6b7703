//===- Memory.h - The chip's global memory ----------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_MEMORY_H
#define TP_SIMULATOR_CORE_MEMORY_H

#include "runtime/include/tp/memory_map.h"
#include "simulator/core/Archive.h"

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace tp {

/// Zeroed pages of the host, taken from it only when they are touched.
class HostPages {
public:
  /// Empty if the host refuses.
  explicit HostPages(size_t Bytes);
  ~HostPages();
  HostPages(const HostPages &) = delete;
  HostPages &operator=(const HostPages &) = delete;

  uint8_t *data() const { return Pages; }
  size_t size() const { return Bytes; }

  /// The pages that are not all zeros.
  void serialize(Archive &A);

private:
  uint8_t *Pages = nullptr;
  size_t Bytes = 0;
};

/// The chip's global memory, [kGlobalMemoryBegin, size()), zero at the start,
/// as the host reads and writes it before and after a run.
class Memory {
public:
  /// \p Bytes is the chip's MemoryBytes.
  explicit Memory(uint64_t Bytes) : Pages(Bytes) {}

  /// False if the host has no room for it.
  bool isMapped() const { return Pages.data() != nullptr; }
  /// Host address of simulated address 0.
  uint8_t *data() { return Pages.data(); }
  const uint8_t *data() const { return Pages.data(); }
  uint64_t size() const { return Pages.size(); }
  void serialize(Archive &A) { Pages.serialize(A); }

  /// Whether all of [Address, Address + Bytes) is global memory.
  bool contains(uint32_t Address, uint64_t Bytes) const {
    return Address >= kGlobalMemoryBegin && Bytes <= size() &&
           Address <= size() - Bytes;
  }

  /// Copies into the memory; false, and nothing done, if out of range.
  bool write(uint32_t Address, const void *Source, uint64_t Bytes) {
    if (!contains(Address, Bytes))
      return false;
    std::memcpy(data() + Address, Source, Bytes);
    return true;
  }

  /// Copies out of the memory; false, and nothing done, if out of range.
  bool read(uint32_t Address, void *Destination, uint64_t Bytes) const {
    if (!contains(Address, Bytes))
      return false;
    std::memcpy(Destination, data() + Address, Bytes);
    return true;
  }

private:
  HostPages Pages;
};

} // namespace tp

#endif // TP_SIMULATOR_CORE_MEMORY_H
