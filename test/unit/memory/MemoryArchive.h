//===- MemoryArchive.h - A checkpoint in memory -----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_TEST_UNIT_MEMORY_MEMORYARCHIVE_H
#define TP_TEST_UNIT_MEMORY_MEMORYARCHIVE_H

#include "simulator/core/Archive.h"

#include "gtest/gtest.h"

#include <cstring>
#include <utility>
#include <vector>

namespace tp {

class SavingArchive final : public Archive {
public:
  bool isRestoring() const override { return false; }
  uint64_t remaining() const override { return 0; }
  void bytes(void *Data, size_t Count) override {
    const char *Begin = static_cast<const char *>(Data);
    Saved.insert(Saved.end(), Begin, Begin + Count);
  }
  std::vector<char> Saved;
};

class RestoringArchive final : public Archive {
public:
  explicit RestoringArchive(std::vector<char> Saved)
      : Saved(std::move(Saved)) {}
  bool isRestoring() const override { return true; }
  uint64_t remaining() const override { return Saved.size() - Read; }
  void bytes(void *Data, size_t Count) override {
    ASSERT_LE(Count, remaining());
    std::memcpy(Data, Saved.data() + Read, Count);
    Read += Count;
  }

private:
  std::vector<char> Saved;
  size_t Read = 0;
};

/// Makes \p To, of the same configuration, what \p From is.
template <class T> void copyThroughCheckpoint(T &From, T &To) {
  SavingArchive Save;
  From.serialize(Save);
  RestoringArchive Restore(std::move(Save.Saved));
  To.serialize(Restore);
  EXPECT_EQ(Restore.remaining(), 0u);
}

} // namespace tp

#endif // TP_TEST_UNIT_MEMORY_MEMORYARCHIVE_H
