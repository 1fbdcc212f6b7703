//===- CacheMirror.cpp - A thread's cache as its events tell it -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/profile/CacheMirror.h"

#include "kernels/treecache/SlotFormat.h"

#include <algorithm>

namespace tp {

Contradiction CacheMirror::check(const CacheShape &Shape) {
  if (Shape.Slots == 0 || Shape.Slots > MaxSlots)
    return "the cache does not have 1 to 65535 slots";
  if (Shape.SlotTriangles == 0 ||
      Shape.SlotTriangles * kTriangleTestBytes + 4 > Shape.SlotBytes)
    return "the triangles of a leaf do not fit into a slot";
  if (Shape.SlotBytes % 4 != 0 || Shape.ChildOffset % 4 != 0 ||
      Shape.ChildOffset + 4 * kWideBvhWidth > Shape.SlotBytes)
    return "the links of a node do not fit into a slot";
  return nullptr;
}

CacheMirror::CacheMirror(const CacheShape &Shape)
    : Shape(Shape), Slots(Shape.Slots) {}

std::optional<uint16_t> CacheMirror::slotAt(uint32_t Offset) const {
  const uint32_t Number = Offset / Shape.SlotBytes;
  if (Offset % Shape.SlotBytes != 0 || Number >= Shape.Slots)
    return std::nullopt;
  return static_cast<uint16_t>(Number);
}

std::optional<CacheMirror::Place> CacheMirror::placeOf(uint32_t Word) const {
  const uint32_t Number = Word / Shape.SlotBytes;
  const uint32_t Offset = Word % Shape.SlotBytes;
  if (Number >= Shape.Slots || Slots[Number].Is == Slot::Free)
    return std::nullopt;
  const auto Holder = static_cast<uint16_t>(Number);
  if (Slots[Number].Is == Slot::Leaf) {
    if (Offset != Shape.SlotTriangles * kTriangleTestBytes)
      return std::nullopt;
    return Place{Holder, 0};
  }
  const uint32_t Position = (Offset - Shape.ChildOffset) / 4;
  if (Offset % 4 != 0 || Position >= kWideBvhWidth)
    return std::nullopt;
  return Place{Holder, static_cast<uint8_t>(Position)};
}

uint16_t *CacheMirror::pointerAt(uint32_t Word) {
  if (Word == kRootWord)
    return &Root;
  const std::optional<Place> Found = placeOf(Word);
  return Found ? &Slots[Found->Slot].Children[Found->Position] : nullptr;
}

uint32_t CacheMirror::trianglesIn(const Slot &S) const {
  return std::min(leafCount(S.Source), Shape.SlotTriangles);
}

BvhReference CacheMirror::restOf(const Slot &S) const {
  const uint32_t Count = leafCount(S.Source);
  if (Count <= Shape.SlotTriangles)
    return kNoRest;
  return leafReference(leafFirst(S.Source) + Shape.SlotTriangles,
                       Count - Shape.SlotTriangles);
}

Contradiction CacheMirror::load(BvhReference From, uint32_t ParentWord,
                                CacheLink Into) {
  if (!isLoaded(Into))
    return "the link of a load does not name a slot";
  if (isLoadedLeaf(Into) != isLeaf(From))
    return "a leaf is loaded as an inner node, or the reverse";
  const std::optional<uint16_t> Number = slotAt(linkedSlot(Into));
  if (!Number)
    return "a load goes to where no slot begins";
  if (Slots[*Number].Is != Slot::Free)
    return "a load goes to a slot that is in use";
  uint16_t *const Pointer = pointerAt(ParentWord);
  if (!Pointer)
    return "the word that names a loaded slot is no link of a slot in use";
  if (*Pointer != None)
    return "the word that names a loaded slot named another one before";

  Slot Loaded;
  Loaded.Source = From;
  Loaded.Is = isLeaf(From) ? Slot::Leaf : Slot::Inner;
  if (ParentWord != kRootWord) {
    const std::optional<Place> Above = placeOf(ParentWord);
    if (!Above)
      return "no slot in use holds the word that names the loaded slot";
    const Slot &Holder = Slots[Above->Slot];
    if (Holder.Is == Slot::Leaf && restOf(Holder) != From)
      return "the loaded part of a leaf is not the rest of the part above it";
    Loaded.Parent = Above->Slot;
    Loaded.Position = Above->Position;
    Loaded.Depth = static_cast<uint16_t>(Holder.Depth + 1);
  }
  *Pointer = *Number;
  Slots[*Number] = Loaded;
  ++Used;
  return nullptr;
}

Contradiction CacheMirror::visit(CacheLink Link) const {
  if (!isLoaded(Link))
    return "the link of a visit does not name a slot";
  const std::optional<uint16_t> Number = slotAt(linkedSlot(Link));
  if (!Number)
    return "a visit is to where no slot begins";
  const Slot &S = Slots[*Number];
  if (S.Is == Slot::Free)
    return "a visit is to a slot that is not loaded";
  if (isLoadedLeaf(Link) != (S.Is == Slot::Leaf))
    return "a leaf is visited as an inner node, or the reverse";
  return nullptr;
}

uint32_t CacheMirror::branchSize(uint16_t Branch) const {
  uint32_t Size = 0;
  std::vector<uint16_t> ToVisit = {Branch};
  while (!ToVisit.empty()) {
    const Slot &S = Slots[ToVisit.back()];
    ToVisit.pop_back();
    ++Size;
    for (const uint16_t Child : S.Children)
      if (Child != None)
        ToVisit.push_back(Child);
  }
  return Size;
}

Contradiction CacheMirror::beginDeletion(uint32_t Word) {
  uint16_t *const Pointer = pointerAt(Word);
  if (!Pointer)
    return "the word that names a deleted branch is no link of a slot in use";
  if (*Pointer == None)
    return "the word that names a deleted branch does not name a slot";
  Top = *Pointer;
  *Pointer = None;
  ToFree = branchSize(Top);
  Freed = 0;
  return nullptr;
}

/// Slots that this deletion has freed still know their parent.
bool CacheMirror::isInDeletedBranch(uint16_t Number) const {
  while (Number != Top && Number != None)
    Number = Slots[Number].Parent;
  return Number == Top;
}

Contradiction CacheMirror::freeSlot(uint32_t Offset) {
  const std::optional<uint16_t> Number = slotAt(Offset);
  if (!Number)
    return "what a deletion frees is no slot";
  if (Slots[*Number].Is == Slot::Free)
    return "a deletion frees a slot that is free";
  if (!isInDeletedBranch(*Number))
    return "a deletion frees a slot outside the deleted branch";
  Slots[*Number].Is = Slot::Free;
  ++Freed;
  --Used;
  return nullptr;
}

Contradiction CacheMirror::endDeletion(uint32_t Count) {
  if (Count != Freed)
    return "a deletion says another number of slots than it has freed";
  if (Freed != ToFree)
    return "a deletion leaves slots of the deleted branch";
  Top = None;
  return nullptr;
}

std::vector<uint16_t> CacheMirror::pathTo(uint32_t Word) const {
  std::vector<uint16_t> Path;
  if (const std::optional<Place> Found = placeOf(Word))
    for (uint16_t Number = Found->Slot; Number != None;
         Number = Slots[Number].Parent)
      Path.push_back(Number);
  std::reverse(Path.begin(), Path.end());
  return Path;
}

} // namespace tp
