//===- GlobalHistory.cpp - Global memory that can go back -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/replay/GlobalHistory.h"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <utility>

namespace tp {

uint64_t MemoryLayer::bytes() const {
  uint64_t Sum = 0;
  for (const auto &[Number, Saved] : Pages)
    Sum += sizeof(Saved) + (Saved.Writers ? sizeof(PageWriters) : 0);
  return Sum;
}

void MemoryLayer::add(MemoryLayer &&Other) {
  for (auto &[Number, Saved] : Other.Pages)
    Pages.try_emplace(Number, std::move(Saved));
}

void GlobalHistory::save(uint32_t Number) {
  if (Open.empty() || SavedIn[Number] == Serial)
    return;
  SavedIn[Number] = Serial;
  auto [Place, IsNew] = Open.back().Pages.try_emplace(Number);
  if (!IsNew)
    return;
  MemoryLayer::Page &Saved = Place->second;
  const uint64_t Begin = uint64_t(Number) * MemoryLayer::PageBytes;
  const uint64_t Size =
      std::min<uint64_t>(MemoryLayer::PageBytes, Global.size() - Begin);
  std::memcpy(Saved.Contents.data(), Global.data() + Begin, Size);
  if (Writers[Number])
    Saved.Writers =
        std::make_unique<MemoryLayer::PageWriters>(*Writers[Number]);
}

/// Calls \p Function(page, number of a word in it, bytes of the word) for each
/// word that has some of the bytes [At, End).
template <class Callable>
static void forEachWord(uint64_t At, uint64_t End, Callable Function) {
  while (At < End) {
    const uint64_t WordEnd = std::min(End, At / 4 * 4 + 4);
    const auto Mask = uint8_t(((1u << (WordEnd - At)) - 1) << (At % 4));
    Function(uint32_t(At / MemoryLayer::PageBytes),
             uint32_t(At % MemoryLayer::PageBytes / 4), Mask);
    At = WordEnd;
  }
}

void GlobalHistory::writing(const GlobalWrite &Write) {
  if (KeptThread == Write.Thread)
    KeptWrites.push_back(Write);
  forEachWord(Write.Address, uint64_t(Write.Address) + Write.Bytes,
              [&](uint32_t Page, uint32_t Word, uint8_t Mask) {
                save(Page);
                if (!Writers[Page])
                  Writers[Page] = std::make_unique<MemoryLayer::PageWriters>();
                (*Writers[Page])[Word] = {Write.Cycle, Mask, Write.Thread,
                                          Write.Pc};
              });
}

void GlobalHistory::changing(uint32_t Address, uint32_t Bytes) {
  const uint32_t Last = (Address + Bytes - 1) / MemoryLayer::PageBytes;
  for (uint32_t Page = Address / MemoryLayer::PageBytes; Page <= Last; ++Page)
    save(Page);
}

std::vector<GlobalWrite> GlobalHistory::takeWrites() {
  KeptThread.reset();
  return std::exchange(KeptWrites, {});
}

void GlobalHistory::open() {
  Open.emplace_back();
  ++Serial;
}

void GlobalHistory::undo() {
  swap(Open.back());
  Open.back().Pages.clear();
}

void GlobalHistory::merge() {
  assert(Open.size() > 1 && "nothing below");
  MemoryLayer Top = std::move(Open.back());
  Open.pop_back();
  Open.back().add(std::move(Top));
  ++Serial;
}

MemoryLayer GlobalHistory::close() {
  assert(Open.size() == 1 && "not the only one");
  MemoryLayer Top = std::move(Open.back());
  Open.pop_back();
  ++Serial;
  return Top;
}

void GlobalHistory::swap(MemoryLayer &Layer) {
  for (auto &[Number, Saved] : Layer.Pages) {
    const uint64_t Begin = uint64_t(Number) * MemoryLayer::PageBytes;
    const uint64_t Size =
        std::min<uint64_t>(MemoryLayer::PageBytes, Global.size() - Begin);
    std::swap_ranges(Saved.Contents.data(), Saved.Contents.data() + Size,
                     Global.data() + Begin);
    std::swap(Saved.Writers, Writers[Number]);
  }
  ++Serial;
}

std::optional<std::vector<WordWriter>>
GlobalHistory::lastWriters(uint32_t Address, uint32_t Bytes) const {
  std::vector<WordWriter> Last;
  bool AreKnown = true;
  const uint64_t End = std::min(uint64_t(Address) + Bytes, Global.size());
  forEachWord(Address, End, [&](uint32_t Page, uint32_t Word, uint8_t Mask) {
    const WordWriter Writer =
        Writers[Page] ? (*Writers[Page])[Word] : WordWriter();
    if (Writer.Bytes == 0)
      return;
    AreKnown &= (Writer.Bytes & Mask) != 0;
    if (!Last.empty() && Writer.Cycle > Last.front().Cycle)
      Last.clear();
    if (Last.empty() || Writer.Cycle == Last.front().Cycle)
      Last.push_back(Writer);
  });
  if (!AreKnown)
    return std::nullopt;
  return Last;
}

uint64_t GlobalHistory::bytes() const {
  uint64_t Sum = 0;
  for (const MemoryLayer &Layer : Open)
    Sum += Layer.bytes();
  for (const auto &Page : Writers)
    Sum += Page ? sizeof(*Page) : 0;
  return Sum;
}

} // namespace tp
