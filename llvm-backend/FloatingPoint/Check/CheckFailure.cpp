//===- CheckFailure.cpp - A failed floating-point check -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/Check/CheckFailure.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string_view>

namespace tp {

static constexpr unsigned BitsOfType[] = {
#define CHECK_TYPE(Name, Bits) Bits,
#include "llvm-backend/FloatingPoint/Check/CheckFailures.def"
};
static constexpr std::string_view OperationTexts[] = {
#define CHECK_OPERATION(Name, Text) Text,
#include "llvm-backend/FloatingPoint/Check/CheckFailures.def"
};
static_assert(std::size(BitsOfType) <= 4 && std::size(OperationTexts) <= 1024);

bool CheckFailure::isCode(uint32_t Code) {
  return Code >= FirstCode && Code <= 0xFFFF &&
         (Code & 0x3FF) < std::size(OperationTexts);
}

CheckFailure CheckFailure::fromCode(uint32_t Code) {
  return {CheckKind(Code >> 12 & 3), CheckType(Code >> 10 & 3),
          CheckOperation(Code & 0x3FF)};
}

static float halfValue(uint16_t Bits) {
  unsigned Exponent = Bits >> 10 & 0x1F;
  unsigned Fraction = Bits & 0x3FF;
  float Magnitude;
  if (Exponent == 0x1F)
    Magnitude = Fraction ? std::numeric_limits<float>::quiet_NaN()
                         : std::numeric_limits<float>::infinity();
  else if (Exponent == 0)
    Magnitude = std::ldexp(float(Fraction), -24);
  else
    Magnitude = std::ldexp(float(Fraction | 0x400), int(Exponent) - 25);
  return std::copysign(Magnitude, Bits & 0x8000 ? -1.0f : 1.0f);
}

template <typename T> static std::string shortestText(T Value) {
  char Buffer[32];
  auto Result = std::to_chars(std::begin(Buffer), std::end(Buffer), Value);
  return std::string(Buffer, Result.ptr);
}

static std::string decimalText(uint64_t Bits, CheckType Type) {
  switch (Type) {
  case CheckType::Half:
    return shortestText(halfValue(uint16_t(Bits)));
  case CheckType::BFloat:
    return shortestText(std::bit_cast<float>(uint32_t(Bits) << 16));
  case CheckType::Float:
    return shortestText(std::bit_cast<float>(uint32_t(Bits)));
  case CheckType::Double:
    return shortestText(std::bit_cast<double>(Bits));
  }
  return "";
}

static unsigned bitsOf(CheckType Type) { return BitsOfType[unsigned(Type)]; }

std::string describeFloat(uint64_t Bits, CheckType Type) {
  unsigned Size = bitsOf(Type);
  Bits &= ~uint64_t(0) >> (64 - Size);
  char Hexadecimal[32];
  std::snprintf(Hexadecimal, sizeof(Hexadecimal), " (0x%0*llx)", int(Size / 4),
                static_cast<unsigned long long>(Bits));
  return decimalText(Bits, Type) + Hexadecimal;
}

namespace {
enum class NumberClass { Finite, Infinity, NaN };
} // namespace

static NumberClass classify(uint64_t Bits, CheckType Type) {
  uint64_t Infinity = 0;
  switch (Type) {
  case CheckType::Half:
    Infinity = 0x7C00;
    break;
  case CheckType::BFloat:
    Infinity = 0x7F80;
    break;
  case CheckType::Float:
    Infinity = 0x7F800000;
    break;
  case CheckType::Double:
    Infinity = 0x7FF0000000000000;
    break;
  }
  uint64_t Magnitude = Bits & ~uint64_t(0) >> (65 - bitsOf(Type));
  if (Magnitude < Infinity)
    return NumberClass::Finite;
  return Magnitude == Infinity ? NumberClass::Infinity : NumberClass::NaN;
}

static bool mentions(std::string_view Text, char Digit) {
  return Text.find(std::string{'$', Digit}) != std::string_view::npos;
}

std::string
CheckFailure::describe(const std::array<uint64_t, 3> &Values) const {
  std::string_view Text = OperationTexts[unsigned(Operation)];
  auto ClassOf = [&](unsigned I) { return classify(Values[I], Type); };
  // The operand that is to blame: a NaN, else an infinity; 0 if there is none.
  unsigned Culprit = 0;
  for (NumberClass Class : {NumberClass::Infinity, NumberClass::NaN})
    for (unsigned I : {2, 1})
      if (mentions(Text, char('0' + I)) && ClassOf(I) == Class)
        Culprit = I;

  std::string Message;
  switch (Kind) {
  case CheckKind::Conversion:
    Message = Culprit && ClassOf(Culprit) == NumberClass::NaN
                  ? "NaN converted to an integer: "
                  : "number out of range converted to an integer: ";
    break;
  case CheckKind::Comparison:
    Message = "NaN compared: ";
    break;
  case CheckKind::Consumed:
  case CheckKind::Produced:
    Message = ClassOf(Culprit) == NumberClass::NaN ? "NaN" : "infinity";
    Message += Culprit ? " used" : " produced";
    Message += " under finite math: ";
    break;
  }

  std::string Expression;
  for (size_t I = 0; I != Text.size(); ++I) {
    if (Text[I] == '$')
      Expression += describeFloat(Values[unsigned(Text[++I] - '0')], Type);
    else
      Expression += Text[I];
  }
  if (Kind == CheckKind::Produced && !mentions(Text, '0'))
    Expression += " = " + describeFloat(Values[0], Type);
  return Message + Expression;
}

} // namespace tp
