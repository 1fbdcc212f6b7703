//===- ValuesTest.cpp - Variables against what the source says -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// test/Debug/values.cpp says behind each call of probe() what its variables are
// there.
//
//===----------------------------------------------------------------------===//

#include "debugger/source/Expression.h"
#include "debugger/source/ValuePrinter.h"
#include "test/unit/source/DebuggedProgram.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/MemoryBuffer.h"

#include <gtest/gtest.h>
#include <map>
#include <set>

using namespace llvm;
using namespace tp;
using namespace tp::test;

/// What a line says: names with the values of the visits in turn.
using Claims = std::vector<std::pair<std::string, std::vector<std::string>>>;

static std::map<unsigned, Claims> readClaims(const std::string &Path) {
  std::map<unsigned, Claims> Result;
  auto Text = MemoryBuffer::getFile(Path);
  EXPECT_TRUE(bool(Text));
  SmallVector<StringRef> Lines;
  (*Text)->getBuffer().split(Lines, '\n');
  for (unsigned I = 0; I != Lines.size(); ++I) {
    auto [Code, Comment] = Lines[I].split("probe(); // ");
    for (StringRef Word : split(Comment, ' ')) {
      auto [Name, Values] = Word.trim().split('=');
      if (Values.empty())
        continue;
      std::vector<std::string> Visits;
      for (StringRef Value : split(Values, '|'))
        Visits.push_back(Value.str());
      Result[I + 1].push_back({Name.str(), Visits});
    }
  }
  return Result;
}

namespace {

struct Tally {
  unsigned Right = 0;
  std::set<std::string> Missing;
};

} // namespace

static Tally checkValues(const std::vector<std::string> &Options) {
  DebuggedProgram Program("Debug/values.cpp", Options);
  std::map<unsigned, Claims> Lines =
      readClaims(std::string(TP_TESTS) + "/Debug/values.cpp");
  EXPECT_GT(Lines.size(), 25u);
  std::map<unsigned, unsigned> Visits;
  Tally Result;
  Program.runToCallsOf("probe", [&](const FrameContext &Frame) {
    unsigned Line =
        Program.map().callsAt(Frame.lookupPc()).front().Position.Line;
    unsigned Visit = Visits[Line]++;
    for (const auto &[Name, Values] : Lines[Line]) {
      Expected<Expression> Parsed =
          Expression::parse(Name, Program.information(), &Frame);
      ASSERT_TRUE(bool(Parsed)) << toString(Parsed.takeError());
      Expected<Value> Found = Parsed->evaluate(Frame);
      ASSERT_TRUE(bool(Found)) << Name << ": " << toString(Found.takeError());
      Expected<double> Number = Found->asReal(Frame);
      if (!Number) {
        std::string Reason = toString(Number.takeError());
        EXPECT_EQ(Reason, "the value has been optimized out");
        Result.Missing.insert(Name);
        continue;
      }
      EXPECT_EQ(*Number, std::stod(Values[Visit % Values.size()]))
          << "line " << Line << ": " << Name;
      ++Result.Right;
    }
  });
  for (const auto &[Line, Unused] : Lines)
    EXPECT_TRUE(Visits.count(Line)) << "line " << Line << " is not reached";
  return Result;
}

/// What result() returns is where a register points that calls overwrite: its
/// caller cannot be sure to have it while probe() runs.
static const std::set<std::string> Overwritten = {"L.Small", "L.Tiny",
                                                  "L.Values[3]"};

TEST(Values, AreAllAvailableWithoutOptimization) {
  Tally Result = checkValues({"-O0", "-g"});
  EXPECT_EQ(Result.Missing, Overwritten);
  EXPECT_GE(Result.Right, 137u);
}

// One or two less than test/Debug/values.cpp demands, which believes in
// registers that probe() could have overwritten.
TEST(Values, AreRightOrMissingInOptimizedCode) {
  EXPECT_GE(checkValues({"-O2", "-g"}).Right, 115u);
  EXPECT_GE(checkValues({"-O3", "-g", "-fno-lto"}).Right, 118u);
}

TEST(Values, AreThereInOlderVersionsOfDwarf) {
  for (const char *Version : {"-gdwarf-4", "-gdwarf-3", "-gdwarf-2"})
    EXPECT_EQ(checkValues({"-O0", "-g", Version}).Missing, Overwritten)
        << Version;
}

/// Prints every variable of every frame and counts those with an error.
static void printEverything(const char *Source, const char *Level) {
  DebuggedProgram Program(Source, {Level, "-g"});
  const Variables &Names = Program.information().variables();
  ValuePrinter Printer(Program.map());
  unsigned Steps = 0, Printed = 0;
  Program.run([&](const FrameContext &Innermost) {
    if (Steps++ % 13)
      return;
    for (const Frame &Part : Program.backtrace(Innermost)) {
      std::vector<VariableInfo> All = Names.arguments(Part.Context);
      append_range(All, Names.locals(Part.Context));
      for (const VariableInfo &Info : All) {
        Expected<Value> Found = Names.value(Info, Part.Context);
        ASSERT_TRUE(bool(Found))
            << Info.Name << ": " << toString(Found.takeError());
        EXPECT_NE(Printer.print(*Found, Part.Context), "") << Info.Name;
        ++Printed;
      }
    }
  });
  EXPECT_GT(Printed, 50u);
}

static std::string namesAt(DebuggedProgram &Program, const FrameContext &At) {
  const Variables &Names = Program.information().variables();
  std::string Result;
  for (const VariableInfo &Info : Names.arguments(At))
    Result += Info.Name + " ";
  Result += "|";
  for (const VariableInfo &Info : Names.locals(At))
    Result += " " + Info.Name + (Info.IsShadowed ? "(shadowed)" : "");
  return Result;
}

TEST(Values, ScopesHaveTheirVariables) {
  DebuggedProgram Program("unit/source/Inputs/expressions.cpp", {"-O0", "-g"});
  std::vector<std::string> Found;
  Program.runToCallsOf("stop", [&](const FrameContext &Frame) {
    Found.push_back(namesAt(Program, Frame));
  });
  EXPECT_EQ(Found,
            std::vector<std::string>(
                {"A B F Ref Pointer M | X Small Byte Letter Yes Paint Odd "
                 "State List Position Where Raw Span Alias",
                 "this Scale | Local", "Root |"}));
  DebuggedProgram Blocks("Debug/values.cpp", {"-O0", "-g"});
  std::set<std::string> All;
  Blocks.runToCallsOf("probe", [&](const FrameContext &Frame) {
    All.insert(namesAt(Blocks, Frame));
  });
  EXPECT_TRUE(All.count("A | R Visits R(shadowed)")) << join(All, "\n");
  EXPECT_TRUE(All.count("A | Visits R")) << join(All, "\n");
}

TEST(Values, InlinedFunctionsHaveTheirVariables) {
  DebuggedProgram Program("Debug/values.cpp", {"-O2", "-g"});
  std::set<std::string> All;
  Program.runToCallsOf("probe", [&](const FrameContext &Frame) {
    All.insert(namesAt(Program, Frame));
  });
  EXPECT_TRUE(All.count("Q W | M")) << join(All, "\n");
}

TEST(Values, AllCanBePrintedEverywhere) {
  for (const char *Level : {"-O0", "-O2", "-Os"}) {
    printEverything("Debug/values.cpp", Level);
    printEverything("unit/source/Inputs/expressions.cpp", Level);
  }
}
