//===- ShadowMemoryTest.cpp - What is known of each byte ------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/check/ShadowMemory.h"

#include "gtest/gtest.h"

using namespace tp;

static constexpr uint32_t Begin = 0x10000;

namespace {

class ShadowOfMemory : public testing::Test {
protected:
  ShadowMemory Shadow{Begin, 4096};
};

TEST_F(ShadowOfMemory, EverythingIsAllowedAndDefinedAtFirst) {
  ASSERT_TRUE(Shadow.isMapped());
  for (uint32_t At = Begin; At != Begin + 4096; ++At) {
    EXPECT_EQ(Shadow.accessOf(At), uint8_t(Access::All));
    EXPECT_EQ(*Shadow.undefined(At), 0);
  }
}

TEST_F(ShadowOfMemory, TheLastGranuleIsAllowedInPart) {
  Shadow.setAccess(Begin, 64, Access::HeapUnused);
  Shadow.setAccess(Begin + 8, 13, Access::All);
  EXPECT_EQ(Shadow.accessOf(Begin + 7), uint8_t(Access::HeapUnused));
  EXPECT_EQ(Shadow.accessOf(Begin + 15), uint8_t(Access::All));
  EXPECT_EQ(Shadow.accessOf(Begin + 16), 5);
  EXPECT_EQ(Shadow.accessOf(Begin + 24), uint8_t(Access::HeapUnused));
  // What may not be accessed may not in part.
  Shadow.setAccess(Begin + 8, 13, Access::HeapFreed);
  EXPECT_EQ(Shadow.accessOf(Begin + 16), uint8_t(Access::HeapFreed));
}

TEST_F(ShadowOfMemory, NewUndefinedMemoryHasNoOldOrigins) {
  for (uint32_t Word = 0; Word != 8; ++Word)
    Shadow.setOrigin(Begin + 4 * Word, 0x01020304);
  // Of words that are undefined in part, too: never parts of a number.
  Shadow.setUndefined(Begin + 6, 11);
  EXPECT_EQ(Shadow.origin(Begin), 0x01020304u);
  EXPECT_EQ(Shadow.origin(Begin + 6), 0u);
  EXPECT_EQ(Shadow.origin(Begin + 8), 0u);
  EXPECT_EQ(Shadow.origin(Begin + 16), 0u);
  EXPECT_EQ(Shadow.origin(Begin + 20), 0x01020304u);
  EXPECT_EQ(*Shadow.undefined(Begin + 5), 0);
  EXPECT_EQ(*Shadow.undefined(Begin + 6), 0xff);
  EXPECT_EQ(*Shadow.undefined(Begin + 16), 0xff);
  EXPECT_EQ(*Shadow.undefined(Begin + 17), 0);
}

} // namespace
