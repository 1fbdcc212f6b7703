//===- IntervalTest.cpp - Series of intervals -----------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/stats/IntervalWriter.h"
#include "test/unit/stats/MemoryRun.h"

#include "llvm/Support/JSON.h"
#include "gmock/gmock.h"
#include "gtest/gtest.h"

#include <map>

using namespace tp;

static std::map<std::string, double> valuesOf(const SmallRun &Run) {
  std::map<std::string, double> Values;
  for (const IntervalFigure &Figure : intervalFigures(Run.Chip, Run.Stats))
    Values[Figure.Column] = Figure.Value;
  return Values;
}

TEST(IntervalFigures, TellCountsAndRates) {
  std::map<std::string, double> Values = valuesOf(MemoryRun());
  EXPECT_EQ(Values["instructions"], 110);
  EXPECT_DOUBLE_EQ(Values["instructions_per_cycle"], 1.1);
  EXPECT_EQ(Values["lost_memory"], 20);
  EXPECT_EQ(Values["lost_finished"], 60);
  EXPECT_EQ(Values["global_accesses"], 52);
  EXPECT_EQ(Values["l1_merged"], 2);
  EXPECT_DOUBLE_EQ(Values["l1_hit_rate"], 0.75);
  EXPECT_DOUBLE_EQ(Values["crossbar_answer_bytes_per_cycle"], 3.2);
  EXPECT_EQ(Values["dram_reads"], 6);
  EXPECT_DOUBLE_EQ(Values["dram_read_bytes_per_cycle"], 1.92);
  EXPECT_DOUBLE_EQ(Values["dram_row_hit_rate"], 0.25);
  EXPECT_DOUBLE_EQ(Values["dram_mean_read_queue"], 1);
}

TEST(IntervalFigures, HaveDistinctColumns) {
  MemoryRun Run;
  std::vector<IntervalFigure> Figures = intervalFigures(Run.Chip, Run.Stats);
  EXPECT_EQ(valuesOf(Run).size(), Figures.size());
  EXPECT_EQ(valuesOf(SmallRun()).count("l1_hits"), 0u);
}

static const std::vector<IntervalFigure> TwoFigures = {
    {"instructions", 12, true, "thread-cycles (%)", "issued", 0.5},
    {"lost_data", 4, true, "thread-cycles (%)", "data", 0.5},
    {"rate", 0.125, false},
};

TEST(IntervalWriter, WritesTables) {
  std::string Text;
  llvm::raw_string_ostream OS(Text);
  std::unique_ptr<IntervalWriter> Writer = makeCsvWriter(OS);
  Writer->write(0, 64, TwoFigures);
  Writer->write(64, 100, TwoFigures);
  Writer->finish();
  EXPECT_EQ(Text, "begin_cycle,end_cycle,instructions,lost_data,rate\n"
                  "0,64,12,4,0.125\n"
                  "64,100,12,4,0.125\n");
}

// At 2 GHz cycle 64 is at 32 ns. Figures without a track are not in the trace.
TEST(IntervalWriter, WritesTraces) {
  SmallRun Run;
  std::string Text;
  llvm::raw_string_ostream OS(Text);
  std::unique_ptr<IntervalWriter> Writer = makeTraceWriter(Run.Chip, OS);
  Writer->write(0, 64, TwoFigures);
  Writer->write(64, 100, TwoFigures);
  Writer->finish();
  llvm::Expected<llvm::json::Value> Parsed = llvm::json::parse(Text);
  ASSERT_TRUE(bool(Parsed)) << llvm::toString(Parsed.takeError());
  const llvm::json::Array &Events =
      *Parsed->getAsObject()->getArray("traceEvents");
  ASSERT_EQ(Events.size(), 4u);
  const llvm::json::Object &Second = *Events[2].getAsObject();
  EXPECT_EQ(Second.getString("ph"), "C");
  EXPECT_EQ(Second.getString("name"), "thread-cycles (%)");
  EXPECT_DOUBLE_EQ(*Second.getNumber("ts"), 0.032);
  EXPECT_EQ(Second.getObject("args")->getNumber("issued"), 6);
  EXPECT_EQ(Second.getObject("args")->getNumber("data"), 2);
  const llvm::json::Object &End = *Events[3].getAsObject();
  EXPECT_DOUBLE_EQ(*End.getNumber("ts"), 0.05);
  EXPECT_EQ(End.getObject("args")->getNumber("issued"), 0);
}
