//===- ExpressionTest.cpp - Expressions at a stop of a program -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/source/Expression.h"
#include "debugger/source/ValuePrinter.h"
#include "test/unit/source/DebuggedProgram.h"

#include <gtest/gtest.h>

using namespace llvm;
using namespace tp;
using namespace tp::test;

namespace {

/// The program, stopped in expressions() and then in area().
class ExpressionTest : public testing::Test {
protected:
  static inline std::unique_ptr<DebuggedProgram> Program;

  static void SetUpTestSuite() {
    Program = std::make_unique<DebuggedProgram>(
        "unit/source/Inputs/expressions.cpp",
        std::vector<std::string>{"-O0", "-g", "-fstandalone-debug"});
  }
  static void TearDownTestSuite() { Program.reset(); }

  void at(unsigned Stop,
          const std::function<void(const FrameContext &)> &Function) {
    unsigned Count = 0;
    Program->runToCallsOf("stop", [&](const FrameContext &Frame) {
      if (Count++ == Stop)
        Function(Frame);
    });
    EXPECT_GT(Count, Stop);
  }

  struct Case {
    const char *Expression;
    const char *Result;
  };

  void check(unsigned Stop, std::initializer_list<Case> Cases) {
    at(Stop, [&](const FrameContext &Frame) {
      for (const Case &C : Cases)
        EXPECT_EQ(print(Program->information(), Frame, C.Expression), C.Result)
            << C.Expression;
    });
  }
};

} // namespace

TEST_F(ExpressionTest, LiteralsHaveTheTypesOfC) {
  check(0, {{"42", "42"},
            {"0x2a", "42"},
            {"052", "42"},
            {"0b101010", "42"},
            {"1'000'000", "1000000"},
            {"4294967295", "4294967295"},
            {"0xffffffff", "4294967295"},
            {"sizeof(0xffffffff)", "4"},
            {"sizeof(4294967295)", "8"},
            {"sizeof(1u)", "4"},
            {"sizeof(1ll)", "8"},
            {"0xffull", "255"},
            {"1.5", "1.5"},
            {"1.5f", "1.5"},
            {"sizeof(1.5f)", "4"},
            {"sizeof(1.5)", "8"},
            {"1e3", "1000"},
            {"0x1p-2", "0.25"},
            {".5", "0.5"},
            {"'a'", "97 'a'"},
            {"'\\n'", "10 '\\n'"},
            {"'\\x41'", "65 'A'"},
            {"\"text\"", "\"text\""},
            {"sizeof(\"text\")", "5"},
            {"true", "true"},
            {"nullptr", "(void *) 0x0"}});
}

TEST_F(ExpressionTest, ArithmeticIsThatOfTheProgram) {
  check(0, {{"1 + 2 * 3", "7"},
            {"(1 + 2) * 3", "9"},
            {"7 / 2", "3"},
            {"-7 / 2", "-3"},
            {"-7 % 3", "-1"},
            {"7 / 2.0f", "3.5"},
            {"2147483647 + 1", "-2147483648"},
            {"4294967295u + 1", "0"},
            {"1u - 2", "4294967295"},
            {"-1 < 0u", "false"},
            {"-1ll < 0u", "true"},
            {"1 << 31", "-2147483648"},
            {"-8 >> 1", "-4"},
            {"4000000000u >> 4", "250000000"},
            {"~0", "-1"},
            {"!5", "false"},
            {"!!5", "true"},
            {"6 & 3 | 8 ^ 1", "11"},
            {"1 == 1 && 2 != 2", "false"},
            {"0 || 3", "true"},
            {"1 ? 10 : 20", "10"},
            {"0 ? 1 : 0 ? 2 : 3", "3"},
            {"1, 2, 3", "3"},
            {"0.1f + 0.2f", "0.3"},
            {"0.1 + 0.2", "0.30000000000000004"},
            {"1.0f / 3", "0.33333334"},
            {"1.0f / 0", "inf"},
            {"Byte + 10", "260"},
            {"Small * Small", "9"},
            {"Letter + 1", "114"},
            {"-Byte", "-250"},
            {"(unsigned short)1 - 2", "-1"},
            {"Ref.Wide - 654322", "-1"},
            {"B + 1", "4000000001"},
            {"B > 5", "true"},
            {"A < B", "true"},
            {"Long / 1000", "-5000000"},
            {"Huge + 1", "0"},
            {"7 / 0", "error: Division by zero"},
            {"7 % 0", "error: Division by zero"},
            {"1 << 32",
             "error: The shift's distance is not below the value's width, 32."},
            {"1.5 % 2",
             "error: Integer-only operation on a floating-point value."}});
}

TEST_F(ExpressionTest, NamesAreFoundAsInCpp) {
  check(0, {{"A", "5"},
            {"X", "6"},
            {"Global", "100"},
            {"::Global", "100"},
            {"other::Global", "200"},
            {"Unused", "<optimized out>"},
            {"Unused + 1", "error: the value has been optimized out"},
            {"::other::Global", "200"},
            {"Hidden", "77"},
            {"scene::Hidden", "77"},
            {"PerThread", "9"},
            {"scene::Counter::Instances", "3"},
            {"Counter::Instances", "3"},
            {"scene::Counter::Limit", "12"},
            {"Green", "Green"},
            {"Mode::On", "Mode::On"},
            {"On", "error: No symbol \"On\" in current context."},
            {"Color::Blue", "Blue"},
            {"Nothing", "error: No symbol \"Nothing\" in current context."},
            {"other::Nothing",
             "error: No symbol \"other::Nothing\" in current context."}});
  check(1, {{"this->Id", "41"},
            {"Id", "41"},
            {"Local", "82"},
            {"Scale", "2"},
            {"Center.Y", "-2"},
            {"Instances", "3"},
            {"Limit", "12"},
            {"Shape::Id", "error: No symbol \"Shape::Id\" in current context."},
            {"this->Shape::Id", "41"},
            {"Next == this", "true"},
            {"this->Next.Next == this", "true"},
            {"this->Next->Next->Radius", "3"}});
}

TEST_F(ExpressionTest, UsingBringsNames) {
  check(0, {{"sizeof(Node)", "16"}, {"sizeof(hidden::Pair)", "2"}});
  check(2, {{"sizeof(Node)", "16"},
            {"sizeof(Pair)", "2"},
            {"((Node *)Root)->Value", "4"},
            {"sizeof(decoy::Outer::Pair)", "8"},
            {"Both", "{Letters = \"ab\"}"}});
}

TEST_F(ExpressionTest, BranchesHaveACommonType) {
  check(0, {{"sizeof(1 ? 1 : 2ll)", "8"},
            {"1 ? -1 : 2u", "4294967295"},
            {"(0 ? 1.5f : 3) / 2", "1.5"},
            {"1 ? 7 : 1 / 0", "7"},
            {"1 ? Position : Position", "{X = 1, Y = 2, Z = 3}"},
            {"Yes ? true : false", "true"}});
}

TEST_F(ExpressionTest, MembersPointersAndArrays) {
  check(0, {{"Position.X", "1"},
            {"Where->Y", "2"},
            {"Where.Z", "3"},
            {"(*Where).Z", "3"},
            {"&Position == Where", "true"},
            {"Ref.Id", "41"},
            {"Ref.Center.X", "1.5"},
            {"Ref.Visible", "1"},
            {"Ref.Level", "-7"},
            {"Ref.Wide", "654321"},
            {"Ref.Level * 2", "-14"},
            {"Ref.AsFloat", "3.1415927"},
            {"Ref.State", "Mode::On"},
            {"Ref.Instances", "3"},
            {"Ref.Next->Next == &Ref", "true"},
            {"List[2]", "3"},
            {"2[List]", "3"},
            {"*List", "1"},
            {"*(List + 3)", "4"},
            {"&List[4] - List", "4"},
            {"&List[1] < &List[2]", "true"},
            {"sizeof List", "20"},
            {"sizeof(List) / sizeof(List[0])", "5"},
            {"Matrix[1][2]", "6"},
            {"Matrix[2]", "{8, 9, 10, 11}"},
            {"**Matrix", "0"},
            {"Pointer[0]", "1007"},
            {"*Pointer@2", "{1007, 8}"},
            {"List[1]@3", "{2, 3, 4}"},
            {"Four[2]", "30"},
            {"Span[1]", "2"},
            {"View[1]", "97 'a'"},
            {"Boxed.Items[Boxed.Used]", "9"},
            {"*Words[1]", "116 't'"},
            {"M.Small", "-9"},
            {"M.Yes && M.Letter == 'm'", "true"},
            {"Alias + 1", "7"},
            {"&Alias == &X", "true"},
            {"Ref.Nothing", "error: There is no member named Nothing."},
            {"A.X", "error: Attempt to extract a component of a value that is "
                    "not a structure."},
            {"A[0]", "error: cannot subscript something of type `int'"},
            {"&Ref.Level", "error: Cannot take the address of a bit-field."},
            {"&5", "error: Attempt to take address of value not located in "
                   "memory."},
            {"*1.5", "error: Attempt to take contents of a non-pointer "
                     "value."},
            {"*(int *)16", "<error: Cannot access memory at address 0x10>"},
            {"*(int *)16 + 1", "error: Cannot access memory at address 0x10"},
            {"Position + 1", "error: Argument to arithmetic operation not a "
                             "number or boolean."}});
}

TEST_F(ExpressionTest, Casts) {
  check(0, {{"(int)2.9f", "2"},
            {"(int)-2.9", "-2"},
            {"int(2.9f)", "2"},
            {"(unsigned char)300", "44 ','"},
            {"(signed char)200", "-56 '\\310'"},
            {"(short)70000", "4464"},
            {"(bool)7", "true"},
            {"(float)A / 2", "2.5"},
            {"(Color)6", "Blue"},
            {"(Mode)0", "Mode::Off"},
            {"(int)Mode::On", "200"},
            {"(long long)A << 40", "5497558138880"},
            {"(unsigned long)-1", "4294967295"},
            {"(int)1e20", "2147483647"},
            {"static_cast<unsigned>(-1)", "4294967295"},
            {"*(float *)&Ref.AsInteger", "3.1415927"},
            {"*(scene::Vector *)Where", "{X = 1, Y = 2, Z = 3}"},
            {"((struct scene::Vector *)Where)->Y", "2"},
            {"((Vector *)Where)->X == 1.0f || ((scene::Vector *)Where)->X == 1",
             "true"},
            {"*reinterpret_cast<int *>(Raw)", "6"},
            {"reinterpret_cast<int>(1.0f)", "1065353216"},
            {"const_cast<int &>(X)", "6"},
            {"*(int (*)[5])List", "{1, 2, 3, 4, 5}"},
            {"(long)Where == (long)&Position", "true"},
            {"{int}&X", "6"},
            {"{short} &X", "6"},
            {"((scene::Box<int, 3> *)&Boxed)->Used", "2"},
            {"((const unsigned int *)List)[1]", "2"},
            {"sizeof(scene::Vector)", "12"},
            {"sizeof(scene::Box<int, 3>)", "16"},
            {"sizeof(unsigned char)", "1"},
            {"sizeof(int *)", "4"},
            {"sizeof(double[3])", "24"},
            {"(scene::Vector)5", "error: Invalid cast."},
            {"(Nothing *)0", "error: No symbol \"Nothing\" in current "
                             "context."}});
}

TEST_F(ExpressionTest, Registers) {
  at(0, [&](const FrameContext &Frame) {
    auto Print = [&](const char *Text, char Format = 0) {
      return print(Program->information(), Frame, Text, Format);
    };
    EXPECT_EQ(Print("$sp == $r29"), "true");
    EXPECT_EQ(Print("$ra == $r31"), "true");
    EXPECT_EQ(Print("(long)$pc"), std::to_string(int32_t(Frame.Pc)));
    EXPECT_EQ(Print("$r0"), "0");
    EXPECT_EQ(Print("$r4"), "<optimized out>");
    EXPECT_EQ(Print("(char *)$cfa > (char *)$sp"), "true");
    EXPECT_EQ(Print("sizeof($f20)"), "4");
    EXPECT_EQ(Print("$unset"), "error: $unset has no value.");
    EXPECT_EQ(Print("$1"), "error: History has not yet reached $1.");
  });
}

TEST_F(ExpressionTest, SyntaxErrorsHaveAPlace) {
  check(0, {{"1 +", "error: A syntax error at the end of the expression."},
            {"(1", "error: A syntax error at the end of the expression."},
            {"1 ) + 2", "error: A syntax error in expression, near `) + 2'."},
            {"A B", "error: A syntax error in expression, near `B'."},
            {"", "error: A syntax error at the end of the expression."},
            {"#", "error: Invalid character '#' in expression."},
            {"'a", "error: Unmatched single quote."},
            {"\"a", "error: Unterminated string in expression."},
            {"12x", "error: Invalid number \"12x\"."},
            {"09", "error: Invalid number \"09\"."},
            {"int", "error: Attempt to use a type as an expression."},
            {"scene::twice(1)", "error: Functions of the program cannot be "
                                "called: it would have to run."}});
}

TEST_F(ExpressionTest, DeepNestingIsRefused) {
  std::string Text(1900, '(');
  at(0, [&](const FrameContext &Frame) {
    EXPECT_EQ(print(Program->information(), Frame, Text),
              "error: The expression is nested too deeply.");
    EXPECT_EQ(
        print(Program->information(), Frame, std::string(1900, '!') + "1"),
        "error: The expression is nested too deeply.");
  });
}

TEST_F(ExpressionTest, AssignmentsChangeTheProgram) {
  at(0, [&](const FrameContext &Frame) {
    auto Print = [&](const char *Text) {
      return print(Program->information(), Frame, Text);
    };
    EXPECT_EQ(Print("X = 50"), "50");
    EXPECT_EQ(Print("Alias"),
              "@0x" + Print("&X").substr(std::string("(int *) 0x").size()) +
                  ": 50");
    EXPECT_EQ(Print("X += 2"), "52");
    EXPECT_EQ(Print("X++"), "52");
    EXPECT_EQ(Print("X"), "53");
    EXPECT_EQ(Print("--X"), "52");
    EXPECT_EQ(Print("Alias = 6"), "6");
    EXPECT_EQ(Print("X"), "6");
    EXPECT_EQ(Print("Ref.Level = 3"), "3");
    EXPECT_EQ(Print("Ref.Level = 31, Ref.Level"), "-1");
    EXPECT_EQ(Print("Ref.Wide"), "654321");
    EXPECT_EQ(Print("Ref.Visible"), "1");
    EXPECT_EQ(Print("Ref.Level = -7, Ref.Level"), "-7");
    EXPECT_EQ(Print("Position = Ref.Center"), "{X = 1.5, Y = -2, Z = 0.25}");
    EXPECT_EQ(Print("Position.X"), "1.5");
    EXPECT_EQ(Print("Where->X = 1, Where->Y = 2, Where->Z = 3"), "3");
    EXPECT_EQ(Print("Byte = 300"), "44 ','");
    EXPECT_EQ(Print("Byte = 250"), "250 '\\372'");
    EXPECT_EQ(Print("Paint = Blue"), "Blue");
    EXPECT_EQ(Print("Paint = (Color)5"), "Green");
    EXPECT_EQ(Print("5 = 6"),
              "error: left operand of assignment is not an object of the "
              "program");
    EXPECT_EQ(Print("$r16 = 77"), "77");
    EXPECT_EQ(Program->WrittenRegister, 16u);
    EXPECT_EQ(Program->WrittenValue, 77u);
    EXPECT_EQ(Print("*(int *)0 = 1"),
              "error: Cannot write memory at address 0x0");
    EXPECT_EQ(Print("sizeof(X = 7)"),
              "error: The operand of sizeof may not change anything.");
    EXPECT_EQ(Print("X"), "6");
  });
}

TEST_F(ExpressionTest, HistoryKeepsValues) {
  at(0, [&](const FrameContext &Frame) {
    ValueHistory History;
    auto Evaluate = [&](const char *Text) -> std::string {
      Expected<Expression> Parsed =
          Expression::parse(Text, Program->information(), &Frame);
      if (!Parsed)
        return toString(Parsed.takeError());
      Expected<Value> Result = Parsed->evaluate(Frame, &History);
      if (!Result)
        return toString(Result.takeError());
      Expected<Value> Kept = Result->snapshot(Frame);
      EXPECT_TRUE(bool(Kept));
      History.add(*Kept);
      return ValuePrinter(Program->map()).print(*Kept, Frame);
    };
    EXPECT_EQ(Evaluate("X"), "6");
    EXPECT_EQ(Evaluate("X = 9"), "9");
    EXPECT_EQ(Evaluate("$1"), "6");
    EXPECT_EQ(Evaluate("$"), "6");
    EXPECT_EQ(Evaluate("$$3"), "6");
    EXPECT_EQ(Evaluate("$$ + $2"), "15");
    EXPECT_EQ(Evaluate("$count = List[3]"), "4");
    EXPECT_EQ(Evaluate("$count++"), "4");
    EXPECT_EQ(Evaluate("$count * 2"), "10");
    EXPECT_EQ(Evaluate("$99"), "History has not yet reached $99.");
    EXPECT_EQ(Evaluate("X = 6"), "6");
  });
}

TEST_F(ExpressionTest, ConditionsAreParsedOnce) {
  at(0, [&](const FrameContext &Frame) {
    Expected<Expression> Parsed = Expression::parse(
        "X == 6 && Where->Y > 1.5f", Program->information(), &Frame);
    ASSERT_TRUE(bool(Parsed));
    for (unsigned I = 0; I != 3; ++I) {
      Expected<bool> Is = Parsed->isTrue(Frame);
      ASSERT_TRUE(bool(Is));
      EXPECT_TRUE(*Is);
    }
    EXPECT_FALSE(Parsed->hasEffects());
  });
}

TEST_F(ExpressionTest, TheSameExpressionServesAllFrames) {
  Expected<Expression> Parsed =
      Expression::parse("Ball.Id + PerThread", Program->information());
  ASSERT_TRUE(bool(Parsed));
  unsigned Stops = 0;
  Program->run([&](const FrameContext &Frame) {
    if (Stops++ % 100)
      return;
    Expected<Value> Result = Parsed->evaluate(Frame);
    ASSERT_TRUE(bool(Result)) << toString(Result.takeError());
  });
}
