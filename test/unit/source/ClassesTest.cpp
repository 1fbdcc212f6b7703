//===- ClassesTest.cpp - Expressions over classes and odd objects --------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/source/DebuggedProgram.h"

#include <gtest/gtest.h>
#include <initializer_list>
#include <utility>

using namespace llvm;
using namespace tp;
using namespace tp::test;

namespace {

/// The program, stopped in classes(), Table::sum() and the lambda of
/// Holder::run().
class ClassesTest : public testing::Test {
protected:
  static inline std::unique_ptr<DebuggedProgram> Program;

  static void SetUpTestSuite() {
    Program = std::make_unique<DebuggedProgram>(
        "unit/source/Inputs/classes.cpp",
        std::vector<std::string>{"-O0", "-g", "-fstandalone-debug"});
  }
  static void TearDownTestSuite() { Program.reset(); }

  using Cases = std::initializer_list<std::pair<const char *, const char *>>;

  void check(unsigned Stop, Cases Expressions) {
    unsigned Count = 0;
    Program->runToCallsOf("stop", [&](const FrameContext &Frame) {
      if (Count++ != Stop)
        return;
      for (const auto &[Expression, Result] : Expressions)
        EXPECT_EQ(print(Program->information(), Frame, Expression), Result)
            << Expression;
    });
    EXPECT_GT(Count, Stop);
  }
};

} // namespace

TEST_F(ClassesTest, CastsBetweenBasesAdjustThePointer) {
  check(0, {{"((Right *)B)->InRight", "2"},
            {"static_cast<Right *>(B) == R", "true"},
            {"((Both *)R)->Own", "3"},
            {"static_cast<Both &>(Reference).Own", "3"},
            {"((Right &)*B).InRight", "2"},
            {"((Right)*B).InRight", "2"},
            {"reinterpret_cast<Right *>(B)->InRight", "1"},
            {"(Right *)0 == 0", "true"},
            {"(long)(Right *)(Both *)0", "0"},
            {"(long)(Left *)B == (long)B", "true"},
            {"(Joined *)S", "error: A virtual base does not say where the "
                            "Joined around it is."}});
}

TEST_F(ClassesTest, VirtualBasesAreFoundByTheVtable) {
  check(0, {{"J->Common", "40"},
            {"Copy.Common", "40"},
            {"Copy.Shared::Common", "40"},
            {"(Copy.Common = 44, Copy.Common)", "44"},
            {"((Shared *)J)->Common", "40"},
            {"(Shared *)J == S", "true"},
            {"((Second *)J)->Common + ((Second *)J)->InSecond", "82"},
            {"((Shared &)Copy).Common", "44"},
            {"Copy.Nowhere::Common", "error: There is no base named Nowhere."},
            {"((Joined *)0)->Common",
             "error: Cannot access memory at address 0x0"}});
}

TEST_F(ClassesTest, FunctionPointersAreTypes) {
  check(0, {{"(int (*)(int))twice == Function", "true"},
            {"sizeof(int (*)(int, float *))", "4"},
            {"sizeof(void (**)(void))", "4"},
            {"*(int (**)(int))&Function == Function", "true"},
            {"(int (*)(5))0", "error: A syntax error in expression, near `5))0"
                              "'."},
            {"(int (*)(int",
             "error: A syntax error at the end of the expression."}});
}

TEST_F(ClassesTest, TargetsAreEvaluatedOnce) {
  check(0, {{"List[X++] += 100", "107"},
            {"X", "1"},
            {"List[X++]++", "8"},
            {"X", "2"},
            {"List[0] + List[1] + List[2]", "125"},
            {"X = 0, List[0] = 7, List[1] = 8", "8"}});
}

TEST_F(ClassesTest, IndicesMayBeNegative) {
  check(0, {{"*(&List + 0)@1", "{{7, 8, 9, 10}}"},
            {"(&List[2])[-1]", "8"},
            {"(*(int (*)[2])&List[2])[-1]", "8"}});
}

TEST_F(ClassesTest, NumbersOfOddTypes) {
  check(0, {{"Half", "1.5"},
            {"Half * 2", "3"},
            {"Brain", "-2.5"},
            {"(Half = 0.25f, Half)", "0.25"},
            {"Complex", "{1.5, -2}"},
            {"Complex[1]", "-2"},
            {"Huge", "0x00000010000000000000000000000000"},
            {"sizeof(Bits.Narrow + 1)", "4"},
            {"sizeof(Bits.Wide + 1)", "8"},
            {"Bits.Narrow - 6", "-1"},
            {"1'000.5", "1000.5"},
            {"(std::nullptr_t)0 == 0", "true"},
            {"(std::nullptr_t)0 + 1 == 1", "true"},
            {"*(std::nullptr_t)0",
             "error: a pointer to void points to no object"}});
}

TEST_F(ClassesTest, OnlyIntegersCountAndAreAddresses) {
  check(0, {{"{int} B->Own", "<error: Cannot access memory at address 0x3>"},
            {"{int} *B", "error: A value of type Both is no integer."},
            {"{int} 1.5", "error: A value of type double is no integer."},
            {"List[0]@2.0", "error: A value of type double is no integer."},
            {"List[0]@Reference.InRight", "{7, 8}"}});
}

TEST_F(ClassesTest, ObjectsOfVariableSize) {
  check(0, {{"Grid", "{{0, 1, 2}, {10, 11, 12}}"},
            {"Grid[1][2]", "12"},
            {"sizeof(Grid)", "24"}});
}

TEST_F(ClassesTest, TemplatesHaveTheirArguments) {
  check(1, {{"N", "3"}, {"Step", "2"}, {"N * Step", "6"}, {"Result", "3"}});
}

TEST_F(ClassesTest, LambdasSeeWhatTheyHold) {
  check(2, {{"Held", "60"},
            {"this->Held", "60"},
            {"Outer", "61"},
            {"Given + 0", "63"},
            {"Inner", "62"},
            {"Nothing", "error: No symbol \"Nothing\" in current context."}});
}

TEST_F(ClassesTest, LongExpressionsAreRefused) {
  std::string Sum = "1";
  for (unsigned I = 0; I != 900; ++I)
    Sum += "+1";
  check(0, {{Sum.c_str(), "901"}});
  for (unsigned I = 0; I != 100000; ++I)
    Sum += "+1";
  check(0, {{Sum.c_str(), "error: The expression is too long."}});
}

TEST_F(ClassesTest, HugeArraysArePrintedInPart) {
  unsigned Count = 0;
  Program->runToCallsOf("stop", [&](const FrameContext &Frame) {
    if (Count++ != 0)
      return;
    std::string Text = print(Program->information(), Frame,
                             "*(unsigned char (*)[500][500][500][500])&List");
    EXPECT_LT(Text.size(), 1u << 20);
    EXPECT_EQ(print(Program->information(), Frame,
                    "(*(int (*)[500000000])&List) = (*(int "
                    "(*)[500000000])&Grid)"),
              "error: a value of 2000000000 bytes is too large to read");
  });
}

TEST(Classes, UnnamedNamespacesHaveFunctionsWithoutDebugInformation) {
  DebuggedProgram Program("unit/source/Inputs/classes.cpp", {"-O0", "-g0"});
  const SourceMap &Map = Program.map();
  std::vector<uint32_t> Found = Map.findFunctions("unnamed");
  ASSERT_EQ(Found.size(), 1u);
  EXPECT_EQ(Map.function(Found[0]).QualifiedName,
            "(anonymous namespace)::unnamed");
}
