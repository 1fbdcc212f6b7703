//===- ChipAreaTest.cpp - Area of a chip by part --------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/chip/ChipArea.h"
#include "simulator/chip/ChipFile.h"
#include "simulator/chip/PartCosts.h"

#include "gmock/gmock.h"
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

TEST(ChipArea, NamesTheReportChipsAssumptions) {
  llvm::Expected<ChipConfig> Chip = loadChip("report-512x8", TP_CHIP_FOLDER);
  ASSERT_TRUE(bool(Chip)) << llvm::toString(Chip.takeError());
  std::vector<std::string> Assumed;
  for (const AreaPart &Part : chipArea(*Chip)) {
    EXPECT_NE(Part.Source.Text, "") << Part.Name;
    if (Part.Source.IsAssumption)
      Assumed.push_back(Part.Name);
  }
  EXPECT_THAT(Assumed,
              testing::ElementsAre("MEMORY", "register_file", "local_store"));
}

/// A chip with the technology in the box.
ChipConfig simtraxChip() {
  ChipConfig Chip = llvm::cantFail(loadChip("report-512x8", TP_CHIP_FOLDER));
  Chip.TmCount = 1;
  return Chip;
}

// SimTRaX's dcacheparams.txt, lines of 64 bytes, within what the technology's
// sources say of their law.
TEST(ChipArea, CachesFollowThePublishedPoints) {
  struct Point {
    uint64_t KiB;
    uint32_t Banks;
    double Mm2, Nj;
  };
  const Point Points[] = {
      {4, 1, .067366, .072368},     {256, 1, 2.345601, .457809},
      {8, 2, .269463, .134656},     {1024, 2, 15.76154, 1.151285},
      {16, 4, .268184, .134578},    {32, 4, .391508, .165190},
      {512, 4, 4.575762, .579593},  {32, 16, 1.385896, .283138},
      {512, 16, 5.960245, .611974}, {1024, 32, 12.664137, .897012},
      {256, 64, 8.26795, .688835}};
  ChipConfig Chip = simtraxChip();
  for (const Point &P : Points) {
    PartCost Cost =
        cacheCost(Chip, CacheConfig{.Bytes = P.KiB << 10, .Banks = P.Banks});
    EXPECT_NEAR(Cost.AreaMm2 / P.Mm2, 1, .17) << P.KiB << ' ' << P.Banks;
    EXPECT_NEAR(Cost.EnergyNj / P.Nj, 1, .13) << P.KiB << ' ' << P.Banks;
    EXPECT_FALSE(Cost.Source.IsAssumption);
  }
}

// 16 KiB have .01396329 mm2 and .00692867 nJ. A cache of one bank has .0312 +
// .00914 n mm2 and .01772 + .02692 sqrt(n) nJ: .17744 and .1254 at 16 KiB,
// .06776 and .07156 at 4 KiB.
TEST(ChipArea, LocalStoresOfOtherSizesScaleLikeCaches) {
  ChipConfig Chip = simtraxChip();
  EXPECT_DOUBLE_EQ(localStoreCost(Chip).AreaMm2, .01396329);
  Chip.LocalStoreBytes = 4096;
  PartCost Cost = localStoreCost(Chip);
  EXPECT_NEAR(Cost.AreaMm2, .01396329 * .06776 / .17744, 1e-9);
  EXPECT_NEAR(Cost.EnergyNj, .00692867 * .07156 / .1254, 1e-9);
  EXPECT_TRUE(Cost.Source.IsAssumption);
}

// 8 banks of two ports have .102358 mm2; five ports need three such caches.
TEST(ChipArea, IcachesAreCopiedForMorePorts) {
  ChipConfig Chip = simtraxChip();
  EXPECT_DOUBLE_EQ(icacheCost(Chip).AreaMm2, .102358);
  EXPECT_FALSE(icacheCost(Chip).Source.IsAssumption);
  Chip.IcachePorts = 5;
  EXPECT_DOUBLE_EQ(icacheCost(Chip).AreaMm2, 3 * .102358);
  EXPECT_DOUBLE_EQ(icacheCost(Chip).EnergyNj, .01311);
  Chip.IcacheBytes = 16384;
  EXPECT_NEAR(icacheCost(Chip).AreaMm2, 3 * .102358 * .17744 / .06776, 1e-9);
  EXPECT_TRUE(icacheCost(Chip).Source.IsAssumption);
}

TEST(ChipArea, CountsCachesByTmAndGroup) {
  ChipConfig Chip = simtraxChip();
  Chip.TmCount = 10;
  Chip.L1 = CacheConfig{.Bytes = 16 << 10, .Banks = 4};
  Chip.L2 = CacheConfig{.Bytes = 256 << 10, .Banks = 16};
  Chip.TmsPerL2 = 4;
  std::vector<AreaPart> Parts = chipArea(Chip);
  ASSERT_EQ(Parts.size(), NumUnits + 5);
  EXPECT_EQ(Parts[NumUnits + 3].Name, "l1");
  EXPECT_EQ(Parts[NumUnits + 3].Count, 10u);
  EXPECT_NEAR(Parts[NumUnits + 3].TotalMm2, 10 * (.1424 + 16 * .008035), 1e-9);
  EXPECT_EQ(Parts[NumUnits + 4].Name, "l2");
  EXPECT_EQ(Parts[NumUnits + 4].Count, 3u);
  EXPECT_NEAR(Parts[NumUnits + 4].TotalMm2, 3 * (1.1069 + 256 * .008889), 1e-9);
}

} // namespace
