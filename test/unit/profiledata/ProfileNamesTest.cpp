//===- ProfileNamesTest.cpp - Names as tables show them -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/profile/ProfileNames.h"

#include "gtest/gtest.h"

using namespace tp;

namespace {

TEST(ProfileNames, ShortNamesHaveNoParameters) {
  EXPECT_EQ(shortName("main"), "main");
  EXPECT_EQ(shortName("tp::f(int, char)"), "tp::f");
  EXPECT_EQ(shortName("void tp::f<int>(std::array<int, 3>)"), "tp::f");
  EXPECT_EQ(shortName("tp::A<tp::B<1>>::g() const"), "tp::A::g");
  EXPECT_EQ(shortName("tp::operator*(tp::Vector3, float)"), "tp::operator*");
  EXPECT_EQ(shortName("void tp::operator<<<int>(A&)"), "tp::operator<<<int>");
  EXPECT_EQ(shortName("A::operator()(int) const"), "A::operator()");
  EXPECT_EQ(shortName("A::operator unsigned int() const"),
            "A::operator unsigned int");
  EXPECT_EQ(shortName("A::operator<(A const&)"), "A::operator<");
  EXPECT_EQ(shortName("(anonymous namespace)::f(int)"), "(anonymous)::f");
}

TEST(ProfileNames, LevelsAndLossesAreFoundByTheirNames) {
  EXPECT_EQ(findLevel("dram_row_hit"), ServedBy::DramRowHit);
  EXPECT_EQ(findLevel("l3"), std::nullopt);
  EXPECT_EQ(findLoss("unit_conflict"), Loss::UnitConflict);
  EXPECT_EQ(findLoss("dram"), Loss::Dram);
  EXPECT_EQ(findLoss(""), std::nullopt);
}

} // namespace
