//===- BufferArchive.h - State in the host's memory -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_BUFFERARCHIVE_H
#define TP_SIMULATOR_CORE_BUFFERARCHIVE_H

#include "simulator/core/Archive.h"

#include <algorithm>
#include <cstring>
#include <span>
#include <vector>

namespace tp {

/// Collects state.
class SavingArchive final : public Archive {
public:
  bool isRestoring() const override { return false; }
  void bytes(void *Data, size_t Bytes) override {
    auto *Begin = static_cast<const uint8_t *>(Data);
    Collected.insert(Collected.end(), Begin, Begin + Bytes);
  }
  uint64_t remaining() const override { return ~uint64_t(0); }

  const std::vector<uint8_t> &collected() const { return Collected; }

private:
  std::vector<uint8_t> Collected;
};

/// Gives back what a SavingArchive has collected.
class RestoringArchive final : public Archive {
public:
  /// \p State must outlive it.
  explicit RestoringArchive(std::span<const uint8_t> State) : Rest(State) {}

  bool isRestoring() const override { return true; }
  void bytes(void *Data, size_t Bytes) override {
    if (Bytes == 0)
      return;
    size_t Known = std::min(Bytes, Rest.size());
    std::memcpy(Data, Rest.data(), Known);
    std::memset(static_cast<uint8_t *>(Data) + Known, 0, Bytes - Known);
    Rest = Rest.subspan(Known);
    EndedEarly |= Known != Bytes;
  }
  uint64_t remaining() const override { return Rest.size(); }

  /// Whether all was there, and nothing else.
  bool isComplete() const { return !EndedEarly && Rest.empty(); }

private:
  std::span<const uint8_t> Rest;
  bool EndedEarly = false;
};

} // namespace tp

#endif // TP_SIMULATOR_CORE_BUFFERARCHIVE_H
