//===- PrinterTest.cpp - Values as text ----------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/source/Children.h"
#include "debugger/source/Expression.h"
#include "debugger/source/ValuePrinter.h"
#include "test/unit/source/DebuggedProgram.h"

#include <gtest/gtest.h>

using namespace llvm;
using namespace tp;
using namespace tp::test;

namespace {

/// Calls \p Function in expressions().
void atStop(const std::function<void(DebuggedProgram &, const FrameContext &)>
                &Function) {
  DebuggedProgram Program("unit/source/Inputs/expressions.cpp",
                          {"-O0", "-g", "-fstandalone-debug"});
  bool Done = false;
  Program.runToCallsOf("stop", [&](const FrameContext &Frame) {
    if (!Done)
      Function(Program, Frame);
    Done = true;
  });
  EXPECT_TRUE(Done);
}

} // namespace

TEST(Printer, ValuesOfEachType) {
  atStop([](DebuggedProgram &Program, const FrameContext &Frame) {
    auto Print = [&](const char *Text) {
      return print(Program.information(), Frame, Text);
    };
    EXPECT_EQ(Print("Small"), "-3");
    EXPECT_EQ(Print("Byte"), "250 '\\372'");
    EXPECT_EQ(Print("Letter"), "113 'q'");
    EXPECT_EQ(Print("Yes"), "true");
    EXPECT_EQ(Print("Paint"), "Green");
    EXPECT_EQ(Print("Odd"), "9");
    EXPECT_EQ(Print("Access"), "(Readable | Runnable)");
    EXPECT_EQ(Print("State"), "Mode::On");
    EXPECT_EQ(Print("F"), "2.5");
    EXPECT_EQ(Print("Single"), "0.1");
    EXPECT_EQ(Print("Precise"), "0.1");
    EXPECT_EQ(Print("Long"), "-5000000000");
    EXPECT_EQ(Print("Huge"), "18446744073709551615");
    EXPECT_EQ(Print("Position"), "{X = 1, Y = 2, Z = 3}");
    EXPECT_EQ(Print("M"), "{Letter = 109 'm', Small = -9, Yes = true}");
    EXPECT_EQ(Print("List"), "{1, 2, 3, 4, 5}");
    EXPECT_EQ(Print("Matrix"), "{{0, 1, 2, 3}, {4, 5, 6, 7}, {8, 9, 10, 11}}");
    EXPECT_EQ(Print("Text"), "\"tabs\\tand \\\"q\\\"\"");
    EXPECT_EQ(Print("Raw"), Print("&X").replace(0, 7, "(void *)"));
    EXPECT_EQ(Print("Zeros"), "{0 <repeats 40 times>}");
    EXPECT_EQ(Print("Four"), "{10, 20, 30, 40}");
    EXPECT_EQ(Print("Span"), "{1, 2, 3}");
    EXPECT_EQ(Print("View"), "\"tabs\"");
    EXPECT_EQ(Print("Boxed"), "{Items = {7, 8, 9}, Used = 2}");
    EXPECT_NE(Print("Words").find("\"one\", 0x"), std::string::npos);
    EXPECT_NE(Print("Words").find("\"two\", 0x0}"), std::string::npos);
    EXPECT_NE(Print("Operation").find("<scene::twice(int)>"), std::string::npos)
        << Print("Operation");
    EXPECT_NE(Print("scene::twice").find("{int (int)} 0x"), std::string::npos)
        << Print("scene::twice");
    EXPECT_NE(Print("&Global").find("<Global>"), std::string::npos);
    std::string Ball = Print("Ball");
    EXPECT_NE(Ball.find("<scene::Shape> = {_vptr$Shape = 0x"),
              std::string::npos)
        << Ball;
    EXPECT_NE(Ball.find("Id = 41}, Center = {X = 1.5, Y = -2, Z = 0.25}, "
                        "Radius = 3, Visible = 1, Level = -7, Wide = 654321, "
                        "{AsInteger = 1078530011, AsFloat = 3.1415927}, State "
                        "= Mode::On, Name = 0x"),
              std::string::npos)
        << Ball;
    EXPECT_NE(Ball.find("\"ball\", Next = 0x"), std::string::npos) << Ball;
    EXPECT_EQ(Print("Ref").substr(0, 3), "@0x");
  });
}

TEST(Printer, FormatLetters) {
  atStop([](DebuggedProgram &Program, const FrameContext &Frame) {
    auto Print = [&](const char *Text, char Format) {
      return print(Program.information(), Frame, Text, Format);
    };
    EXPECT_EQ(Print("Byte", 'x'), "0xfa");
    EXPECT_EQ(Print("Byte", 'd'), "-6");
    EXPECT_EQ(Print("Byte", 'u'), "250");
    EXPECT_EQ(Print("Byte", 'o'), "0372");
    EXPECT_EQ(Print("Byte", 't'), "11111010");
    EXPECT_EQ(Print("65", 'c'), "65 'A'");
    EXPECT_EQ(Print("A", 'z'), "0x00000005");
    EXPECT_EQ(Print("-1", 'x'), "0xffffffff");
    EXPECT_EQ(Print("1078530011", 'f'), "3.1415927");
    EXPECT_EQ(Print("F", 'x'), "0x40200000");
    EXPECT_EQ(Print("F", 'd'), "2");
    EXPECT_EQ(Print("List", 'x'), "{0x1, 0x2, 0x3, 0x4, 0x5}");
    EXPECT_EQ(Print("Position", 'x'),
              "{X = 0x3f800000, Y = 0x40000000, Z = 0x40400000}");
    EXPECT_EQ(Print("Text", 's'), "\"tabs\\tand \\\"q\\\"\"");
    EXPECT_NE(Print("Operation", 'a').find("<scene::twice(int)>"),
              std::string::npos);
    EXPECT_EQ(Print("Long", 'x'), "0xfffffffed5fa0e00");
  });
}

TEST(Printer, LimitsAndPrettyPrinting) {
  atStop([](DebuggedProgram &Program, const FrameContext &Frame) {
    auto Print = [&](const char *Text, const PrintOptions &Options) {
      Expected<Expression> Parsed =
          Expression::parse(Text, Program.information(), &Frame);
      EXPECT_TRUE(bool(Parsed));
      Expected<Value> Result = Parsed->evaluate(Frame);
      EXPECT_TRUE(bool(Result));
      return ValuePrinter(Program.map()).print(*Result, Frame, Options);
    };
    PrintOptions Options;
    Options.MaxElements = 2;
    EXPECT_EQ(Print("List", Options), "{1, 2...}");
    EXPECT_EQ(Print("Text", Options), "\"ta\"...");
    Options = {};
    Options.MaxDepth = 1;
    EXPECT_EQ(Print("Matrix", Options), "{{...}, {...}, {...}}");
    Options = {};
    Options.Pretty = true;
    EXPECT_EQ(Print("Position", Options), "{\n  X = 1,\n  Y = 2,\n  Z = 3\n}");
    EXPECT_EQ(Print("Boxed", Options),
              "{\n  Items = {7, 8, 9},\n  Used = 2\n}");
  });
}

TEST(Printer, ChildrenAreThereByPages) {
  atStop([](DebuggedProgram &Program, const FrameContext &Frame) {
    auto Evaluate = [&](const char *Text) {
      Expected<Expression> Parsed =
          Expression::parse(Text, Program.information(), &Frame);
      EXPECT_TRUE(bool(Parsed));
      Expected<Value> Result = Parsed->evaluate(Frame);
      EXPECT_TRUE(bool(Result));
      return *Result;
    };
    Value Zeros = Evaluate("Zeros");
    EXPECT_EQ(childCount(Zeros, Frame), 40u);
    Expected<std::vector<NamedValue>> Page = children(Zeros, Frame, 38, 10);
    ASSERT_TRUE(bool(Page));
    ASSERT_EQ(Page->size(), 2u);
    EXPECT_EQ((*Page)[0].Name, "[38]");
    Value Ball = Evaluate("Ball");
    Expected<std::vector<NamedValue>> Parts = children(Ball, Frame);
    ASSERT_TRUE(bool(Parts));
    EXPECT_TRUE((*Parts)[0].IsBase);
    EXPECT_EQ((*Parts)[0].Name, "scene::Shape");
    EXPECT_EQ(childCount(Evaluate("Where"), Frame), 1u);
    EXPECT_EQ(childCount(Evaluate("Raw"), Frame), 0u);
    EXPECT_EQ(childCount(Evaluate("Span"), Frame), 3u);
    EXPECT_EQ(childCount(Evaluate("A"), Frame), 0u);
  });
}

TEST(Printer, Numbers) {
  EXPECT_EQ(formatReal(double(0.1f), 4), "0.1");
  EXPECT_EQ(formatReal(1e30, 8), "1e+30");
  EXPECT_EQ(formatReal(-0.0, 4), "-0");
  EXPECT_EQ(formatReal(std::numeric_limits<double>::quiet_NaN(), 4),
            "nan(0x400000)");
  EXPECT_EQ(quoted("a\"b\\\n\x01"), "\"a\\\"b\\\\\\n\\001\"");
}
