//===- Format.cpp - The engine of printf ----------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/libc/Format.h"
#include "runtime/lib/libc/Decimal.h"
#include <stddef.h>
#include <stdint.h>

namespace tp {

namespace {

enum class Length { Char, Short, Int, Long, LongLong };

/// One conversion's flags, width and precision.
struct Conversion {
  bool Left = false;
  bool Plus = false;
  bool Space = false;
  bool Alternate = false;
  bool Zero = false;
  int Width = 0;
  /// -1: none given.
  int Precision = -1;
  Length Size = Length::Int;
};

class Formatter {
public:
  explicit Formatter(TextSink &Sink) : Sink(Sink) {}

  void write(const char *Text, int Bytes) {
    if (Bytes <= 0)
      return;
    Sink.Write(Sink, Text, static_cast<unsigned>(Bytes));
    Written += Bytes;
  }

  void fill(char Character, int Count);
  void text(const Conversion &C, const char *Text, int Bytes);
  void integer(const Conversion &C, uint64_t Magnitude, bool Negative,
               bool Signed, char Specifier);
  void real(const Conversion &C, double Value, char Specifier);

  int written() const { return Written; }

private:
  void number(const Conversion &C, const char *Prefix, int PrefixBytes,
              int Zeros, const char *Digits, int Bytes);
  void fixed(const Conversion &C, const Decimal &Digits, const char *Prefix,
             int PrefixBytes, int Precision);
  void scientific(const Conversion &C, const Decimal &Digits,
                  const char *Prefix, int PrefixBytes, int Precision,
                  bool Upper);
  void hexadecimal(const Conversion &C, double Value, char *Prefix,
                   int PrefixBytes, bool Upper);
  void digits(const Decimal &Digits, int FirstPower, int LastPower);
  int padBefore(const Conversion &C, int Bytes);

  TextSink &Sink;
  int Written = 0;
};

} // namespace

void Formatter::fill(char Character, int Count) {
  char Block[16];
  for (char &Element : Block)
    Element = Character;
  for (; Count > 0; Count -= 16)
    write(Block, Count < 16 ? Count : 16);
}

void Formatter::text(const Conversion &C, const char *Text, int Bytes) {
  if (!C.Left)
    fill(' ', C.Width - Bytes);
  write(Text, Bytes);
  if (C.Left)
    fill(' ', C.Width - Bytes);
}

/// Sign or prefix, zeros, digits, and the blanks around them.
void Formatter::number(const Conversion &C, const char *Prefix, int PrefixBytes,
                       int Zeros, const char *Digits, int Bytes) {
  int Blanks = C.Width - PrefixBytes - Zeros - Bytes;
  if (!C.Left)
    fill(' ', Blanks);
  write(Prefix, PrefixBytes);
  fill('0', Zeros);
  write(Digits, Bytes);
  if (C.Left)
    fill(' ', Blanks);
}

static int signPrefix(const Conversion &C, bool Negative, char *Prefix) {
  if (Negative)
    *Prefix = '-';
  else if (C.Plus)
    *Prefix = '+';
  else if (C.Space)
    *Prefix = ' ';
  else
    return 0;
  return 1;
}

/// Writes \p Value's decimal digits so that they end before \p End.
static char *decimalDigits(uint64_t Value, char *End) {
  while (Value >> 32 != 0) {
    uint64_t Quotient = Value / 1000000000;
    uint32_t Rest = static_cast<uint32_t>(Value - Quotient * 1000000000);
    Value = Quotient;
    for (int I = 0; I != 9; ++I, Rest /= 10)
      *--End = static_cast<char>('0' + Rest % 10);
  }
  for (uint32_t Rest = static_cast<uint32_t>(Value); Rest != 0; Rest /= 10)
    *--End = static_cast<char>('0' + Rest % 10);
  return End;
}

static char hexDigit(unsigned Value, bool Upper) {
  return (Upper ? "0123456789ABCDEF" : "0123456789abcdef")[Value & 15];
}

void Formatter::integer(const Conversion &C, uint64_t Magnitude, bool Negative,
                        bool Signed, char Specifier) {
  char Buffer[72];
  char *End = Buffer + sizeof(Buffer);
  char *Begin = End;
  char Prefix[2];
  int PrefixBytes = Signed ? signPrefix(C, Negative, Prefix) : 0;
  if (Specifier == 'd' || Specifier == 'u') {
    Begin = decimalDigits(Magnitude, End);
  } else {
    int Shift = Specifier == 'o' ? 3 : Specifier == 'b' ? 1 : 4;
    for (uint64_t Rest = Magnitude; Rest != 0; Rest >>= Shift)
      *--Begin = hexDigit(static_cast<unsigned>(Rest) & ((1u << Shift) - 1),
                          Specifier == 'X');
    if (C.Alternate && Magnitude != 0 && Specifier != 'o') {
      Prefix[0] = '0';
      Prefix[1] = Specifier == 'p' ? 'x' : Specifier;
      PrefixBytes = 2;
    }
  }
  int Bytes = static_cast<int>(End - Begin);
  int Zeros = (C.Precision < 0 ? 1 : C.Precision) - Bytes;
  if (Specifier == 'o' && C.Alternate && Zeros <= 0 &&
      (Bytes == 0 || *Begin != '0'))
    Zeros = 1;
  if (C.Precision < 0 && C.Zero && !C.Left &&
      Zeros < C.Width - PrefixBytes - Bytes)
    Zeros = C.Width - PrefixBytes - Bytes;
  number(C, Prefix, PrefixBytes, Zeros < 0 ? 0 : Zeros, Begin, Bytes);
}

void Formatter::digits(const Decimal &Digits, int FirstPower, int LastPower) {
  for (int Power = FirstPower; Power >= LastPower; --Power) {
    char Digit = static_cast<char>('0' + Digits.digit(Power));
    write(&Digit, 1);
  }
}

/// Blanks before a number of \p Bytes; returns how many belong behind it.
int Formatter::padBefore(const Conversion &C, int Bytes) {
  if (C.Left)
    return C.Width - Bytes;
  if (!C.Zero)
    fill(' ', C.Width - Bytes);
  return 0;
}

void Formatter::fixed(const Conversion &C, const Decimal &Digits,
                      const char *Prefix, int PrefixBytes, int Precision) {
  int First = Digits.exponent() > 0 ? Digits.exponent() : 0;
  bool Point = Precision > 0 || C.Alternate;
  int Bytes = PrefixBytes + First + 1 + Point + Precision;
  int Pad = padBefore(C, Bytes);
  write(Prefix, PrefixBytes);
  if (C.Zero && !C.Left)
    fill('0', C.Width - Bytes);
  digits(Digits, First, 0);
  if (Point)
    write(".", 1);
  digits(Digits, -1, -Precision);
  fill(' ', Pad);
}

/// 'e', sign and at least two digits.
static int exponentText(int Exponent, bool Upper, char *Text) {
  Text[0] = Upper ? 'E' : 'e';
  Text[1] = Exponent < 0 ? '-' : '+';
  unsigned Value = static_cast<unsigned>(Exponent < 0 ? -Exponent : Exponent);
  int Bytes = 2;
  if (Value >= 100)
    Text[Bytes++] = static_cast<char>('0' + Value / 100);
  Text[Bytes++] = static_cast<char>('0' + Value / 10 % 10);
  Text[Bytes++] = static_cast<char>('0' + Value % 10);
  return Bytes;
}

void Formatter::scientific(const Conversion &C, const Decimal &Digits,
                           const char *Prefix, int PrefixBytes, int Precision,
                           bool Upper) {
  char Suffix[8];
  int First = Digits.exponent();
  int SuffixBytes = exponentText(First, Upper, Suffix);
  bool Point = Precision > 0 || C.Alternate;
  int Bytes = PrefixBytes + 1 + Point + Precision + SuffixBytes;
  int Pad = padBefore(C, Bytes);
  write(Prefix, PrefixBytes);
  if (C.Zero && !C.Left)
    fill('0', C.Width - Bytes);
  digits(Digits, First, First);
  if (Point)
    write(".", 1);
  digits(Digits, First - 1, First - Precision);
  write(Suffix, SuffixBytes);
  fill(' ', Pad);
}

/// One digit before the point (1, or 0 for zeros and subnormals), the fraction
/// without trailing zeros or rounded to even.
void Formatter::hexadecimal(const Conversion &C, double Value, char *Prefix,
                            int PrefixBytes, bool Upper) {
  uint64_t Bits = __builtin_bit_cast(uint64_t, Value);
  uint64_t Fraction = Bits << 12 >> 12;
  int Exponent = static_cast<int>(Bits >> 52 & 0x7FF);
  unsigned Lead = Exponent != 0;
  if (Exponent == 0)
    Exponent = Fraction != 0 ? 1 - 1023 : 0;
  else
    Exponent -= 1023;
  int Precision = C.Precision;
  if (Precision < 0) {
    Precision = 13;
    for (uint64_t Rest = Fraction; Precision > 0 && (Rest & 15) == 0;
         Rest >>= 4)
      --Precision;
  } else if (Precision < 13) {
    int Shift = 52 - 4 * Precision;
    uint64_t Whole = (uint64_t(Lead) << 52 | Fraction);
    uint64_t Half = uint64_t(1) << (Shift - 1);
    uint64_t Lost = Whole & ((Half << 1) - 1);
    Whole -= Lost;
    if (Lost > Half || (Lost == Half && (Whole >> Shift & 1)))
      Whole += Half << 1;
    Lead = static_cast<unsigned>(Whole >> 52);
    Fraction = Whole << 12 >> 12;
  }
  Prefix[PrefixBytes++] = '0';
  Prefix[PrefixBytes++] = Upper ? 'X' : 'x';
  char Suffix[8];
  Suffix[0] = Upper ? 'P' : 'p';
  Suffix[1] = Exponent < 0 ? '-' : '+';
  char Number[8];
  char *NumberEnd = Number + sizeof(Number);
  char *NumberBegin = decimalDigits(
      static_cast<uint64_t>(Exponent < 0 ? -Exponent : Exponent), NumberEnd);
  if (NumberBegin == NumberEnd)
    *--NumberBegin = '0';
  int SuffixBytes = 2;
  while (NumberBegin != NumberEnd)
    Suffix[SuffixBytes++] = *NumberBegin++;
  bool Point = Precision > 0 || C.Alternate;
  int Bytes = PrefixBytes + 1 + Point + Precision + SuffixBytes;
  int Pad = padBefore(C, Bytes);
  write(Prefix, PrefixBytes);
  if (C.Zero && !C.Left)
    fill('0', C.Width - Bytes);
  char Digit = hexDigit(Lead, Upper);
  write(&Digit, 1);
  if (Point)
    write(".", 1);
  for (int I = 0; I != Precision; ++I) {
    Digit = I < 13 ? hexDigit(static_cast<unsigned>(Fraction >> (48 - 4 * I)),
                              Upper)
                   : '0';
    write(&Digit, 1);
  }
  write(Suffix, SuffixBytes);
  fill(' ', Pad);
}

void Formatter::real(const Conversion &C, double Value, char Specifier) {
  bool Upper = Specifier >= 'A' && Specifier <= 'Z';
  char Kind = Upper ? static_cast<char>(Specifier + ('a' - 'A')) : Specifier;
  uint64_t Bits = __builtin_bit_cast(uint64_t, Value);
  char Prefix[4];
  int PrefixBytes = signPrefix(C, Bits >> 63 != 0, Prefix);
  if ((Bits >> 52 & 0x7FF) == 0x7FF) {
    bool Infinite = Bits << 12 == 0;
    const char *Name =
        Upper ? (Infinite ? "INF" : "NAN") : (Infinite ? "inf" : "nan");
    number(C, Prefix, PrefixBytes, 0, Name, 3);
    return;
  }
  if (Kind == 'a') {
    hexadecimal(C, Value, Prefix, PrefixBytes, Upper);
    return;
  }
  int Precision = C.Precision < 0 ? 6 : C.Precision;
  Decimal Digits(Value);
  if (Kind == 'f') {
    Digits.round(-Precision);
    fixed(C, Digits, Prefix, PrefixBytes, Precision);
    return;
  }
  if (Kind == 'e') {
    Digits.round(Digits.exponent() - Precision);
    scientific(C, Digits, Prefix, PrefixBytes, Precision, Upper);
    return;
  }
  if (Precision == 0)
    Precision = 1;
  Digits.round(Digits.exponent() - (Precision - 1));
  int Exponent = Digits.exponent();
  int LastPower = Digits.lastPower();
  if (Exponent < -4 || Exponent >= Precision) {
    int Behind = C.Alternate ? Precision - 1 : Exponent - LastPower;
    scientific(C, Digits, Prefix, PrefixBytes, Behind, Upper);
    return;
  }
  int Behind = Precision - 1 - Exponent;
  if (!C.Alternate)
    Behind = LastPower < 0 ? -LastPower : 0;
  fixed(C, Digits, Prefix, PrefixBytes, Behind);
}

static int boundedLength(const char *Text, int Limit) {
  int Bytes = 0;
  while (Bytes != Limit && Text[Bytes] != '\0')
    ++Bytes;
  return Bytes;
}

/// Reads the digits of a width or precision.
static int readNumber(const char *&Format) {
  int Value = 0;
  while (*Format >= '0' && *Format <= '9')
    Value = Value * 10 + (*Format++ - '0');
  return Value;
}

static void readFlags(const char *&Format, Conversion &C) {
  for (;; ++Format)
    switch (*Format) {
    case '-':
      C.Left = true;
      break;
    case '+':
      C.Plus = true;
      break;
    case ' ':
      C.Space = true;
      break;
    case '#':
      C.Alternate = true;
      break;
    case '0':
      C.Zero = true;
      break;
    default:
      return;
    }
}

template <typename T> static Length lengthOf() {
  return sizeof(T) == sizeof(int) ? Length::Int : Length::LongLong;
}

static Length readLength(const char *&Format) {
  switch (*Format) {
  case 'h':
    if (*++Format != 'h')
      return Length::Short;
    ++Format;
    return Length::Char;
  case 'l':
    if (*++Format != 'l')
      return Length::Long;
    ++Format;
    return Length::LongLong;
  case 'j':
    ++Format;
    return Length::LongLong;
  case 'z':
    ++Format;
    return lengthOf<size_t>();
  case 't':
    ++Format;
    return lengthOf<ptrdiff_t>();
  case 'L':
    ++Format;
    return Length::Int;
  default:
    return Length::Int;
  }
}

namespace {

/// A va_list that functions can share.
struct ArgumentList {
  va_list List;
};

} // namespace

static uint64_t readUnsigned(Length Size, ArgumentList &Arguments) {
  switch (Size) {
  case Length::Char:
    return static_cast<unsigned char>(va_arg(Arguments.List, unsigned));
  case Length::Short:
    return static_cast<unsigned short>(va_arg(Arguments.List, unsigned));
  case Length::Int:
    return va_arg(Arguments.List, unsigned);
  case Length::Long:
    return va_arg(Arguments.List, unsigned long);
  case Length::LongLong:
    break;
  }
  return va_arg(Arguments.List, unsigned long long);
}

static int64_t readSigned(Length Size, ArgumentList &Arguments) {
  switch (Size) {
  case Length::Char:
    return static_cast<signed char>(va_arg(Arguments.List, int));
  case Length::Short:
    return static_cast<short>(va_arg(Arguments.List, int));
  case Length::Int:
    return va_arg(Arguments.List, int);
  case Length::Long:
    return va_arg(Arguments.List, long);
  case Length::LongLong:
    break;
  }
  return va_arg(Arguments.List, long long);
}

static void storeCount(Length Size, ArgumentList &Arguments, int Count) {
  switch (Size) {
  case Length::Char:
    *va_arg(Arguments.List, signed char *) = static_cast<signed char>(Count);
    return;
  case Length::Short:
    *va_arg(Arguments.List, short *) = static_cast<short>(Count);
    return;
  case Length::Int:
    *va_arg(Arguments.List, int *) = Count;
    return;
  case Length::Long:
    *va_arg(Arguments.List, long *) = Count;
    return;
  case Length::LongLong:
    *va_arg(Arguments.List, long long *) = Count;
    return;
  }
}

/// Writes the conversion at \p Specifier; false for an unknown one.
static bool convert(Formatter &Out, Conversion &C, char Specifier,
                    ArgumentList &Arguments) {
  switch (Specifier) {
  case '%':
    Out.write("%", 1);
    return true;
  case 'c': {
    char Character = static_cast<char>(va_arg(Arguments.List, int));
    Out.text(C, &Character, 1);
    return true;
  }
  case 's': {
    const char *Text = va_arg(Arguments.List, const char *);
    if (!Text)
      Text = C.Precision < 0 || C.Precision >= 6 ? "(null)" : "";
    Out.text(C, Text, boundedLength(Text, C.Precision));
    return true;
  }
  case 'd':
  case 'i': {
    int64_t Value = readSigned(C.Size, Arguments);
    uint64_t Magnitude = static_cast<uint64_t>(Value);
    Out.integer(C, Value < 0 ? -Magnitude : Magnitude, Value < 0,
                /*Signed=*/true, 'd');
    return true;
  }
  case 'u':
  case 'o':
  case 'x':
  case 'X':
  case 'b':
    Out.integer(C, readUnsigned(C.Size, Arguments), false, /*Signed=*/false,
                Specifier);
    return true;
  case 'p': {
    uintptr_t Address =
        reinterpret_cast<uintptr_t>(va_arg(Arguments.List, void *));
    C.Alternate = true;
    if (Address == 0)
      Out.text(C, "(nil)", 5);
    else
      Out.integer(C, Address, false, /*Signed=*/true, 'p');
    return true;
  }
  case 'a':
  case 'A':
  case 'e':
  case 'E':
  case 'f':
  case 'F':
  case 'g':
  case 'G':
    Out.real(C, va_arg(Arguments.List, double), Specifier);
    return true;
  case 'n':
    storeCount(C.Size, Arguments, Out.written());
    return true;
  default:
    return false;
  }
}

int formatText(TextSink &Sink, const char *Format, va_list Arguments) {
  Formatter Out(Sink);
  ArgumentList List;
  va_copy(List.List, Arguments);
  for (;;) {
    const char *Begin = Format;
    while (*Format != '\0' && *Format != '%')
      ++Format;
    Out.write(Begin, static_cast<int>(Format - Begin));
    if (*Format == '\0')
      break;
    Begin = Format++;
    Conversion C;
    readFlags(Format, C);
    if (*Format == '*') {
      ++Format;
      C.Width = va_arg(List.List, int);
      if (C.Width < 0) {
        C.Left = true;
        C.Width = -C.Width;
      }
    } else {
      C.Width = readNumber(Format);
    }
    if (*Format == '.') {
      ++Format;
      if (*Format == '*') {
        ++Format;
        C.Precision = va_arg(List.List, int);
      } else {
        C.Precision = readNumber(Format);
      }
    }
    C.Size = readLength(Format);
    if (convert(Out, C, *Format, List)) {
      ++Format;
    } else {
      if (*Format != '\0')
        ++Format;
      Out.write(Begin, static_cast<int>(Format - Begin));
    }
  }
  va_end(List.List);
  return Out.written();
}

} // namespace tp
