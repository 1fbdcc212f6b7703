//===- HitConditionTest.cpp - Which hits of a breakpoint stop -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/HitCondition.h"

#include "gtest/gtest.h"

using namespace llvm;
using namespace tp::dap;

namespace {

/// The hits from 1 to 9 that stop, as digits.
std::string hits(StringRef Text) {
  Expected<HitCondition> Condition = HitCondition::parse(Text);
  if (!Condition)
    return toString(Condition.takeError());
  std::string Result;
  for (unsigned Number = 1; Number < 10; ++Number)
    if (Condition->accepts(Number))
      Result += char('0' + Number);
  return Result;
}

TEST(HitCondition, Comparisons) {
  EXPECT_EQ(hits("7"), "789");
  EXPECT_EQ(hits(">=7"), "789");
  EXPECT_EQ(hits("> 7"), "89");
  EXPECT_EQ(hits("== 7"), "7");
  EXPECT_EQ(hits("= 7"), "7");
  EXPECT_EQ(hits("<3"), "12");
  EXPECT_EQ(hits(" <= 3 "), "123");
  EXPECT_EQ(hits("%3"), "369");
}

TEST(HitCondition, SaysWhatIsWrong) {
  for (StringRef Text : {"", "x", "0", "-1", "% 0", ">= 3 4"})
    EXPECT_EQ(hits(Text),
              ("hit condition '" + Text +
               "': expected a whole number from 1 on, perhaps behind one of "
               ">= > == < <= %")
                  .str());
}

TEST(HitCondition, WithoutOneEveryHitStops) {
  EXPECT_TRUE(HitCondition().accepts(1));
}

} // namespace
