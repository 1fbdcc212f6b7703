//===- UtilisationSamplerTest.cpp - Intervals of a run --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/profile/UtilisationSampler.h"

#include "gtest/gtest.h"

#include <algorithm>
#include <numeric>

using namespace tp;

namespace {

constexpr uint32_t Tms = 2, Tps = 3;

/// Thread t has issued in every (t + 1)-th cycle and waited for memory in the
/// others.
Statistics at(uint64_t Cycles) {
  Statistics Now;
  Now.Cycles = Cycles;
  for (uint64_t Thread = 0; Thread != Tms * Tps; ++Thread) {
    ThreadStatistics &Counts = Now.Threads.emplace_back();
    Counts.Instructions = Cycles / (Thread + 1);
    Counts.Lost[unsigned(Loss::Memory)] = Cycles - Counts.Instructions;
  }
  return Now;
}

Utilisation sample(const ChipConfig &Chip, uint64_t Cycles) {
  UtilisationSampler Sampler(Chip);
  Sampler.look(at(0));
  while (Sampler.nextLook() < Cycles) {
    // A look of somebody else changes nothing.
    Sampler.look(at(Sampler.nextLook() - 1));
    Sampler.look(at(Sampler.nextLook()));
  }
  Sampler.look(at(Cycles), /*IsLast=*/true);
  return Sampler.take();
}

TEST(UtilisationSampler, IntervalsAddUpHoweverLongTheRun) {
  ChipConfig Chip;
  Chip.TmCount = Tms;
  Chip.TpsPerTm = Tps;
  for (uint64_t Cycles : {1ul, 1023ul, 1024ul, 1025ul, 600000ul, 7654321ul}) {
    Utilisation Found = sample(Chip, Cycles);
    EXPECT_LT(Found.Ends.size(), 512u);
    if (Cycles > 600000)
      EXPECT_GE(Found.Ends.size(), 256u);
    EXPECT_EQ(Found.Ends.back(), Cycles);
    EXPECT_TRUE(std::ranges::is_sorted(Found.Ends));
    ASSERT_EQ(Found.Issued.size(), Tms);
    for (uint64_t Tm = 0; Tm != Tms; ++Tm) {
      uint64_t Wanted = 0;
      for (uint64_t Thread = Tm * Tps; Thread != (Tm + 1) * Tps; ++Thread)
        Wanted += Cycles / (Thread + 1);
      ASSERT_EQ(Found.Issued[Tm].size(), Found.Ends.size());
      EXPECT_EQ(std::accumulate(Found.Issued[Tm].begin(),
                                Found.Issued[Tm].end(), uint64_t(0)),
                Wanted);
      EXPECT_EQ(std::accumulate(Found.Memory[Tm].begin(),
                                Found.Memory[Tm].end(), uint64_t(0)),
                Tps * Cycles - Wanted);
    }
    ProfileCounts Sum;
    for (const ProfileCounts &Interval : Found.Chip)
      Sum += Interval;
    EXPECT_EQ(Sum.cycles(), Tms * Tps * Cycles);
  }
}

} // namespace
