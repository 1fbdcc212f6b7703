//===- UndefinedOriginsTest.cpp - Where undefined values come from --------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/check/UndefinedOrigins.h"

#include "gtest/gtest.h"

using namespace tp;

static UndefinedOrigin origin(uint32_t Pc, const char *What) {
  return {What, "allocated", {0, Pc, 0}};
}

TEST(UndefinedOrigins, EachIsOne) {
  UndefinedOrigins Origins;
  const OriginId First = Origins.add(origin(100, "first"));
  const OriginId Second = Origins.add(origin(100, "second"));
  EXPECT_NE(First, Second);
  EXPECT_EQ(Origins.add(origin(100, "first")), First);
  EXPECT_EQ(Origins[Second].What, "second");
  EXPECT_EQ(Origins[UnwrittenRegister].What,
            "a register that was never written");
}

TEST(UndefinedOrigins, TooManyAreNotToldApart) {
  UndefinedOrigins Origins(/*MaxOrigins=*/5);
  std::vector<OriginId> Numbers;
  for (uint32_t Pc = 0; Pc != 100; ++Pc)
    Numbers.push_back(Origins.add(origin(Pc, "place")));
  EXPECT_NE(Numbers[0], Numbers[1]);
  EXPECT_EQ(Numbers[50], Numbers[99]);
  EXPECT_EQ(Origins[Numbers[99]].What, "memory that nobody has written");
  EXPECT_EQ(Origins[Numbers[1]].Place.Pc, 1u);
}
