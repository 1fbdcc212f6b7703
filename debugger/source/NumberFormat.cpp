//===- NumberFormat.cpp - Numbers and characters as text -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/source/SourceMap.h"
#include "debugger/source/ValuePrinter.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/ADT/bit.h"
#include "llvm/Support/MathExtras.h"

#include <charconv>
#include <cmath>

using namespace llvm;

namespace tp {

static std::string escaped(uint32_t Character, char Quote) {
  switch (Character) {
  case '\n':
    return "\\n";
  case '\t':
    return "\\t";
  case '\r':
    return "\\r";
  case '\a':
    return "\\a";
  case '\b':
    return "\\b";
  case '\f':
    return "\\f";
  case '\v':
    return "\\v";
  case 27:
    return "\\033";
  case '\\':
    return "\\\\";
  default:
    break;
  }
  if (Character == uint32_t(Quote))
    return std::string("\\") + Quote;
  if (Character >= 32 && Character < 127)
    return std::string(1, char(Character));
  if (Character < 256) {
    std::string Digits;
    for (int Shift = 6; Shift >= 0; Shift -= 3)
      Digits += char('0' + (Character >> Shift & 7));
    return "\\" + Digits;
  }
  return "\\u" + utohexstr(Character, true, 4);
}

std::string quotedCharacter(uint32_t Character) {
  return "'" + escaped(Character, '\'') + "'";
}

std::string quoted(StringRef Text) {
  std::string Result = "\"";
  for (char C : Text)
    Result += escaped(uint8_t(C), '"');
  return Result + "\"";
}

std::string formatReal(double Number, unsigned Bytes) {
  if (std::isnan(Number)) {
    uint64_t Bits = Bytes <= 4 ? bit_cast<uint32_t>(float(Number)) & 0x7fffff
                               : bit_cast<uint64_t>(Number) &
                                     maskTrailingOnes<uint64_t>(52);
    return (std::signbit(Number) ? "-nan(0x" : "nan(0x") +
           utohexstr(Bits, true) + ")";
  }
  if (std::isinf(Number))
    return Number < 0 ? "-inf" : "inf";
  char Buffer[64];
  std::to_chars_result End =
      Bytes <= 4 ? std::to_chars(Buffer, std::end(Buffer), float(Number))
                 : std::to_chars(Buffer, std::end(Buffer), Number);
  return std::string(Buffer, End.ptr);
}

static std::string binary(uint64_t Number, unsigned Digits) {
  std::string Result;
  for (unsigned I = Digits; I-- != 0;)
    Result += Number >> I & 1 ? '1' : '0';
  return Result;
}

static std::string octal(uint64_t Number) {
  std::string Result;
  for (; Number; Number >>= 3)
    Result.insert(Result.begin(), char('0' + (Number & 7)));
  return Result.empty() ? "0" : "0" + Result;
}

std::string formatNumber(ArrayRef<uint8_t> Bytes, char Format,
                         const SourceMap &Map) {
  uint64_t Number = 0;
  unsigned Bits = unsigned(std::min<size_t>(Bytes.size(), 8) * 8);
  for (unsigned I = 0; I != Bits / 8; ++I)
    Number |= uint64_t(Bytes[I]) << (8 * I);
  switch (Format) {
  case 'x':
    return "0x" + utohexstr(Number, true);
  case 'z':
    return "0x" + utohexstr(Number, true, Bits / 4);
  case 'o':
    return octal(Number);
  case 't': {
    std::string Digits = binary(Number, Bits);
    size_t First = Digits.find('1');
    return First == std::string::npos ? "0" : Digits.substr(First);
  }
  case 'u':
    return std::to_string(Number);
  case 'a':
    return Map.describeAddress(uint32_t(Number));
  case 'c':
    return std::to_string(SignExtend64(Number & 0xff, 8)) + " " +
           quotedCharacter(Number & 0xff);
  case 'f':
    if (Bits == 32)
      return formatReal(bit_cast<float>(uint32_t(Number)), 4);
    if (Bits == 64)
      return formatReal(bit_cast<double>(Number), 8);
    [[fallthrough]];
  default:
    return std::to_string(Bits ? SignExtend64(Number, Bits) : 0);
  }
}

} // namespace tp
