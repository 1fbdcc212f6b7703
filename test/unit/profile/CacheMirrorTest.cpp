//===- CacheMirrorTest.cpp - Contradictions of a cache's events -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/profile/CacheMirror.h"
#include "kernels/treecache/SlotFormat.h"

#include "gtest/gtest.h"

using namespace tp;

namespace {

constexpr CacheShape Shape = {6, 120, 2, 96};

constexpr uint32_t offset(uint32_t Slot) { return Slot * Shape.SlotBytes; }
constexpr uint32_t childWord(uint32_t Slot, uint32_t Child) {
  return offset(Slot) + Shape.ChildOffset + 4 * Child;
}
constexpr uint32_t restWord(uint32_t Slot) {
  return offset(Slot) + Shape.SlotTriangles * kTriangleTestBytes;
}

/// The root in slot 0, below it an inner node in slot 1 and a leaf of five
/// triangles, whose two first parts are in slots 2 and 3.
class CacheMirrorTest : public testing::Test {
protected:
  CacheMirrorTest() {
    EXPECT_EQ(Mirror.load(0, kRootWord, innerLink(offset(0))), nullptr);
    EXPECT_EQ(Mirror.load(0x80, childWord(0, 2), innerLink(offset(1))),
              nullptr);
    EXPECT_EQ(
        Mirror.load(leafReference(10, 5), childWord(1, 3), leafLink(offset(2))),
        nullptr);
    EXPECT_EQ(
        Mirror.load(leafReference(12, 3), restWord(2), leafLink(offset(3))),
        nullptr);
  }

  CacheMirror Mirror{Shape};
};

} // namespace

TEST_F(CacheMirrorTest, KnowsTheTree) {
  EXPECT_EQ(Mirror.usedSlots(), 4u);
  EXPECT_EQ(Mirror.slots()[3].Depth, 3u);
  EXPECT_EQ(Mirror.slots()[2].Parent, 1u);
  EXPECT_EQ(Mirror.slots()[1].Children[3], 2u);
  EXPECT_EQ(Mirror.trianglesIn(Mirror.slots()[3]), 2u);
  EXPECT_EQ(Mirror.restOf(Mirror.slots()[3]), leafReference(14, 1));
  EXPECT_EQ(Mirror.pathTo(restWord(2)), (std::vector<uint16_t>{0, 1, 2}));
  EXPECT_TRUE(Mirror.pathTo(kRootWord).empty());
}

TEST_F(CacheMirrorTest, DeletesABranchInAnyOrder) {
  EXPECT_EQ(Mirror.beginDeletion(childWord(0, 2)), nullptr);
  for (uint32_t Slot : {2, 1, 3})
    EXPECT_EQ(Mirror.freeSlot(offset(Slot)), nullptr);
  EXPECT_EQ(Mirror.endDeletion(3), nullptr);
  EXPECT_EQ(Mirror.usedSlots(), 1u);
  EXPECT_NE(Mirror.visit(innerLink(offset(1))), nullptr);
  EXPECT_EQ(Mirror.load(0x80, childWord(0, 2), innerLink(offset(3))), nullptr);
}

TEST_F(CacheMirrorTest, DeletesTheRoot) {
  EXPECT_EQ(Mirror.beginDeletion(kRootWord), nullptr);
  for (uint32_t Slot : {0, 1, 2, 3})
    EXPECT_EQ(Mirror.freeSlot(offset(Slot)), nullptr);
  EXPECT_EQ(Mirror.endDeletion(4), nullptr);
  EXPECT_EQ(Mirror.load(0, kRootWord, innerLink(offset(5))), nullptr);
}

TEST_F(CacheMirrorTest, RefusesBadLoads) {
  const uint32_t Word = childWord(0, 1);
  EXPECT_STREQ(Mirror.load(0x100, Word, 0x100),
               "the link of a load does not name a slot");
  EXPECT_STREQ(Mirror.load(0x100, Word, leafLink(offset(4))),
               "a leaf is loaded as an inner node, or the reverse");
  EXPECT_STREQ(Mirror.load(0x100, Word, innerLink(offset(4) + 4)),
               "a load goes to where no slot begins");
  EXPECT_STREQ(Mirror.load(0x100, Word, innerLink(offset(6))),
               "a load goes to where no slot begins");
  EXPECT_STREQ(Mirror.load(0x100, Word, innerLink(offset(2))),
               "a load goes to a slot that is in use");
  for (uint32_t Bad : {offset(0) + 92, childWord(0, 4), childWord(4, 0),
                       restWord(2) + 4, childWord(0, 1) + 2})
    EXPECT_STREQ(
        Mirror.load(0x100, Bad, innerLink(offset(4))),
        "the word that names a loaded slot is no link of a slot in use");
  EXPECT_STREQ(Mirror.load(0x100, childWord(0, 2), innerLink(offset(4))),
               "the word that names a loaded slot named another one before");
  EXPECT_STREQ(Mirror.load(0x100, kRootWord, innerLink(offset(4))),
               "the word that names a loaded slot named another one before");
  EXPECT_STREQ(
      Mirror.load(leafReference(15, 1), restWord(3), leafLink(offset(4))),
      "the loaded part of a leaf is not the rest of the part above it");
  EXPECT_EQ(Mirror.load(leafReference(14, 1), restWord(3), leafLink(offset(4))),
            nullptr);
}

TEST_F(CacheMirrorTest, RefusesBadVisits) {
  EXPECT_EQ(Mirror.visit(leafLink(offset(3))), nullptr);
  EXPECT_STREQ(Mirror.visit(innerLink(offset(3))),
               "a leaf is visited as an inner node, or the reverse");
  EXPECT_STREQ(Mirror.visit(innerLink(offset(4))),
               "a visit is to a slot that is not loaded");
  EXPECT_STREQ(Mirror.visit(leafReference(10, 5)),
               "the link of a visit does not name a slot");
  EXPECT_STREQ(Mirror.visit(innerLink(offset(9))),
               "a visit is to where no slot begins");
}

TEST_F(CacheMirrorTest, RefusesBadDeletions) {
  EXPECT_STREQ(Mirror.beginDeletion(childWord(0, 1)),
               "the word that names a deleted branch does not name a slot");
  EXPECT_STREQ(
      Mirror.beginDeletion(childWord(5, 1)),
      "the word that names a deleted branch is no link of a slot in use");
  EXPECT_EQ(Mirror.beginDeletion(childWord(1, 3)), nullptr);
  EXPECT_STREQ(Mirror.freeSlot(offset(1)),
               "a deletion frees a slot outside the deleted branch");
  EXPECT_STREQ(Mirror.freeSlot(offset(5)),
               "a deletion frees a slot that is free");
  EXPECT_STREQ(Mirror.freeSlot(4), "what a deletion frees is no slot");
  EXPECT_EQ(Mirror.freeSlot(offset(2)), nullptr);
  EXPECT_STREQ(Mirror.endDeletion(1),
               "a deletion leaves slots of the deleted branch");
  EXPECT_EQ(Mirror.freeSlot(offset(3)), nullptr);
  EXPECT_STREQ(Mirror.endDeletion(1),
               "a deletion says another number of slots than it has freed");
  EXPECT_EQ(Mirror.endDeletion(2), nullptr);
}

TEST(CacheMirror, ChecksTheShape) {
  EXPECT_EQ(CacheMirror::check({3, 64, 1, 40}), nullptr);
  EXPECT_NE(CacheMirror::check({0, 64, 1, 40}), nullptr);
  EXPECT_NE(CacheMirror::check({0x10000, 64, 1, 40}), nullptr);
  EXPECT_NE(CacheMirror::check({3, 2 * kTriangleTestBytes, 2, 40}), nullptr);
  EXPECT_NE(CacheMirror::check({3, 64, 0, 40}), nullptr);
  EXPECT_NE(CacheMirror::check({3, 64, 1, 52}), nullptr);
  EXPECT_NE(CacheMirror::check({3, 66, 1, 40}), nullptr);
}
