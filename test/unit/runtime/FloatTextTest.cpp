//===- FloatTextTest.cpp - strtod and strtof against the host's -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/builtins/Libcall.h"
#include "test/unit/runtime/EdgeValues.h"
#include "gtest/gtest.h"
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

extern "C" {
double TP_LIBCALL(strtod)(const char *Text, char **End);
float TP_LIBCALL(strtof)(const char *Text, char **End);
}

static void check(const std::string &Text) {
  char *OurEnd, *HostEnd;
  double Ours = tpSoft_strtod(Text.c_str(), &OurEnd);
  double Host = strtod(Text.c_str(), &HostEnd);
  ASSERT_EQ(OurEnd, HostEnd) << Text;
  if (std::isnan(Host))
    ASSERT_TRUE(std::isnan(Ours)) << Text;
  else
    ASSERT_EQ(std::bit_cast<uint64_t>(Ours), std::bit_cast<uint64_t>(Host))
        << Text << std::hexfloat << " " << Ours;
  float OurFloat = tpSoft_strtof(Text.c_str(), &OurEnd);
  float HostFloat = strtof(Text.c_str(), &HostEnd);
  if (!std::isnan(HostFloat))
    ASSERT_EQ(std::bit_cast<uint32_t>(OurFloat),
              std::bit_cast<uint32_t>(HostFloat))
        << Text << std::hexfloat << " " << OurFloat;
}

static std::string print(const char *Format, double Value) {
  char Buffer[2048];
  snprintf(Buffer, sizeof(Buffer), Format, Value);
  return Buffer;
}

TEST(FloatText, Forms) {
  for (const char *Text :
       {"",
        " ",
        "x",
        ".",
        "-",
        "+.e1",
        "0",
        "-0",
        "00012",
        "  1.5abc",
        "1e",
        "1e+",
        "1e5",
        "1.e2",
        ".5",
        "+.5e-1x",
        "inf",
        "-Infinity",
        "INFx",
        "nan",
        "infinit",
        "1e309",
        "-1e999999999999",
        "1e-400",
        "1e-324",
        "2e-324",
        "0x",
        "0x1",
        "0x1p",
        "0x1.8p1",
        "-0x.8p-1",
        "0x1p1024",
        "0x1p-1074",
        "0x1p-1075",
        "0x1.8p-1075",
        "0x1.00000000000008p0",
        "0x1.00000000000018p0",
        "0x1.000000000000080000001p0",
        "0x123456789abcdef01234p-10",
        "0x0.0000000000000000000001p0",
        "1.7976931348623157e308",
        "1.7976931348623159e308",
        "4.9406564584124654e-324",
        "2.4703282292062327208e-324",
        "2.4703282292062328e-324",
        "9007199254740993",
        "9007199254740992.9",
        "9007199254740993.00000000000000000000000000000000001",
        "16777217",
        "16777217.0000000001",
        "3.4028235677973366e38",
        "3.4028235677973365e38",
        "7.006492321624085e-46",
        "7.0064923216240854e-46",
        "0.1e1",
        "123456789012345678901234567890"})
    check(Text);
  check(std::string(2000, '1') + "e-1990");
  check("0." + std::string(2000, '0') + "1e2001");
  check("1" + std::string(400, '0') + "e-400");
}

TEST(FloatText, RoundTripsAndMidpoints) {
  tp::test::RandomDoubles Random;
  for (int I = 0; I != 30'000 && !HasFatalFailure(); ++I) {
    double Value = I & 1 ? Random.next() : Random.near(1.0);
    if (!std::isfinite(Value))
      continue;
    check(print("%.17g", Value));
    check(print("%.5e", Value));
    check(print("%a", Value));
    // All digits of the number halfway to the next, exactly and a bit off.
    if (std::fabs(Value) < 1e300 && I % 50 == 0) {
      double Next = std::nextafter(Value, HUGE_VAL);
      char Buffer[2048];
      snprintf(Buffer, sizeof(Buffer), "%.1080Lf",
               ((long double)Value + (long double)Next) / 2);
      check(Buffer);
      check(std::string(Buffer) + "1");
      snprintf(Buffer, sizeof(Buffer), "%.1080f", Value);
      check(Buffer);
    }
  }
  for (double Value : tp::test::edgeDoubles())
    for (const char *Format : {"%.17g", "%.9g", "%.1100f", "%a"})
      check(print(Format, Value));
}
