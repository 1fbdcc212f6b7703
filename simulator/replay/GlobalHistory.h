//===- GlobalHistory.h - Global memory that can go back ---------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_REPLAY_GLOBALHISTORY_H
#define TP_SIMULATOR_REPLAY_GLOBALHISTORY_H

#include "simulator/core/EngineObservers.h"
#include "simulator/core/Memory.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

namespace tp {

/// Who wrote last to a word.
struct WordWriter {
  uint64_t Cycle : 60 = 0;
  /// The bytes of the word that it wrote, one bit each; 0: nobody wrote.
  uint64_t Bytes : 4 = 0;
  uint32_t Thread = 0;
  uint32_t Pc = 0;
};
static_assert(sizeof(WordWriter) == 16, "there is one for each word");

/// The pages of global memory that differ between two moments, with their
/// contents at one of the two, and who wrote them last there.
class MemoryLayer {
public:
  static constexpr uint32_t PageBytes = 4096;
  using PageWriters = std::array<WordWriter, PageBytes / 4>;
  struct Page {
    std::array<uint8_t, PageBytes> Contents;
    /// Null if nobody has written to it.
    std::unique_ptr<PageWriters> Writers;
  };

  /// Bytes of host memory.
  uint64_t bytes() const;
  /// Takes the pages of \p Other that it does not have.
  void add(MemoryLayer &&Other);

private:
  friend class GlobalHistory;
  std::unordered_map<uint32_t, Page> Pages;
};

/// Observes the writes to global memory, keeps what they overwrite, and who
/// wrote each word last.
class GlobalHistory final : public CommitObserver {
public:
  /// \p Global must outlive it.
  explicit GlobalHistory(Memory &Global)
      : Global(Global), Writers(Global.size() / MemoryLayer::PageBytes + 1),
        SavedIn(Writers.size()) {}

  void writing(const GlobalWrite &Write) override;
  /// Before the user changes these bytes of the memory.
  void changing(uint32_t Address, uint32_t Bytes);

  /// From here on keeps what \p Thread writes, for takeWrites().
  void keepWrites(uint32_t Thread) { KeptThread = Thread; }
  /// What it has written since then; no longer keeps it.
  std::vector<GlobalWrite> takeWrites();

  /// From here on, what changes is kept in a new open layer, above the others.
  void open();
  size_t numOpen() const { return Open.size(); }
  /// Memory is again as when the last open layer was opened; it stays open.
  void undo();
  /// The last open layer becomes part of the one below.
  void merge();
  /// Closes the only open layer: the contents at its opening.
  MemoryLayer close();
  /// Exchanges the pages of \p Layer with those of the memory.
  void swap(MemoryLayer &Layer);

  /// Those who wrote last to one of the bytes, all in one cycle; empty if
  /// nobody did. Nothing if a word's last writer wrote only others of its
  /// bytes, so that it is not known.
  std::optional<std::vector<WordWriter>> lastWriters(uint32_t Address,
                                                     uint32_t Bytes) const;
  /// Bytes of host memory of open layers and writers.
  uint64_t bytes() const;

private:
  void save(uint32_t Page);

  Memory &Global;
  std::vector<std::unique_ptr<MemoryLayer::PageWriters>> Writers;
  std::vector<MemoryLayer> Open;
  /// A layer that surely has the page: its serial number.
  std::vector<uint64_t> SavedIn;
  uint64_t Serial = 0;
  std::optional<uint32_t> KeptThread;
  std::vector<GlobalWrite> KeptWrites;
};

} // namespace tp

#endif // TP_SIMULATOR_REPLAY_GLOBALHISTORY_H
