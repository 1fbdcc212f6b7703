//===- FormatTest.cpp - printf's engine against the host's ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/libc/Format.h"
#include "test/unit/runtime/EdgeValues.h"
#include "gtest/gtest.h"
#include <cmath>
#include <cstdio>
#include <string>

namespace {

struct StringSink : tp::TextSink {
  std::string Text;
  StringSink() {
    Write = [](tp::TextSink &Sink, const char *Piece, unsigned Bytes) {
      static_cast<StringSink &>(Sink).Text.append(Piece, Bytes);
    };
  }
};

} // namespace

static std::string ours(const char *Format, ...) {
  va_list Arguments;
  va_start(Arguments, Format);
  StringSink Sink;
  int Count = tp::formatText(Sink, Format, Arguments);
  va_end(Arguments);
  EXPECT_EQ(static_cast<size_t>(Count), Sink.Text.size());
  return Sink.Text;
}

static std::string host(const char *Format, ...) {
  char Buffer[4096];
  va_list Arguments;
  va_start(Arguments, Format);
  vsnprintf(Buffer, sizeof(Buffer), Format, Arguments);
  va_end(Arguments);
  return Buffer;
}

template <typename... T>
static void check(const std::string &Format, T... Values) {
  ASSERT_EQ(ours(Format.c_str(), Values...), host(Format.c_str(), Values...))
      << Format;
}

const char *const Flags[] = {"",   "-",  "+",  " ",  "#",  "0",
                             "-+", "+0", "#0", "-#", " 0", "+#0"};
const char *const Widths[] = {"", "1", "7", "25"};

TEST(Format, Integers) {
  for (const char *Flag : Flags)
    for (const char *Width : Widths)
      for (const char *Precision : {"", ".", ".0", ".3", ".12"})
        for (const char *Conversion : {"d", "i", "u", "x", "X", "o"}) {
          std::string Start = std::string("%") + Flag + Width + Precision;
          for (uint64_t Value : tp::test::edgeIntegers()) {
            check(Start + "ll" + Conversion, Value);
            check(Start + "z" + Conversion, Value);
            check(Start + "j" + Conversion, Value);
            check(Start + Conversion, static_cast<int>(Value));
            check(Start + "h" + Conversion, static_cast<int>(Value));
            check(Start + "hh" + Conversion, static_cast<int>(Value));
            if (HasFatalFailure())
              return;
          }
        }
}

TEST(Format, TextAndPointers) {
  for (const char *Flag : {"", "-"})
    for (const char *Width : Widths) {
      std::string Start = std::string("<%") + Flag + Width;
      check(Start + "s>", "");
      check(Start + "s>", "some text");
      check(Start + ".4s>", "some text");
      check(Start + ".0s>", "some text");
      check(Start + "s>", static_cast<const char *>(nullptr));
      check(Start + "c>", 'x');
      check(Start + "p>", static_cast<void *>(nullptr));
      check(Start + "p>", reinterpret_cast<void *>(0x1234abcd));
    }
  check("100%% of %d\n", 7);
  check("%*d|%-*d|%.*f", 6, 42, 6, 42, 2, 2.5);
  check("%*d|%.*d", -6, 42, -1, 42);
  int Ours = 0;
  ours("abc%n", &Ours);
  EXPECT_EQ(Ours, 3);
}

TEST(Format, DoubleEdges) {
  for (const char *Flag : Flags)
    for (const char *Width : Widths)
      for (const char *Precision : {"", ".0", ".1", ".3", ".17", ".40"})
        for (const char *Conversion : {"f", "F", "e", "E", "g", "G", "a", "A"})
          for (double Value : tp::test::edgeDoubles()) {
            check(std::string("%") + Flag + Width + Precision + Conversion,
                  Value);
            if (HasFatalFailure())
              return;
          }
}

TEST(Format, DoubleTies) {
  for (int Power = -20; Power <= 20; ++Power)
    for (int Odd = 1; Odd < 100; Odd += 2)
      for (int Precision = 0; Precision < 12; ++Precision) {
        double Value = std::ldexp(Odd, Power);
        std::string Digits = "%." + std::to_string(Precision);
        check(Digits + "f", Value);
        check(Digits + "e", Value);
        check(Digits + "g", Value);
        if (HasFatalFailure())
          return;
      }
}

TEST(Format, AllDigits) {
  for (double Value : tp::test::edgeDoubles()) {
    check("%.1100f", Value);
    check("%.1100e", Value);
    check("%.1100g", Value);
  }
}

TEST(Format, RandomDoubles) {
  tp::test::RandomDoubles Random;
  for (int I = 0; I != 100'000 && !HasFatalFailure(); ++I) {
    double Value = Random.next(), Near = Random.near(1.0);
    check("%.17g %g %e %a", Value, Value, Value, Value);
    check("%.10f %f %.3g %.2e", Near, Near, Near, Near);
  }
}
