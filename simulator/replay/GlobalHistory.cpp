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

void GlobalHistory::writing(const GlobalWrite &Write) {
  uint64_t At = Write.Address;
  const uint64_t End = At + Write.Bytes;
  while (At != End) {
    const auto Number = uint32_t(At / MemoryLayer::PageBytes);
    save(Number);
    if (!Writers[Number])
      Writers[Number] = std::make_unique<MemoryLayer::PageWriters>();
    const uint64_t WordEnd = std::min(End, At / 4 * 4 + 4);
    const auto Mask = uint8_t(((1u << (WordEnd - At)) - 1) << (At % 4));
    (*Writers[Number])[At % MemoryLayer::PageBytes / 4] = {
        Write.Cycle, Write.Thread, Write.Pc, Mask};
    At = WordEnd;
  }
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

std::optional<WordWriter> GlobalHistory::lastWriter(uint32_t Address,
                                                    uint32_t Bytes) const {
  WordWriter Last;
  const uint64_t End = uint64_t(Address) + Bytes;
  for (uint64_t At = Address; At != End;) {
    const uint64_t WordEnd = std::min(End, At / 4 * 4 + 4);
    const auto Mask = uint8_t(((1u << (WordEnd - At)) - 1) << (At % 4));
    const auto &Page = Writers[At / MemoryLayer::PageBytes];
    const WordWriter Writer =
        Page ? (*Page)[At % MemoryLayer::PageBytes / 4] : WordWriter();
    At = WordEnd;
    if (Writer.Thread == WordWriter::Nobody)
      continue;
    if ((Writer.Bytes & Mask) == 0)
      return std::nullopt;
    if (Last.Thread == WordWriter::Nobody || Writer.Cycle > Last.Cycle)
      Last = Writer;
  }
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
