//===- VerifyCache.cpp - Verdicts on caches with one fault each -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/treecache/TreeCache.h"
#include "kernels/treecache/TreeCacheChecker.h"

#include <stdio.h>

using namespace tp;

namespace {

using Cache = TreeCache<FullSlots>;

constexpr uint32_t SlotCount = 12;
constexpr uint32_t NodeCount = 2;
constexpr uint32_t TriangleCount = 9;

WideBvhNode Nodes[NodeCount];
TriangleRecord Triangles[TriangleCount];

constexpr uint32_t slot(uint32_t Number) { return Number * Cache::SlotBytes; }
constexpr uint32_t child(uint32_t Number, uint32_t Child) {
  return slot(Number) + FullSlots::ChildOffset + Child * 4;
}

/// Two nodes in the slots 0 and 1, five triangles in the slots 2 to 4, one
/// free slot, and slots that were never used.
struct Fixture {
  alignas(4) char Memory[Cache::bytesFor(SlotCount)];
  Cache Slots{Memory, SlotCount, 0};
  TreeCacheState State;
  TreeCacheSource Source{reinterpret_cast<const char *>(Nodes), NodeCount,
                         Triangles, TriangleCount, 0};
  TreeCachePath Path{child(1, 0), Pending, 1, 2};
  uint32_t Pending[2] = {child(0, 2), child(1, 1)};

  Fixture() {
    load(kRootWord);
    load(child(0, 0));
    load(child(0, 1));
    load(slot(2) + FullSlots::RestOffset);
    load(slot(3) + FullSlots::RestOffset);
    load(child(1, 1));
    Slots.unloadBranch(child(1, 1));
    State = treeCacheState(Slots);
  }
  void load(uint32_t Word) {
    // A leaf is loaded with its rest.
    if (!isLoaded(Slots.word(Word)))
      Slots.load({reinterpret_cast<const char *>(Nodes), Triangles}, Word,
               Slots.word(Word));
  }

  void say() {
    uint32_t Scratch[treeCacheVerifierWords(SlotCount)];
    char Sentence[200];
    State.RootWord = Slots.word(kRootWord);
    describeViolation(verifyTreeCache(treeCacheLayout<Cache>(), State, Source,
                                      &Path, Scratch),
                      Sentence, sizeof(Sentence));
    puts(Sentence);
  }
  void sayWith(uint32_t Word, uint32_t Value) {
    const uint32_t Good = Slots.word(Word);
    Slots.setWord(Word, Value);
    say();
    Slots.setWord(Word, Good);
  }
  /// With \p Field set to \p Value.
  void sayWith(uint32_t &Field, uint32_t Value, int) {
    const uint32_t Good = Field;
    Field = Value;
    say();
    Field = Good;
  }
};

} // namespace

int main() {
  Nodes[0].Child[0] = sizeof(WideBvhNode);
  Nodes[0].Child[1] = leafReference(0, 5);
  Nodes[0].Child[2] = leafReference(5, 1);
  Nodes[1].Child[0] = leafReference(6, 2);
  Nodes[1].Child[1] = leafReference(8, 1);
  static Fixture F;
  F.say();
  F.sayWith(F.State.Bytes, slot(SlotCount) - 1, 0);
  F.sayWith(F.State.UsedSlots, SlotCount + 1, 0);
  F.sayWith(F.State.FreeSlot, slot(6), 0);
  F.sayWith(slot(5) + FullSlots::ParentOffset, slot(5));
  F.sayWith(child(0, 0), innerLink(slot(6)));
  F.sayWith(child(0, 0), leafLink(slot(1)));
  F.sayWith(child(0, 2), leafReference(4, 1));
  F.sayWith(slot(4) + FullSlots::RestOffset, leafReference(5, 1));
  F.sayWith(child(0, 2), leafLink(slot(5)));
  F.sayWith(child(0, 2), leafLink(slot(2)));
  F.sayWith(slot(1) + FullSlots::ParentOffset, kRootWord);
  F.sayWith(slot(3) + FullSlots::SourceOffset, leafReference(2, 2));
  F.sayWith(F.Source.TriangleCount, 4, 0);
  F.sayWith(slot(1) + 8, 17);
  F.sayWith(slot(4) + kTriangleTestBytes - 4, 18);
  F.sayWith(F.State.FreeSlot, kNoSlot, 0);
  F.sayWith(F.Path.Word, child(5, 0), 0);
  F.sayWith(F.Pending[0], child(5, 0), 0);
  F.sayWith(F.Pending[1], slot(3) + FullSlots::RestOffset, 0);
  F.say();
  return 0;
}
