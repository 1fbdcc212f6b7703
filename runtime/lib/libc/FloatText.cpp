//===- FloatText.cpp - Floating-point numbers from text -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Correctly rounded for any number of digits.
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/builtins/DoubleFormat.h"
#include "runtime/lib/builtins/Libcall.h"
#include "runtime/lib/libc/Decimal.h"
#include <stddef.h>

using namespace tp;

namespace {

/// Of a double or a float: bits of the significand and exponent of its last
/// bit in the smallest number.
struct Format {
  int Bits;
  int MinExponent;
};

struct ParsedNumber {
  enum { Finite, Infinite, NotANumber } Kind = Finite;
  bool Negative = false;
  Decimal::Binary Value = {0, 0};
};

} // namespace

static bool isBlank(char Character) {
  return Character == ' ' || (Character >= '\t' && Character <= '\r');
}

static bool isDigit(char Character) {
  return Character >= '0' && Character <= '9';
}

static int hexValue(char Character) {
  if (isDigit(Character))
    return Character - '0';
  char Lower = static_cast<char>(Character | 0x20);
  return Lower >= 'a' && Lower <= 'f' ? Lower - 'a' + 10 : -1;
}

/// Moves \p Text past \p Word in any case of letters, if it is there.
static bool skipWord(const char *&Text, const char *Word) {
  const char *Rest = Text;
  for (; *Word != '\0'; ++Word, ++Rest)
    if ((*Rest | 0x20) != *Word)
      return false;
  Text = Rest;
  return true;
}

/// The number behind an 'e' or 'p', which is \p Letter; 0 if there is none. Far
/// beyond any range it stops growing.
static int readExponent(const char *&Text, char Letter) {
  if ((*Text | 0x20) != Letter)
    return 0;
  const char *Rest = Text + 1;
  bool Negative = *Rest == '-';
  if (*Rest == '-' || *Rest == '+')
    ++Rest;
  if (!isDigit(*Rest))
    return 0;
  int Exponent = 0;
  for (; isDigit(*Rest); ++Rest)
    if (Exponent < 100000000)
      Exponent = Exponent * 10 + (*Rest - '0');
  Text = Rest;
  return Negative ? -Exponent : Exponent;
}

constexpr Decimal::Binary TooLarge = {1, 100000};

static bool readDecimal(const char *&Text, Format F, Decimal::Binary &Value) {
  const char *Begin = Text;
  const char *Rest = Text;
  // Digits are numbered from the first that is not 0.
  const char *First = nullptr;
  int PointPower = 0;
  bool Any = false, Point = false;
  for (;; ++Rest) {
    if (*Rest == '.' && !Point) {
      Point = true;
      continue;
    }
    if (!isDigit(*Rest))
      break;
    Any = true;
    if (!First && *Rest != '0')
      First = Rest;
    if (First && !Point)
      ++PointPower;
    if (!First && Point)
      --PointPower;
  }
  if (!Any) {
    Text = Begin;
    return false;
  }
  const char *DigitsEnd = Rest;
  long long Power = PointPower - 1LL + readExponent(Rest, 'e');
  Text = Rest;
  Value = {0, 0};
  if (!First || Power < -400)
    return true;
  if (Power > 309) {
    Value = TooLarge;
    return true;
  }
  Decimal Digits;
  int DigitPower = static_cast<int>(Power);
  for (const char *Digit = First; Digit != DigitsEnd; ++Digit)
    if (*Digit != '.')
      Digits.append(static_cast<unsigned>(*Digit - '0'), DigitPower--);
  Value = Digits.toBinary(F.Bits, F.MinExponent);
  return true;
}

/// \p Text stands behind "0x".
static bool readHexadecimal(const char *&Text, Format F,
                            Decimal::Binary &Value) {
  const char *Rest = Text;
  uint64_t Significand = 0;
  long long Exponent = 0;
  bool Any = false, Point = false;
  for (;; ++Rest) {
    if (*Rest == '.' && !Point) {
      Point = true;
      continue;
    }
    int Digit = hexValue(*Rest);
    if (Digit < 0)
      break;
    Any = true;
    if (Significand >> 60 == 0) {
      Significand = Significand << 4 | static_cast<unsigned>(Digit);
      Exponent -= Point ? 4 : 0;
    } else {
      // Beyond 60 bits a digit matters only for being 0 or not.
      Significand |= Digit != 0;
      Exponent += Point ? 0 : 4;
    }
  }
  if (!Any)
    return false;
  Exponent += readExponent(Rest, 'p');
  Text = Rest;
  Value = {0, 0};
  if (Significand == 0)
    return true;
  int Length = 64 - wide::leadingZeros(Significand);
  if (Exponent + Length > 2000) {
    Value = TooLarge;
    return true;
  }
  long long Shift = Length - F.Bits;
  if (Exponent + Shift < F.MinExponent)
    Shift = F.MinExponent - Exponent;
  if (Shift > 64)
    return true;
  if (Shift > 0) {
    uint64_t Lost = Shift > 1 ? Significand << (65 - Shift) : 0;
    uint64_t Whole = Significand >> (Shift - 1) >> 1;
    bool Half = Significand >> (Shift - 1) & 1;
    Significand = Whole + (Half && (Lost != 0 || (Whole & 1)));
    Exponent += Shift;
  }
  Value = {Significand, static_cast<int>(Exponent)};
  return true;
}

static ParsedNumber parse(const char *Text, char **End, Format F) {
  ParsedNumber Result;
  const char *Rest = Text;
  while (isBlank(*Rest))
    ++Rest;
  if (*Rest == '-' || *Rest == '+')
    Result.Negative = *Rest++ == '-';
  const char *Hexadecimal = Rest + 2;
  bool Found = true;
  if (skipWord(Rest, "inf")) {
    skipWord(Rest, "inity");
    Result.Kind = ParsedNumber::Infinite;
  } else if (skipWord(Rest, "nan")) {
    Result.Kind = ParsedNumber::NotANumber;
  } else if (Rest[0] == '0' && (Rest[1] | 0x20) == 'x' &&
             readHexadecimal(Hexadecimal, F, Result.Value)) {
    Rest = Hexadecimal;
  } else {
    Found = readDecimal(Rest, F, Result.Value);
    Result.Negative = Result.Negative && Found;
  }
  if (End)
    *End = const_cast<char *>(Found ? Rest : Text);
  return Result;
}

extern "C" {

double TP_LIBCALL(strtod)(const char *__restrict Text, char **__restrict End) {
  ParsedNumber N = parse(Text, End, {53, -1074});
  uint64_t Sign = N.Negative ? soft::kSign : 0;
  if (N.Kind == ParsedNumber::NotANumber)
    return soft::fromBits(Sign | soft::kNaN);
  if (N.Kind == ParsedNumber::Infinite)
    return soft::fromBits(Sign | soft::kInfinity);
  if (N.Value.Whole == 0)
    return soft::fromBits(Sign);
  int Zeros = wide::leadingZeros(N.Value.Whole);
  return soft::fromBits(soft::pack(Sign,
                                   soft::kBias + 63 - Zeros + N.Value.Exponent,
                                   N.Value.Whole << Zeros));
}

float TP_LIBCALL(strtof)(const char *__restrict Text, char **__restrict End) {
  ParsedNumber N = parse(Text, End, {24, -149});
  uint32_t Sign = N.Negative ? 0x80000000u : 0;
  if (N.Kind == ParsedNumber::NotANumber)
    return soft::fromBits(Sign | 0x7FC00000u);
  if (N.Kind == ParsedNumber::Infinite)
    return soft::fromBits(Sign | 0x7F800000u);
  if (N.Value.Whole == 0)
    return soft::fromBits(Sign);
  int Zeros = wide::leadingZeros(N.Value.Whole);
  return soft::fromBits(
      soft::packFloat(Sign, soft::kFloatBias + 63 - Zeros + N.Value.Exponent,
                      N.Value.Whole << Zeros));
}

long double TP_LIBCALL(strtold)(const char *__restrict Text,
                                char **__restrict End) {
  return TP_LIBCALL(strtod)(Text, End);
}

double TP_LIBCALL(atof)(const char *Text) {
  return TP_LIBCALL(strtod)(Text, nullptr);
}

} // extern "C"
