//===- RandomExpressionTest.cpp - Expressions against the compiler -------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/source/Expression.h"
#include "test/unit/source/DebuggedProgram.h"

#include "llvm/ADT/bit.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/FileUtilities.h"
#include "llvm/Support/raw_ostream.h"

#include <gtest/gtest.h>
#include <random>

using namespace llvm;
using namespace tp;
using namespace tp::test;

namespace {

/// Makes expressions over the variables of the program below.
class Generator {
public:
  explicit Generator(unsigned Seed) : Random(Seed) {}

  /// One of any arithmetic type.
  std::string any(unsigned Depth) {
    if (Depth == 0)
      return leaf();
    switch (pick(9)) {
    case 0:
      return "(" + any(Depth - 1) + " + " + any(Depth - 1) + ")";
    case 1:
      return "(" + any(Depth - 1) + " - " + any(Depth - 1) + ")";
    case 2:
      return "(" + any(Depth - 1) + " * " + any(Depth - 1) + ")";
    case 3:
      return "(" + any(Depth - 1) + comparison() + any(Depth - 1) + ")";
    case 4:
      return "(" + any(Depth - 1) + " ? " + any(Depth - 1) + " : " +
             any(Depth - 1) + ")";
    case 5:
      return "(- " + any(Depth - 1) + ")";
    case 6:
      return "((" + type() + ")" + any(Depth - 1) + ")";
    default:
      return integer(Depth);
    }
  }

private:
  std::mt19937 Random;

  unsigned pick(unsigned Count) { return Random() % Count; }

  std::string choose(std::initializer_list<const char *> Of) {
    return Of.begin()[pick(unsigned(Of.size()))];
  }

  std::string comparison() {
    return choose({" < ", " > ", " <= ", " >= ", " == ", " != "});
  }
  // Conversions of floating-point values that do not fit are undefined except
  // to what saturates.
  std::string type() { return choose({"int", "float", "double", "bool"}); }
  std::string integerLeaf() {
    return choose({"I", "U", "S", "UC", "SC", "LL", "ULL", "B", "12", "-7",
                   "0x80000000", "3000000000u", "5ll", "'z'", "true"});
  }
  std::string leaf() {
    return pick(3) ? integerLeaf()
                   : choose({"F", "D", "1.5f", "0.1", "2e10f", "-3.25"});
  }

  /// One of integers, where all operators are allowed.
  std::string integer(unsigned Depth) {
    if (Depth == 0)
      return integerLeaf();
    std::string Left = integer(Depth - 1), Right = integer(Depth - 1);
    switch (pick(11)) {
    case 0:
      return "(" + Left + " & " + Right + ")";
    case 1:
      return "(" + Left + " | " + Right + ")";
    case 2:
      return "(" + Left + " ^ " + Right + ")";
    case 3:
      return "(~" + Left + ")";
    case 4:
      return "(" + Left + " << (" + Right + " & 15))";
    case 5:
      return "(" + Left + " >> (" + Right + " & 31))";
    case 6:
      return "(" + Left + " / ((" + Right + " & 1023) + 3))";
    case 7:
      return "(" + Left + " % ((" + Right + " & 1023) + 3))";
    case 8:
      return "(" + Left + " && " + Right + " || !" + Left + ")";
    case 9:
      return "((" +
             choose({"short", "unsigned char", "unsigned", "long long",
                     "signed char"}) +
             ")" + Left + ")";
    default:
      return "(" + Left + " - " + Right + ")";
    }
  }
};

constexpr const char *Prologue =
    "volatile int I = -123456; volatile unsigned U = 4000000000u;\n"
    "volatile short S = -30000; volatile unsigned char UC = 250;\n"
    "volatile signed char SC = -100; volatile long long LL = -5000000000ll;\n"
    "volatile unsigned long long ULL = 18000000000000000000ull;\n"
    "volatile bool B = true; volatile float F = 2.7f;\n"
    "volatile double D = -1e9;\n"
    "double Reals[400]; long long Integers[400]; unsigned Sizes[400];\n"
    "extern \"C\" __attribute__((noinline)) void stop() {\n"
    "  asm volatile(\"\" ::: \"memory\");\n}\n"
    "template <class T> void set(int At, T Result) {\n"
    "  Reals[At] = double(Result); Sizes[At] = sizeof(T);\n"
    "  if constexpr (T(0.5) == 0 || sizeof(T) == 1)\n"
    "    Integers[At] = (long long)(Result);\n}\n"
    "int main() {\n";

constexpr unsigned Count = 400;

} // namespace

TEST(RandomExpressions, GiveWhatTheProgramComputes) {
  Generator Make(20261122);
  std::vector<std::string> Expressions;
  SmallString<128> Path;
  int File;
  ASSERT_FALSE(sys::fs::createTemporaryFile("expressions", "cpp", File, Path));
  FileRemover Remove(Path);
  {
    raw_fd_ostream OS(File, /*shouldClose=*/true);
    OS << Prologue;
    for (unsigned I = 0; I != Count; ++I) {
      Expressions.push_back(Make.any(1 + I % 4));
      OS << "  set(" << I << ", " << Expressions.back() << ");\n";
    }
    OS << "  stop();\n}\n";
  }
  DebuggedProgram Program(std::string(Path), {"-O0", "-g", "-w", "-fwrapv"});
  unsigned Stops = 0;
  Program.runToCallsOf("stop", [&](const FrameContext &Frame) {
    ++Stops;
    auto Evaluate = [&](const std::string &Text) {
      Expected<Expression> Parsed =
          Expression::parse(Text, Program.information(), &Frame);
      EXPECT_TRUE(bool(Parsed)) << Text;
      Expected<Value> Result = Parsed->evaluate(Frame);
      if (!Result) {
        ADD_FAILURE() << Text << ": " << toString(Result.takeError());
        return Value();
      }
      return *Result;
    };
    for (unsigned I = 0; I != Count; ++I) {
      std::string At = "[" + std::to_string(I) + "]";
      Value Result = Evaluate(Expressions[I]);
      if (!Result.isValid())
        continue;
      Expected<double> Real = Result.asReal(Frame);
      Expected<double> Wanted = Evaluate("Reals" + At).asReal(Frame);
      ASSERT_TRUE(bool(Real) && bool(Wanted));
      EXPECT_EQ(bit_cast<uint64_t>(*Real), bit_cast<uint64_t>(*Wanted))
          << Expressions[I] << ": " << *Real << ", not " << *Wanted;
      Expected<uint64_t> Size = Evaluate("Sizes" + At).asInteger(Frame);
      ASSERT_TRUE(bool(Size));
      EXPECT_EQ(Result.type().Size, *Size) << Expressions[I];
      if (!Result.type().isInteger())
        continue;
      Expected<uint64_t> Integer = Result.asInteger(Frame);
      Expected<uint64_t> Exact = Evaluate("Integers" + At).asInteger(Frame);
      ASSERT_TRUE(bool(Integer) && bool(Exact));
      EXPECT_EQ(*Integer, *Exact) << Expressions[I];
    }
  });
  EXPECT_EQ(Stops, 1u);
}
