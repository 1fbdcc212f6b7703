//===- ChipMemoryTest.cpp - Caches, crossbar and DRAM in chip files -------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "GoodChip.h"

#include "simulator/chip/ChipSettings.h"
#include "simulator/chip/MinimumRoundTrip.h"

#include "gmock/gmock.h"

using namespace tp;
using testing::HasSubstr;

namespace {

const char *Levels = R"(
store_buffer_entries: 5
l1: {bytes: 24 KiB, line_bytes: 64, sector_bytes: 16, ways: 3, banks: 2, bank_bytes: 8, latency_cycles: 4, miss_registers: 6, merges_per_miss: 7}
crossbar: {latency_cycles: 9, request_bytes_per_cycle: 8, answer_bytes_per_cycle: 32, header_bytes: 12}
l2: {tms_per_l2: 2, bytes: 64 KiB, line_bytes: 128, ways: 4, banks: 8, latency_cycles: 10, miss_registers: 20, merges_per_miss: 21, writes: back}
)";

const char *Dram = R"(  dram:
    name: "test"
    source: "nowhere"
    clock_khz: 1000000
    channels: 2
    bank_groups: 4
    banks_per_group: 2
    rows_per_bank: 8192
    row_bytes: 2 KiB
    burst_bytes: 32
    burst_ticks: 2
    address_mapping: "row:bank:bankgroup:column:channel"
    ticks: {rcd_read: 11, rcd_write: 12, rp: 13, cl: 14, cwl: 15, ras: 26, rrd_short: 3, rrd_long: 4, faw: 17, wr: 18, wtr_short: 5, wtr_long: 6, rtw: 19, rtp: 20, ccd_short: 2, ccd_long: 3, rfc: 100, refi: 1000}
    queue: {read_entries: 30, write_entries: 31, write_high_mark: 29, write_low_mark: 28, row_hit_limit: 3}
    controller_cycles: 7
)";

std::string withMemory() {
  return replaced(goodChip(), "  latency_cycles: 50\n", Dram) + Levels;
}

std::string errorWith(const std::string &From, const std::string &To) {
  return errorOf(replaced(withMemory(), From, To));
}

TEST(ChipMemory, ReadsEveryLevel) {
  llvm::Expected<ChipConfig> Chip = parseChip(withMemory(), "c.yaml", "c");
  ASSERT_TRUE(bool(Chip)) << llvm::toString(Chip.takeError());
  ASSERT_TRUE(Chip->L1 && Chip->L2 && Chip->Crossbar && Chip->Dram);
  EXPECT_EQ(Chip->StoreBufferEntries, 5u);
  EXPECT_EQ(Chip->L1->Bytes, 24u << 10);
  EXPECT_EQ(Chip->L1->LineBytes, 64u);
  EXPECT_EQ(Chip->L1->SectorBytes, 16u);
  EXPECT_EQ(Chip->L1->Ways, 3u);
  EXPECT_EQ(Chip->L1->Banks, 2u);
  EXPECT_EQ(Chip->L1->BankBytes, 8u);
  EXPECT_EQ(Chip->L1->Latency, 4u);
  EXPECT_EQ(Chip->L1->MissRegisters, 6u);
  EXPECT_EQ(Chip->L1->MergesPerMiss, 7u);
  EXPECT_EQ(Chip->L1->Writes, WritePolicy::Through);
  EXPECT_EQ(Chip->Crossbar->Latency, 9u);
  EXPECT_EQ(Chip->Crossbar->RequestBytesPerCycle, 8u);
  EXPECT_EQ(Chip->Crossbar->AnswerBytesPerCycle, 32u);
  EXPECT_EQ(Chip->Crossbar->HeaderBytes, 12u);
  EXPECT_EQ(Chip->TmsPerL2, 2u);
  EXPECT_EQ(Chip->L2->SectorBytes, 32u);
  EXPECT_EQ(Chip->L2->BankBytes, 4u);
  EXPECT_EQ(Chip->L2->MissRegisters, 20u);
  EXPECT_EQ(Chip->L2->Writes, WritePolicy::Back);
}

TEST(ChipMemory, ReadsEveryTimeOfTheDram) {
  llvm::Expected<ChipConfig> Chip = parseChip(withMemory(), "c.yaml", "c");
  ASSERT_TRUE(bool(Chip)) << llvm::toString(Chip.takeError());
  const DramConfig &D = *Chip->Dram;
  EXPECT_EQ(D.Name, "test");
  EXPECT_EQ(D.ClockKHz, 1000000u);
  EXPECT_EQ(D.Channels, 2u);
  EXPECT_EQ(D.BankGroups, 4u);
  EXPECT_EQ(D.BanksPerGroup, 2u);
  EXPECT_EQ(D.RowsPerBank, 8192u);
  EXPECT_EQ(D.RowBytes, 2048u);
  EXPECT_EQ(D.CommandBuses, 1u);
  EXPECT_EQ(D.RcdReadTicks, 11u);
  EXPECT_EQ(D.RcdWriteTicks, 12u);
  EXPECT_EQ(D.RpTicks, 13u);
  EXPECT_EQ(D.ClTicks, 14u);
  EXPECT_EQ(D.CwlTicks, 15u);
  EXPECT_EQ(D.RasTicks, 26u);
  EXPECT_EQ(D.RrdShortTicks, 3u);
  EXPECT_EQ(D.RrdLongTicks, 4u);
  EXPECT_EQ(D.FawTicks, 17u);
  EXPECT_EQ(D.WrTicks, 18u);
  EXPECT_EQ(D.WtrShortTicks, 5u);
  EXPECT_EQ(D.WtrLongTicks, 6u);
  EXPECT_EQ(D.RtwTicks, 19u);
  EXPECT_EQ(D.RtpTicks, 20u);
  EXPECT_EQ(D.CcdShortTicks, 2u);
  EXPECT_EQ(D.CcdLongTicks, 3u);
  EXPECT_EQ(D.RfcTicks, 100u);
  EXPECT_EQ(D.RefiTicks, 1000u);
  EXPECT_EQ(D.ReadQueueEntries, 30u);
  EXPECT_EQ(D.WriteQueueEntries, 31u);
  EXPECT_EQ(D.WriteHighMark, 29u);
  EXPECT_EQ(D.WriteLowMark, 28u);
  EXPECT_EQ(D.RowHitLimit, 3u);
  EXPECT_EQ(D.ControllerCycles, 7u);
}

TEST(ChipMemory, WritesWhatItReads) {
  llvm::Expected<ChipConfig> Chip = parseChip(withMemory(), "c.yaml", "c");
  ASSERT_TRUE(bool(Chip)) << llvm::toString(Chip.takeError());
  llvm::Expected<ChipConfig> Again = parseChip(written(*Chip), "d.yaml", "c");
  ASSERT_TRUE(bool(Again)) << llvm::toString(Again.takeError());
  EXPECT_EQ(written(*Chip), written(*Again));
  EXPECT_EQ(Again->L1->Bytes, 24u << 10);
  EXPECT_EQ(Again->L2->Writes, WritePolicy::Back);
  EXPECT_EQ(Again->Dram->RowHitLimit, 3u);
}

// The L1 takes 4 cycles, the header 12 bytes through 8 bytes a cycle, 1 more
// than the crossbar's 9, the L2 10, the way back 9: 33.
TEST(ChipMemory, WindowIsAtMostTheShortestRoundTrip) {
  std::string Fits =
      replaced(withMemory(), "window_cycles: 20", "window_cycles: 33");
  EXPECT_EQ(errorOf(Fits), "");
  EXPECT_THAT(errorWith("window_cycles: 20", "window_cycles: 34"),
              HasSubstr("c.yaml:6: 'arbitration_window_cycles' is 34; give it "
                        "at most the shortest round trip to memory, which is "
                        "33"));
}

TEST(ChipMemory, RefusesWhatDoesNotFitTogether) {
  const char *Cases[][3] = {
      {"bytes: 24 KiB", "bytes: 20 KiB", "'l1.bytes' is 20480; give it ways x"},
      {"sector_bytes: 16", "sector_bytes: 128", "at most l1.line_bytes"},
      {"sector_bytes: 16", "sector_bytes: 2", "'l1.sector_bytes' is '2'"},
      {"line_bytes: 64, sector_bytes: 16", "line_bytes: 96, sector_bytes: 16",
       "a power of two"},
      {"line_bytes: 64, sector_bytes: 16", "line_bytes: 128, sector_bytes: 4",
       "at least l1.line_bytes / 16, which is 8"},
      {"banks: 2,", "banks: 3,", "'l1.banks' is '3'"},
      {"writes: back", "writes: never", "give it through or back"},
      {"row_bytes: 2 KiB", "row_bytes: 2000", "a multiple of burst_bytes"},
      {"row:bank:bankgroup", "row:bank", "'memory.dram.address_mapping'"},
      {"rows_per_bank: 8192", "rows_per_bank: 1024",
       "'memory.bytes' is 67108864; give it at most what the DRAM holds, which "
       "is 33554432"},
      {"banks_per_group: 2", "banks_per_group: 17",
       "'memory.dram.banks_per_group' is 17; give it at most 16 with 4 bank "
       "groups"},
      {"ccd_short: 2", "ccd_short: 1", "at least burst_ticks, which is 2"},
      {"rrd_long: 4", "rrd_long: 2", "at least rrd_short, which is 3"},
      {"ras: 26", "ras: 10", "at least rcd_read, which is 11"},
      {"rfc: 100", "rfc: 1000", "at least rfc + 1, which is 1001"},
      {"cl: 14", "cl: 0", "'memory.dram.ticks.cl' is '0'"},
      {"write_low_mark: 28", "write_low_mark: 29", "less than write_high_mark"},
      {"write_high_mark: 29", "write_high_mark: 32", "at most write_entries"},
      {"  dram:\n", "  latency_cycles: 5\n  dram:\n",
       "'memory.latency_cycles' does nothing on a chip with memory.dram; leave "
       "one of them out"},
      {"source: \"nowhere\"", "source: \"\"",
       "'memory.dram.source' is nothing"},
  };
  for (auto &[From, To, Message] : Cases)
    EXPECT_THAT(errorWith(From, To), HasSubstr(Message)) << To;
}

class ChipSettings : public testing::Test {
protected:
  llvm::Expected<ChipConfig> Base = loadChip("report-512x8", TP_CHIP_FOLDER);

  std::string errorWith(const std::vector<std::string> &Settings) {
    llvm::Expected<ChipConfig> Chip =
        withSettings(*Base, Settings, {TP_CHIP_FOLDER});
    return Chip ? "" : llvm::toString(Chip.takeError());
  }
};

TEST_F(ChipSettings, AddAndRemoveSections) {
  ASSERT_TRUE(bool(Base));
  llvm::Expected<ChipConfig> Chip = withSettings(
      *Base,
      {"memory.dram=gddr6", "memory.dram.ticks.cl=30", "tm.count=256",
       "l1.bytes=8KiB", "l1.line_bytes=32", "l1.ways=1", "l1.banks=1",
       "l1.latency_cycles=2", "l1.miss_registers=4", "l1.merges_per_miss=4",
       "arbitration_window_cycles=10", "technology=none"},
      {TP_CHIP_FOLDER});
  ASSERT_TRUE(bool(Chip)) << llvm::toString(Chip.takeError());
  EXPECT_EQ(Chip->TmCount, 256u);
  EXPECT_EQ(Chip->Dram->ClTicks, 30u);
  EXPECT_EQ(Chip->L1->Bytes, 8u << 10);
  EXPECT_FALSE(Chip->Technology);
  llvm::Expected<ChipConfig> Without =
      withSettings(*Chip, {"memory.dram=none", "l1=none"}, {TP_CHIP_FOLDER});
  ASSERT_TRUE(bool(Without)) << llvm::toString(Without.takeError());
  EXPECT_FALSE(Without->hasMemorySystem());
  EXPECT_EQ(Without->MemoryLatency, 100u);
}

TEST_F(ChipSettings, NameTheFilesOfAFolder) {
  ASSERT_TRUE(bool(Base));
  EXPECT_THAT(errorWith({"memory.dram=gddr7"}),
              HasSubstr("; give it one of: gddr5, gddr6, hbm2"));
  EXPECT_THAT(errorWith({"technology=1nm"}),
              HasSubstr("; give it one of: simtrax-65nm"));
}

TEST_F(ChipSettings, KeepRequiredKeys) {
  ASSERT_TRUE(bool(Base));
  EXPECT_THAT(errorWith({"tm.count=none"}),
              HasSubstr("'tm.count' is 'none'; give it a whole number"));
  EXPECT_THAT(errorWith({"tm=none"}), HasSubstr("'tm' is a section with"));
  EXPECT_THAT(errorWith({"l1.bytes=1KiB"}),
              HasSubstr("--set 'l1.bytes=1KiB': key 'l1.line_bytes' is "
                        "missing"));
}

} // namespace
