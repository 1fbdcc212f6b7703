//===- ChipAreaTest.cpp - Area of a chip by part --------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/chip/ChipArea.h"
#include "simulator/chip/ChipFile.h"

#include "gtest/gtest.h"

using namespace tp;

namespace {

TEST(ChipArea, CountsUnitsPerTmAndStoresPerThread) {
  ChipConfig Chip;
  Chip.TmCount = 3;
  Chip.TpsPerTm = 5;
  Chip.Units[unsigned(Unit::FPMUL)].Count = 4;
  Chip.LocalStoreBytes = 4096;
  TechnologyConfig T;
  T.Units[unsigned(Unit::FPMUL)].AreaMm2 = 0.5;
  T.RegisterFile.AreaMm2 = 0.25;
  T.LocalStore = {4096, {0.125, 0, {}}};
  T.IcacheBytes = 4096;
  T.IcachePorts = 2;
  T.Icache[3].AreaMm2 = 2;
  Chip.Technology = T;
  std::vector<AreaPart> Parts = chipArea(Chip);
  ASSERT_EQ(Parts.size(), NumUnits + 3);
  EXPECT_EQ(Parts[unsigned(Unit::FPMUL)].Name, "FPMUL");
  EXPECT_EQ(Parts[unsigned(Unit::FPMUL)].Count, 12u);
  EXPECT_EQ(Parts[unsigned(Unit::FPMUL)].TotalMm2, 6);
  EXPECT_EQ(Parts[NumUnits].TotalMm2, 15 * 0.25);
  EXPECT_EQ(Parts[NumUnits + 1].TotalMm2, 15 * 0.125);
  EXPECT_EQ(Parts[NumUnits + 2].TotalMm2, 6);
  EXPECT_EQ(totalAreaMm2(Chip), 6 + 15 * 0.375 + 6);
}

TEST(ChipArea, IsNothingWithoutATechnology) {
  ChipConfig Chip;
  Chip.L1 = CacheConfig{.Bytes = 4096};
  ASSERT_EQ(chipArea(Chip).size(), NumUnits + 4);
  EXPECT_EQ(totalAreaMm2(Chip), 0);
}

// Per TM, by SimTRaX's table: units 4 x .003 + 4 x .000722 + 4 x .000722 +
// 4 x .0165 + .112 + .001814 + 8 x .00066 + .0117 + 4 x .00066 + 8 x .00066 =
// .22249; 8 register files .118132, 8 local stores .11170632, icache .102358;
// together .55468632, times 512.
TEST(ChipArea, ReportChipIsBelow300Mm2) {
  llvm::Expected<ChipConfig> Chip = loadChip("report-512x8", TP_CHIP_FOLDER);
  ASSERT_TRUE(bool(Chip)) << llvm::toString(Chip.takeError());
  EXPECT_NEAR(totalAreaMm2(*Chip), 283.999, 0.001);
}

} // namespace
