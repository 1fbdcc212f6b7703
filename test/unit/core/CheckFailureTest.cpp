//===- CheckFailureTest.cpp - Reports of failed checks --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/Check/CheckFailure.h"

#include "gtest/gtest.h"

using namespace tp;

namespace {

constexpr uint64_t NaN = 0x7FC00000, Infinity = 0x7F800000, One = 0x3F800000;

TEST(CheckFailure, CodesHoldEverything) {
  for (CheckKind Kind : {CheckKind::Conversion, CheckKind::Produced})
    for (CheckType Type : {CheckType::Half, CheckType::Double})
      for (CheckOperation Operation :
           {CheckOperation::ToInt8, CheckOperation::SelectedValue}) {
        uint32_t Code = CheckFailure{Kind, Type, Operation}.code();
        ASSERT_TRUE(CheckFailure::isCode(Code));
        CheckFailure Again = CheckFailure::fromCode(Code);
        EXPECT_EQ(Again.Kind, Kind);
        EXPECT_EQ(Again.Type, Type);
        EXPECT_EQ(Again.Operation, Operation);
      }
}

TEST(CheckFailure, OtherCodesAreTheUsers) {
  EXPECT_FALSE(CheckFailure::isCode(0));
  EXPECT_FALSE(CheckFailure::isCode(CheckFailure::FirstCode - 1));
  EXPECT_TRUE(CheckFailure::isCode(CheckFailure::FirstCode));
  EXPECT_FALSE(CheckFailure::isCode(0xFFFF));
  EXPECT_FALSE(CheckFailure::isCode(CheckFailure::FirstCode + 0x10000));
}

TEST(CheckFailure, SaysWhetherAnOperandWasToBlame) {
  CheckFailure Product{CheckKind::Produced, CheckType::Float,
                       CheckOperation::Multiply};
  EXPECT_EQ(Product.describe({Infinity, 0x7F000000, 0x40800000}),
            "infinity produced under finite math: 1.7014118e+38 (0x7f000000) * "
            "4 (0x40800000) = inf (0x7f800000)");
  EXPECT_EQ(Product.describe({NaN, Infinity, 0}),
            "infinity used under finite math: inf (0x7f800000) * 0 "
            "(0x00000000) = nan (0x7fc00000)");
  EXPECT_EQ(Product.describe({NaN, Infinity, NaN}),
            "NaN used under finite math: inf (0x7f800000) * nan (0x7fc00000) = "
            "nan (0x7fc00000)");
}

TEST(CheckFailure, IgnoresValuesThatTheOperationDoesNotHave) {
  CheckFailure Root{CheckKind::Produced, CheckType::Float,
                    CheckOperation::SquareRoot};
  EXPECT_EQ(Root.describe({NaN, 0xBF800000, NaN}),
            "NaN produced under finite math: square root of -1 (0xbf800000) = "
            "nan (0x7fc00000)");
  CheckFailure Call{CheckKind::Produced, CheckType::Float,
                    CheckOperation::CallResult};
  EXPECT_EQ(Call.describe({Infinity, NaN, NaN}),
            "infinity produced under finite math: result of a call, inf "
            "(0x7f800000)");
}

TEST(CheckFailure, DescribesEachType) {
  EXPECT_EQ(describeFloat(One, CheckType::Float), "1 (0x3f800000)");
  EXPECT_EQ(describeFloat(1, CheckType::Float), "1e-45 (0x00000001)");
  EXPECT_EQ(describeFloat(0x80000000, CheckType::Float), "-0 (0x80000000)");
  EXPECT_EQ(describeFloat(0x3FB999999999999A, CheckType::Double),
            "0.1 (0x3fb999999999999a)");
  EXPECT_EQ(describeFloat(0x3F80, CheckType::BFloat), "1 (0x3f80)");
  EXPECT_EQ(describeFloat(0x3C00, CheckType::Half), "1 (0x3c00)");
  EXPECT_EQ(describeFloat(0xC900, CheckType::Half), "-10 (0xc900)");
  EXPECT_EQ(describeFloat(0x7BFF, CheckType::Half), "65504 (0x7bff)");
  EXPECT_EQ(describeFloat(0x0001, CheckType::Half), "5.9604645e-08 (0x0001)");
  EXPECT_EQ(describeFloat(0xFC00, CheckType::Half), "-inf (0xfc00)");
  EXPECT_EQ(describeFloat(0x7E00, CheckType::Half), "nan (0x7e00)");
}

} // namespace
