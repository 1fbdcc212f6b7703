//===- LightTableTest.cpp - Lights are chosen by area ---------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/common/LightTable.h"

#include "kernels/common/Random.h"

#include <gtest/gtest.h>

using namespace tp;

/// The probability with which the table gives each number.
static std::vector<double>
probabilities(const std::vector<LightChoice> &Table) {
  std::vector<double> Result(Table.size());
  for (uint32_t Number = 0; Number != Table.size(); ++Number) {
    const double Keep = Table[Number].Keep * 0x1p-32 / double(Table.size());
    Result[Number] += Keep;
    Result.at(Table[Number].Alias) += 1.0 / double(Table.size()) - Keep;
  }
  return Result;
}

TEST(LightTable, AliasTableGivesExactShares) {
  for (const std::vector<double> &Weights : {std::vector<double>{1},
                                             {1, 1},
                                             {3, 1},
                                             {1, 2, 3, 4, 5},
                                             {1e-9, 1, 1e9, 7},
                                             {0.1, 0.1, 0.1}}) {
    double Sum = 0;
    for (double Weight : Weights)
      Sum += Weight;
    const std::vector<double> Result = probabilities(makeAliasTable(Weights));
    ASSERT_EQ(Result.size(), Weights.size());
    for (size_t I = 0; I != Weights.size(); ++I)
      EXPECT_NEAR(Result[I], Weights[I] / Sum, 1e-9);
  }
}

TEST(LightTable, EmptyTable) { EXPECT_TRUE(makeAliasTable({}).empty()); }

TEST(LightTable, HoldsTheEmissiveTrianglesOnly) {
  Scene Source;
  Source.Materials = {{"dark", {1, 1, 1}, {}}, {"lamp", {1, 1, 1}, {2, 3, 4}}};
  Source.Triangles = {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 0},
                      {{{0, 0, 0}, {0, 3, 0}, {0, 0, 2}}, 1},
                      {{{5, 0, 0}, {6, 0, 0}, {5, 2, 0}}, 1}};
  const LightTable Lights = makeLightTable(Source);
  ASSERT_EQ(Lights.Records.size(), 2u);
  EXPECT_DOUBLE_EQ(Lights.TotalArea, 4);
  EXPECT_EQ(Lights.Records[0].UnitNormal.X, 1);
  EXPECT_EQ(Lights.Records[0].Emission.Y, 3);
  EXPECT_EQ(Lights.Records[1].Edges[1].Y, 2);
  const std::vector<double> Shares = probabilities(Lights.Choices);
  EXPECT_NEAR(Shares[0], 0.75, 1e-9);
  EXPECT_NEAR(Shares[1], 0.25, 1e-9);
}
