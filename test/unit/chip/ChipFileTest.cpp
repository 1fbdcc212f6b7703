//===- ChipFileTest.cpp - Reading and writing chip files ------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/chip/ChipFile.h"

#include "gmock/gmock.h"
#include "gtest/gtest.h"

using namespace tp;
using testing::HasSubstr;
using testing::Not;

namespace {

/// A chip file that is right; tests change one line of it.
std::string goodChip() {
  std::string Text = R"(description: "a test's chip"
clock_ghz: 1.5
tm:
  count: 2
  tps: 4
arbitration_window_cycles: 20
memory:
  bytes: 64 MiB
  latency_cycles: 50
local_store:
  bytes: 4096
icache:
  banks: 8
  ports_per_bank: 2
  bytes: 4 KiB
units:
)";
  for (unsigned I = 0; I != NumUnits; ++I)
    Text += "  " + std::string(unitName(Unit(I))) +
            ": {count: " + std::to_string(I + 1) + "}\n";
  return Text;
}

std::string replaced(std::string Text, const std::string &From,
                     const std::string &To) {
  size_t At = Text.find(From);
  EXPECT_NE(At, std::string::npos) << From;
  return Text.replace(At, From.size(), To);
}

/// The error of goodChip() with one change; empty if there is none.
std::string errorWith(const std::string &From, const std::string &To) {
  llvm::Expected<ChipConfig> Chip =
      parseChip(replaced(goodChip(), From, To), "c.yaml", "c");
  return Chip ? "" : llvm::toString(Chip.takeError());
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
  std::string Written;
  {
    llvm::raw_string_ostream OS(Written);
    writeChip(*Chip, OS);
  }
  llvm::Expected<ChipConfig> Again = parseChip(Written, "d.yaml", "c");
  ASSERT_TRUE(bool(Again)) << llvm::toString(Again.takeError()) << Written;
  std::string WrittenAgain;
  {
    llvm::raw_string_ostream OS(WrittenAgain);
    writeChip(*Again, OS);
  }
  EXPECT_EQ(Written, WrittenAgain);
  EXPECT_TRUE(Again->FlushToZero);
  EXPECT_EQ(Again->Latency[unsigned(LatencyClass::FpMul)], 7u);
}

TEST(ChipFile, LoadsEveryNamedChip) {
  std::vector<std::string> Names = chipNames(TP_CHIP_FOLDER);
  EXPECT_THAT(Names, testing::ElementsAre("1x1", "4x32", "report-512x8"));
  for (const std::string &Name : Names) {
    llvm::Expected<ChipConfig> Chip = loadChip(Name, TP_CHIP_FOLDER);
    ASSERT_TRUE(bool(Chip)) << llvm::toString(Chip.takeError());
    EXPECT_EQ(Chip->Name, Name);
  }
}

} // namespace
