//===- ReportTest.cpp - Statistics for programs and for people ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/stats/JsonReport.h"
#include "simulator/stats/TableReport.h"
#include "test/unit/stats/MemoryRun.h"

#include "llvm/Support/JSON.h"
#include "gmock/gmock.h"
#include "gtest/gtest.h"

using namespace tp;
using testing::HasSubstr;

static std::string json(const RunSummary &Run) {
  std::string Text;
  llvm::raw_string_ostream OS(Text);
  writeJson(Run, OS);
  return Text;
}

static std::string table(const RunSummary &Run, HostSpeed Speed = {2, 1}) {
  std::string Text;
  llvm::raw_string_ostream OS(Text);
  writeTable(Run, Speed, OS);
  return Text;
}

TEST(JsonReport, SpellsTheCountsOut) {
  SmallRun Small;
  Small.Stats.Markers = {0, 0, 7};
  RunSummary Run = Small.summary();
  Run.Rays = {5, 10};
  Run.Image = ImageSettings{32, 16, 4, 2, 9};
  llvm::Expected<llvm::json::Value> Parsed = llvm::json::parse(json(Run));
  ASSERT_TRUE(bool(Parsed)) << llvm::toString(Parsed.takeError());
  const llvm::json::Object &Root = *Parsed->getAsObject();
  EXPECT_EQ(Root.getInteger("format_version"), JsonFormatVersion);
  EXPECT_EQ(Root.getObject("run")->getInteger("cycles"), 100);
  EXPECT_EQ(Root.getObject("run")->getString("outcome"), "finished");
  const llvm::json::Object *Cycles = Root.getObject("thread_cycles");
  EXPECT_EQ(Cycles->getInteger("total"), 200);
  EXPECT_EQ(Cycles->getInteger("issued"), 110);
  EXPECT_EQ(Cycles->getObject("lost")->getInteger("memory"), 20);
  EXPECT_EQ(Cycles->getObject("lost")->getInteger("finished"), 60);
  const llvm::json::Object *Opcodes = Root.getObject("instructions_by_opcode");
  EXPECT_EQ(Opcodes->size(), 2u);
  EXPECT_EQ(Opcodes->getObject("lw")->getInteger("data_stall_cycles"), 20);
  EXPECT_EQ(Opcodes->getObject("add")->getInteger("unit_conflict_cycles"), 10);
  EXPECT_EQ(
      Root.getObject("units")->getObject("INTADD")->getNumber("utilisation"),
      0.5);
  EXPECT_EQ(Root.getObject("markers")->getInteger("2"), 7);
  EXPECT_EQ(Root.getObject("rays")->getInteger("total"), 15);
  EXPECT_EQ(Root.getObject("image")->getInteger("samples_per_pixel"), 4);
  EXPECT_EQ(Root.getObject("threads")->getArray("finish_cycle")->size(), 2u);
}

TEST(JsonReport, LeavesOutWhatTheRunDidNotHave) {
  SmallRun Small;
  llvm::Expected<llvm::json::Value> Parsed =
      llvm::json::parse(json(Small.summary()));
  ASSERT_TRUE(bool(Parsed));
  EXPECT_EQ(Parsed->getAsObject()->get("rays"), nullptr);
  EXPECT_EQ(Parsed->getAsObject()->get("image"), nullptr);
  EXPECT_EQ(Parsed->getAsObject()->get("memory"), nullptr);
  EXPECT_EQ(Parsed->getAsObject()->get("energy"), nullptr);
  EXPECT_EQ(Parsed->getAsObject()->get("instructions_by_pc"), nullptr);
}

// 100 additions of 0.5 nJ and 6 reads of 1 nJ in 50 ns.
TEST(JsonReport, TellsEnergyAndArea) {
  MemoryRun Small;
  RunSummary Run = Small.summary();
  Run.Rays = {3, 4};
  llvm::Expected<llvm::json::Value> Parsed = llvm::json::parse(json(Run));
  ASSERT_TRUE(bool(Parsed)) << llvm::toString(Parsed.takeError());
  const llvm::json::Object &Energy =
      *Parsed->getAsObject()->getObject("energy");
  EXPECT_DOUBLE_EQ(*Energy.getNumber("joules"), 56e-9);
  EXPECT_DOUBLE_EQ(*Energy.getNumber("watts"), 56.0 / 50);
  EXPECT_DOUBLE_EQ(*Energy.getNumber("nanojoules_per_ray"), 8);
  const llvm::json::Object &Adders =
      *Energy.getObject("parts")->getObject("INTADD");
  EXPECT_DOUBLE_EQ(*Adders.getNumber("watts"), 1);
  EXPECT_EQ(Adders.getBoolean("assumption"), true);
  EXPECT_EQ(Adders.getString("source"), "a guess");
  const llvm::json::Object &Chip = *Parsed->getAsObject()->getObject("chip");
  EXPECT_EQ(Chip.getObject("area_mm2")->getNumber("total"), 0.5);
}

TEST(JsonReport, TellsWhatTheMemoryDid) {
  MemoryRun Small;
  llvm::Expected<llvm::json::Value> Parsed =
      llvm::json::parse(json(Small.summary()));
  ASSERT_TRUE(bool(Parsed)) << llvm::toString(Parsed.takeError());
  const llvm::json::Object &Memory =
      *Parsed->getAsObject()->getObject("memory");
  EXPECT_EQ(Memory.getObject("l1")->getInteger("hits"), 30);
  EXPECT_EQ(Memory.getObject("l1")->getNumber("hit_rate"), 0.75);
  EXPECT_EQ(Memory.getObject("crossbar")->getInteger("request_bytes"), 160);
  const llvm::json::Object &Dram = *Memory.getObject("dram");
  EXPECT_EQ(Dram.getInteger("reads"), 6);
  EXPECT_EQ(Dram.getObject("bandwidth")->getNumber("share_of_peak"), 0.16);
  const llvm::json::Array &Channels = *Dram.getArray("channels");
  ASSERT_EQ(Channels.size(), 2u);
  const llvm::json::Object &Second = *Channels[1].getAsObject();
  EXPECT_EQ(Second.getInteger("max_read_queue"), 4);
  EXPECT_EQ((*Second.getArray("read_latency_histogram"))[6].getAsInteger(), 3);
}

TEST(JsonReport, TellsOfInstructionsIfAsked) {
  SmallRun Small;
  RunSummary Run = Small.summary();
  Run.FramesOf = [](uint32_t Pc) -> std::vector<SourceFrame> {
    if (Pc == 0x10000)
      return {{"inner", "a.h", 3, 7, "a.h", 2},
              {"main", "a.cpp", 9, 0, "a.cpp", 8}};
    return {};
  };
  llvm::Expected<llvm::json::Value> Parsed = llvm::json::parse(json(Run));
  ASSERT_TRUE(bool(Parsed)) << llvm::toString(Parsed.takeError());
  const llvm::json::Array &Pcs =
      *Parsed->getAsObject()->getArray("instructions_by_pc");
  ASSERT_EQ(Pcs.size(), 2u);
  const llvm::json::Object &Add = *Pcs[0].getAsObject();
  EXPECT_EQ(Add.getString("pc"), "0x00010000");
  EXPECT_EQ(Add.getString("opcode"), "add");
  EXPECT_EQ(Add.getObject("lost")->size(), 2u);
  EXPECT_EQ(Add.getObject("lost")->getInteger("memory"), 20);
  EXPECT_EQ(Add.getString("function"), "inner");
  const llvm::json::Object &Caller =
      *(*Add.getArray("inlined_into"))[0].getAsObject();
  EXPECT_EQ(Caller.getInteger("line"), 9);
  EXPECT_EQ(Pcs[1].getAsObject()->get("function"), nullptr);
}

TEST(TableReport, ShowsSharesOfThreadCycles) {
  SmallRun Small;
  std::string Text = table(Small.summary());
  EXPECT_THAT(Text, HasSubstr("issued             55.0 %   add 50.0 %, lw"));
  EXPECT_THAT(Text, HasSubstr("memory             10.0 %   lw 10.0 %"));
  EXPECT_THAT(Text, HasSubstr("unit conflict       5.0 %   add 5.0 %"));
  EXPECT_THAT(Text, HasSubstr("finished           30.0 %"));
  EXPECT_THAT(Text, HasSubstr("simulated in 2.00 s on 1 host thread: 0.0 "));
}

TEST(TableReport, ShowsLevelsAndCosts) {
  std::string Text = table(MemoryRun().summary());
  EXPECT_THAT(Text, HasSubstr("memory             10.0 %   under way 10.0"));
  EXPECT_THAT(Text, HasSubstr("INTADD               1               100"
                              "    50.0 %     0.50*     1.00*\n"));
  EXPECT_THAT(Text, HasSubstr("hits 75.0 %, merged 5.0 %"));
  EXPECT_THAT(Text, HasSubstr("0.12   5.1 GB/s, row hits 25.0 %"));
}

TEST(TableReport, FitsOneScreen) {
  MemoryRun Small;
  RunSummary Run = Small.summary();
  Run.Rays = {5, 10};
  RayProfile Profile;
  Profile.ClosestHitRays = 15;
  Profile.Cache.emplace();
  Run.RayProfiles = {Profile, Profile};
  for (unsigned I = 0; I != NumLosses; ++I)
    Small.Stats.Threads[0].Lost[I] = 3;
  std::string Text = table(Run);
  size_t Lines = 0;
  for (size_t Begin = 0; Begin < Text.size(); ++Lines) {
    size_t End = Text.find('\n', Begin);
    EXPECT_LE(End - Begin, 100u) << Text.substr(Begin, End - Begin);
    Begin = End + 1;
  }
  EXPECT_LE(Lines, 50u) << Text;
}
