//===- ChipFileTest.cpp - Reading and writing chip files ------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "GoodChip.h"

#include "gmock/gmock.h"

using namespace tp;
using testing::HasSubstr;
using testing::Not;

namespace {

/// The error of goodChip() with one change; empty if there is none.
std::string errorWith(const std::string &From, const std::string &To) {
  return errorOf(replaced(goodChip(), From, To));
}

TEST(ChipFile, ReadsEveryValue) {
  llvm::Expected<ChipConfig> Chip = parseChip(goodChip(), "c.yaml", "name");
  ASSERT_TRUE(bool(Chip)) << llvm::toString(Chip.takeError());
  EXPECT_EQ(Chip->Name, "name");
  EXPECT_EQ(Chip->Description, "a test's chip");
  EXPECT_EQ(Chip->ClockGHz, 1.5);
  EXPECT_EQ(Chip->TmCount, 2u);
  EXPECT_EQ(Chip->TpsPerTm, 4u);
  EXPECT_EQ(Chip->ArbitrationWindow, 20u);
  EXPECT_EQ(Chip->MemoryBytes, 64u << 20);
  EXPECT_EQ(Chip->MemoryLatency, 50u);
  EXPECT_EQ(Chip->LocalStoreBytes, 4096u);
  EXPECT_EQ(Chip->IcacheBanks, 8u);
  EXPECT_EQ(Chip->IcachePorts, 2u);
  EXPECT_EQ(Chip->IcacheBytes, 4096u);
  EXPECT_FALSE(Chip->FlushToZero);
  for (unsigned I = 0; I != NumUnits; ++I) {
    EXPECT_EQ(Chip->Units[I].Count, I + 1);
    EXPECT_EQ(Chip->Units[I].Interval, 1u);
  }
  for (unsigned I = 0; I != NumLatencyClasses; ++I)
    EXPECT_EQ(Chip->Latency[I], defaultLatency(LatencyClass(I)));
}

TEST(ChipFile, OverridesLatencies) {
  std::string Text = goodChip() + "latency_cycles:\n  FpMul: 7\n";
  llvm::Expected<ChipConfig> Chip = parseChip(Text, "c.yaml", "c");
  ASSERT_TRUE(bool(Chip)) << llvm::toString(Chip.takeError());
  EXPECT_EQ(Chip->Latency[unsigned(LatencyClass::FpMul)], 7u);
  EXPECT_EQ(Chip->Latency[unsigned(LatencyClass::FpAdd)],
            defaultLatency(LatencyClass::FpAdd));
}

TEST(ChipFile, RefusesMemoryLatencyAsUnitLatency) {
  std::string Text = goodChip() + "latency_cycles:\n  Load: 7\n";
  llvm::Expected<ChipConfig> Chip = parseChip(Text, "c.yaml", "c");
  ASSERT_FALSE(bool(Chip));
  EXPECT_THAT(llvm::toString(Chip.takeError()),
              HasSubstr("unknown key 'latency_cycles.Load'"));
}

TEST(ChipFile, NamesLineAndCureOfUnknownKeys) {
  EXPECT_THAT(errorWith("clock_ghz", "clok_ghz"),
              HasSubstr("c.yaml:2: unknown key 'clok_ghz'; did you mean "
                        "'clock_ghz'?"));
  EXPECT_THAT(errorWith("FPADD: {", "FPADD: {colour: 3, "),
              HasSubstr("unknown key 'units.FPADD.colour' (allowed here: "
                        "count, interval_cycles)"));
}

TEST(ChipFile, ReportsAllErrorsByLine) {
  std::string Error = errorWith("clock_ghz: 1.5\ntm:\n  count: 2",
                                "clock_ghz: fast\ntm:\n  count: 0");
  size_t First = Error.find("c.yaml:2: 'clock_ghz' is 'fast'");
  size_t Second = Error.find("c.yaml:4: 'tm.count' is '0'");
  EXPECT_NE(First, std::string::npos) << Error;
  EXPECT_NE(Second, std::string::npos) << Error;
  EXPECT_LT(First, Second);
}

TEST(ChipFile, ReportsAMissingSectionOnce) {
  std::string Error =
      errorWith("memory:\n  bytes: 64 MiB\n  latency_cycles: 50\n", "");
  EXPECT_THAT(Error, HasSubstr("key 'memory' is missing"));
  EXPECT_THAT(Error, Not(HasSubstr("memory.bytes")));
}

TEST(ChipFile, RefusesValuesOutOfRange) {
  const char *Cases[][3] = {
      {"count: 2\n", "count: -1\n", "\'tm.count\' is '-1'"},
      {"count: 2\n", "count: 2.5\n", "\'tm.count\' is '2.5'"},
      {"count: 2\n", "count:\n", "\'tm.count\' is nothing"},
      {"count: 2\n", "count: [2]\n", "\'tm.count\' is a list"},
      {"count: 2\n", "count: {a: 2}\n", "\'tm.count\' is a section"},
      {"count: 2\n", "count: 1048576\n", "more than the 1048576 threads"},
      {"clock_ghz: 1.5", "clock_ghz: 0", "'clock_ghz' is '0'"},
      {"clock_ghz: 1.5", "clock_ghz: nan", "'clock_ghz' is 'nan'"},
      {"arbitration_window_cycles: 20", "arbitration_window_cycles: 51",
       "at most memory.latency_cycles, which is 50"},
      {"bytes: 4096", "bytes: 4088", "a multiple of 16"},
      {"bytes: 4096", "bytes: 2 MiB", "'local_store.bytes' is '2 MiB'"},
      {"bytes: 64 MiB", "bytes: 4 GiB", "'memory.bytes' is '4 GiB'"},
      {"bytes: 64 MiB", "bytes: 64 KiB", "'memory.bytes' is '64 KiB'"},
      {"bytes: 64 MiB", "bytes: 99999999999999 GiB", "'memory.bytes' is"},
      {"bytes: 64 MiB", "bytes: 64 MB", "'memory.bytes' is '64 MB'"},
      {"banks: 8", "banks: 6", "1 to 64, a power of two"},
      {"FPADD: {count: 1", "FPADD: {count: 0",
       "is '0'; give it a whole number from 1"},
  };
  for (auto &[From, To, Message] : Cases)
    EXPECT_THAT(errorWith(From, To), HasSubstr(Message)) << To;
}

TEST(ChipFile, ReadsMissesOfTheIcache) {
  llvm::Expected<ChipConfig> Chip =
      parseChip(replaced(goodChip(), "  bytes: 4 KiB\n",
                         "  bytes: 4 KiB\n  misses: fixed\n  line_bytes: 32\n"
                         "  ways: 4\n  miss_latency_cycles: 20\n"),
                "c.yaml", "c");
  ASSERT_TRUE(bool(Chip)) << llvm::toString(Chip.takeError());
  EXPECT_EQ(Chip->IcacheMissKind, IcacheMisses::Fixed);
  EXPECT_EQ(Chip->IcacheLineBytes, 32u);
  EXPECT_EQ(Chip->IcacheWays, 4u);
  EXPECT_EQ(Chip->IcacheMissLatency, 20u);
  const char *Cases[][2] = {
      {"misses: fixed\n  miss_latency_cycles: 19",
       "'icache.miss_latency_cycles' is 19; give it at least "
       "arbitration_window_cycles, which is 20"},
      {"misses: memory", "has neither caches nor DRAM"},
      {"misses: fixed\n  ways: 3", "'icache.bytes' is 4096; give it a multiple "
                                   "of line_bytes x ways, which is 192"},
  };
  for (auto &[Keys, Message] : Cases)
    EXPECT_THAT(errorWith("  bytes: 4 KiB\n",
                          "  bytes: 4 KiB\n  " + std::string(Keys) + "\n"),
                HasSubstr(Message));
}

TEST(ChipFile, RefusesAUnitThatIsMissing) {
  std::string Line =
      "  FPINV: {count: " + std::to_string(unsigned(Unit::FPINV) + 1) + "}\n";
  EXPECT_THAT(errorWith(Line, ""), HasSubstr("key 'units.FPINV' is missing"));
}

TEST(ChipFile, WritesWhatItReads) {
  std::string Text =
      replaced(goodChip(), "clock_ghz", "flush_to_zero: true\nclock_ghz") +
      "latency_cycles:\n  FpMul: 7\n";
  llvm::Expected<ChipConfig> Chip = parseChip(Text, "c.yaml", "c");
  ASSERT_TRUE(bool(Chip)) << llvm::toString(Chip.takeError());
  llvm::Expected<ChipConfig> Again = parseChip(written(*Chip), "d.yaml", "c");
  ASSERT_TRUE(bool(Again)) << llvm::toString(Again.takeError());
  EXPECT_EQ(written(*Chip), written(*Again));
  EXPECT_TRUE(Again->FlushToZero);
  EXPECT_EQ(Again->Latency[unsigned(LatencyClass::FpMul)], 7u);
}

TEST(ChipFile, LoadsEveryNamedChip) {
  std::vector<std::string> Names = chipNames(TP_CHIP_FOLDER);
  EXPECT_THAT(Names, testing::ElementsAre("128x32", "1x1", "4x32",
                                          "hbm2-256x16", "report-512x8",
                                          "report-512x8-gddr6", "trax-32x32"));
  for (const std::string &Name : Names) {
    llvm::Expected<ChipConfig> Chip = loadChip(Name, TP_CHIP_FOLDER);
    ASSERT_TRUE(bool(Chip)) << llvm::toString(Chip.takeError());
    EXPECT_EQ(Chip->Name, Name);
    // What they print is the same chip, without the files that they name.
    llvm::Expected<ChipConfig> Again = parseChip(written(*Chip), "p", Name);
    ASSERT_TRUE(bool(Again)) << llvm::toString(Again.takeError());
    EXPECT_EQ(written(*Chip), written(*Again));
  }
}

} // namespace
