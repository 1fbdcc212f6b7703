//===- DramAddressMappingTest.cpp - Where a byte lies in DRAM ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/memory/dram/DramAddressMapping.h"

#include "gtest/gtest.h"

#include <set>
#include <tuple>

using namespace tp;

namespace {

/// Three channels of two groups of four banks of eight rows of 16 bursts.
DramConfig configWith(const char *AddressMapping) {
  DramConfig Config;
  Config.Channels = 3;
  Config.BankGroups = 2;
  Config.BanksPerGroup = 4;
  Config.RowsPerBank = 8;
  Config.RowBytes = 512;
  Config.BurstBytes = 32;
  Config.AddressMapping = AddressMapping;
  return Config;
}

TEST(DramAddressMapping, DigitsFromTheLowest) {
  DramAddressMapping Mapping(configWith("row:bank:column:bankgroup:channel"));
  EXPECT_EQ(Mapping.locate(0), (DramLocation{0, 0, 0, 0}));
  EXPECT_EQ(Mapping.locate(31), (DramLocation{0, 0, 0, 0}));
  EXPECT_EQ(Mapping.locate(32), (DramLocation{1, 0, 0, 0}));
  // 3 channels, then the other bank group, whose first bank is 4.
  EXPECT_EQ(Mapping.locate(32 * 3), (DramLocation{0, 4, 0, 0}));
  EXPECT_EQ(Mapping.locate(32 * 3 * 2 * 5), (DramLocation{0, 0, 0, 5}));
  EXPECT_EQ(Mapping.locate(32 * 3 * 2 * 16), (DramLocation{0, 1, 0, 0}));
  EXPECT_EQ(Mapping.locate(32 * 3 * 2 * 16 * 4), (DramLocation{0, 0, 1, 0}));
  EXPECT_EQ(Mapping.channelOf(32 * 5 + 7), 2);
}

TEST(DramAddressMapping, SplitField) {
  DramAddressMapping Mapping(
      configWith("row:bank:column:bankgroup:channel:column/4"));
  EXPECT_EQ(Mapping.locate(32 * 3), (DramLocation{0, 0, 0, 3}));
  EXPECT_EQ(Mapping.locate(32 * 4), (DramLocation{1, 0, 0, 0}));
  // 4 x 3 channels x 2 groups below the upper columns.
  EXPECT_EQ(Mapping.locate(32 * 24 * 3 + 32), (DramLocation{0, 0, 0, 13}));
}

TEST(DramAddressMapping, EveryBurstHasAPlaceOfItsOwn) {
  for (const char *Text :
       {"row:bank:column:bankgroup:channel",
        "channel:bankgroup:row:bank:column",
        "column:row:bank:row/2:bankgroup:channel:column/2"}) {
    DramConfig Config = configWith(Text);
    ASSERT_EQ(checkAddressMapping(Config), "");
    DramAddressMapping Mapping(Config);
    std::set<std::tuple<uint32_t, uint32_t, uint32_t, uint32_t>> Seen;
    for (uint64_t A = 0; A < dramCapacityBytes(Config); A += 32) {
      DramLocation Place = Mapping.locate(A);
      EXPECT_LT(Place.Channel, 3u);
      EXPECT_LT(Place.Bank, 8u);
      EXPECT_LT(Place.Row, 8u);
      EXPECT_LT(Place.Column, 16u);
      EXPECT_EQ(Mapping.channelOf(A), Place.Channel);
      Seen.emplace(Place.Channel, Place.Bank, Place.Row, Place.Column);
    }
    EXPECT_EQ(Seen.size(), 3u * 8 * 8 * 16);
  }
}

TEST(DramAddressMapping, SaysWhatIsWrong) {
  auto Wrong = [](const char *Text) {
    return checkAddressMapping(configWith(Text));
  };
  EXPECT_EQ(Wrong("row:bank:column:bankgroup:rank"),
            "'rank' is none of row, bank, bankgroup, column and channel");
  EXPECT_EQ(Wrong("row:bank:column:channel"), "'bankgroup' is missing");
  EXPECT_EQ(Wrong("row:bank:bankgroup:channel:column/4"),
            "'column' is missing for the upper part");
  EXPECT_EQ(Wrong("row:row:bank:column:bankgroup:channel"),
            "'row' stands there more often than it has digits");
  EXPECT_EQ(Wrong("row:bank:column:bankgroup:channel:column/3"),
            "'column/3': the field's size, 16, is no multiple of it");
  EXPECT_EQ(Wrong("row:bank:column:bankgroup:channel:column/x"),
            "'column/x': a number from 2 on must stand behind the slash");
  EXPECT_EQ(Wrong(""),
            "'' is none of row, bank, bankgroup, column and channel");
}

} // namespace
