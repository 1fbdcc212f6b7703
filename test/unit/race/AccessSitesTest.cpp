//===- AccessSitesTest.cpp - Numbers for places in the program ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/check/race/AccessSites.h"

#include "gtest/gtest.h"

using namespace tp;

namespace {

TEST(AccessSites, ToldApartByInstructionAndCalls) {
  AccessSites Sites(100);
  const AccessSite A = Sites.of({0x10000, 0});
  const AccessSite B = Sites.of({0x10004, 0});
  const AccessSite C = Sites.of({0x10000, 7});
  EXPECT_NE(A, B);
  EXPECT_NE(A, C);
  EXPECT_EQ(Sites.of({0x10000, 0}), A);
  EXPECT_EQ(Sites.place(C).Pc, 0x10000u);
  EXPECT_EQ(Sites.place(C).Context, 7u);
}

TEST(AccessSites, WithoutCallsWhenThereAreTooMany) {
  AccessSites Sites(/*TextWords=*/4, /*MaxSites=*/14);
  for (CallContext Context = 1; Context != 100; ++Context)
    for (uint32_t Word = 0; Word != 4; ++Word) {
      const AccessSite Site = Sites.of({0x10000 + 4 * Word, Context});
      EXPECT_LT(Site, 14u);
      EXPECT_EQ(Sites.place(Site).Pc, 0x10000 + 4 * Word);
    }
  EXPECT_EQ(Sites.place(Sites.of({0x10000, 1})).Context, 1u);
  EXPECT_EQ(Sites.place(Sites.of({0x10000, 99})).Context, 0u);
}

} // namespace
