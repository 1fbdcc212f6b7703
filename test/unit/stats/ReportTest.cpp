//===- ReportTest.cpp - Statistics for programs and for people ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/stats/JsonReport.h"
#include "simulator/stats/TableReport.h"
#include "test/unit/stats/SmallRun.h"

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

TEST(TableReport, FitsOneScreen) {
  SmallRun Small;
  RunSummary Run = Small.summary();
  Run.Rays = {5, 10};
  for (unsigned I = 0; I != NumLosses; ++I)
    Small.Stats.Threads[0].Lost[I] = 3;
  std::string Text = table(Run);
  size_t Lines = 0;
  for (size_t Begin = 0; Begin < Text.size(); ++Lines) {
    size_t End = Text.find('\n', Begin);
    EXPECT_LE(End - Begin, 80u) << Text.substr(Begin, End - Begin);
    Begin = End + 1;
  }
  EXPECT_LE(Lines, 42u);
}
