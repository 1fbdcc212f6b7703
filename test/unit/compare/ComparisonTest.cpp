//===- ComparisonTest.cpp - Tests of the comparison of two runs -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/compare/Comparison.h"

#include "gmock/gmock.h"
#include "gtest/gtest.h"

using namespace llvm;
using namespace tp;
using testing::HasSubstr;

/// What --stats writes of two threads and \p Cycles cycles: one instruction on
/// a line, which waits for data in all other cycles but those that \p Finished
/// takes. \p More is put into it.
static std::string statistics(unsigned Cycles, unsigned Finished,
                              const std::string &More = "") {
  unsigned Data = 2 * Cycles - 1 - Finished;
  std::string Text = R"json({"format_version": 2, "mode": "cycle",
    "run": {"outcome": "finished", "cycles": $C, "instructions": 1},
    "chip": {"name": "small", "tm_count": 1, "tps_per_tm": 2},
    "thread_cycles": {"lost": {"data": $D, "finished": $F}},
    "instructions_by_opcode": {"add": {"executed": 1}}$M})json";
  for (const auto &[Name, Value] :
       {std::pair<std::string, std::string>("$C", std::to_string(Cycles)),
        {"$D", std::to_string(Data)},
        {"$F", std::to_string(Finished)},
        {"$M", More}})
    Text.replace(Text.find(Name), 2, Value);
  return Text;
}

/// The same by address: all of it at \p File:3.
static std::string byPc(unsigned Data, const std::string &File) {
  return R"json(, "instructions_by_pc": [{"pc": "0x00010000", "opcode": "add",
    "executed": 1, "function": "f()", "file": ")json" +
         File + R"json(", "line": 3, "lost": {"data": )json" +
         std::to_string(Data) + "}}]";
}

static Expected<ComparedRun> read(const std::string &Text,
                                  const std::string &Path = "run.json") {
  return readComparedRun(Path, Text);
}

static std::string errorOf(const std::string &Text) {
  Expected<ComparedRun> Run = read(Text);
  return Run ? "" : toString(Run.takeError());
}

TEST(Comparison, ChangesByReasonAndPlaceAreTheChange) {
  Expected<ComparedRun> Before = read(statistics(50, 9, byPc(90, "a.cpp")));
  Expected<ComparedRun> After = read(statistics(40, 0, byPc(79, "b.cpp")));
  ASSERT_TRUE(Before && After);
  Expected<Comparison> Runs = compare(*Before, *After);
  ASSERT_TRUE(bool(Runs));
  EXPECT_EQ(Runs->Counts.change(), -20);
  EXPECT_EQ(Runs->Counts.change(0), 0);
  EXPECT_EQ(Runs->Counts.change(useOf(Loss::Data)), -11);
  EXPECT_EQ(Runs->Counts.change(useOf(Loss::Finished)), -9);
  ASSERT_EQ(Runs->Lines.size(), 2u);
  EXPECT_EQ(Runs->Lines[0].Name, (SourceLine{"f()", "a.cpp", 3}));
  EXPECT_EQ(Runs->Lines[0].change(), -91);
  EXPECT_EQ(Runs->Lines[1].change(), 80);
  EXPECT_EQ(Runs->Functions.size(), 2u);
}

TEST(Comparison, NeedsLinesOfBothRuns) {
  Expected<ComparedRun> Before = read(statistics(50, 9, byPc(90, "a.cpp")));
  Expected<ComparedRun> After = read(statistics(40, 0));
  ASSERT_TRUE(Before && After);
  Expected<Comparison> Runs = compare(*Before, *After);
  ASSERT_TRUE(bool(Runs));
  EXPECT_FALSE(Runs->HasPlaces);
}

TEST(Comparison, ReadsProfiles) {
  Expected<ComparedRun> Run = read(R"json({"format_version": 1,
    "run": {"program": "a.elf", "outcome": "finished", "chip": "small",
            "clock_ghz": 1, "tm_count": 1, "tps_per_tm": 2, "cycles": 10,
            "thread_cycles": 20, "instructions": 4, "finished": 4},
    "files": [{"path": "a.cpp"}],
    "functions": [{"name": "g()"}, {"name": "f()"}],
    "frames": [{"function": 0, "file": 0, "line": 7},
               {"function": 1, "file": 0, "line": 3, "inlined_into": 0}],
    "instructions": [
      {"pc": "0x00010000", "text": "lw r1, 0(r2)", "frame": 1, "executed": 2,
       "lost": {}, "global": 2, "served": {
       "dram_queue": {"accesses": 1, "cycles": 10},
       "dram_row_hit": {"accesses": 1, "cycles": 20}}},
      {"pc": "0x00010004", "text": "halt", "frame": 0, "executed": 2,
       "lost": {"dram": 12}}],
    "call_tree": [],
    "utilisation": {"ends": [10], "chip": [{"instructions": 4,
      "lost": {"dram": 12, "finished": 4}}], "issued": [[4]],
      "memory": [[12]], "finished": [[4]]},
    "statistics": {"rays": {"per_second": 5}}})json");
  ASSERT_TRUE(bool(Run)) << toString(Run.takeError());
  EXPECT_EQ(Run->Counts[0], 4);
  EXPECT_EQ(Run->Counts[useOf(Loss::Dram)], 12);
  EXPECT_EQ(Run->Counts[useOf(Loss::Finished)], 4);
  EXPECT_EQ(Run->Lines->size(), 2u);
  EXPECT_EQ((*Run->Lines)[(SourceLine{"f()", "a.cpp", 3})][0], 2);
  EXPECT_EQ(Run->Opcodes["lw"], 2);
  ASSERT_EQ(Run->Figures.size(), 3u);
  EXPECT_EQ(Run->Figures[0].Value, 5);
  EXPECT_EQ(Run->Figures[2].Value, 15);
}

TEST(Comparison, RefusesCountsThatDoNotAddUp) {
  std::string Text = statistics(50, 9);
  Text.replace(Text.find("\"data\": 90"), 10, "\"data\": 89");
  EXPECT_THAT(errorOf(Text),
              HasSubstr("run.json: 99 thread-cycles by reason for 2 threads "
                        "and 50 cycles"));
  EXPECT_THAT(
      errorOf(statistics(50, 9, byPc(89, "a.cpp"))),
      HasSubstr("run.json: 90 thread-cycles 'data', but by address 89"));
}

TEST(Comparison, SaysWhatIsNotAsItShouldBe) {
  EXPECT_THAT(errorOf("[]"), HasSubstr("run.json"));
  EXPECT_THAT(errorOf("{}"), HasSubstr("format_version"));
  std::string Text = statistics(50, 9);
  Text.replace(Text.find("data"), 4, "luck");
  EXPECT_THAT(errorOf(Text), HasSubstr("no reason that this tpsim knows at "
                                       "run.json.thread_cycles.lost.luck"));
  EXPECT_THAT(errorOf(R"json({"format_version": 1, "frames": []})json"),
              HasSubstr("run.json: "));
}

TEST(Comparison, RefusesDifferentModes) {
  Expected<ComparedRun> Timed = read(statistics(50, 9), "timed.json");
  Expected<ComparedRun> Functional = read(R"json({"format_version": 2,
    "mode": "functional", "run": {"outcome": "finished", "instructions": 1},
    "chip": {"name": "small", "tm_count": 1, "tps_per_tm": 2},
    "instructions_by_opcode": {"add": {"executed": 1}}})json",
                                          "functional.json");
  ASSERT_TRUE(Timed && Functional);
  Expected<Comparison> Runs = compare(*Timed, *Functional);
  ASSERT_FALSE(bool(Runs));
  EXPECT_THAT(toString(Runs.takeError()),
              HasSubstr("functional.json is of a functional run"));
}
