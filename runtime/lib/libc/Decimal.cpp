//===- Decimal.cpp - Exact decimal expansion of a double ------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/libc/Decimal.h"

namespace tp {

constexpr uint32_t Base = 1000000000;
constexpr int DigitsPerWord = 9;

constexpr uint32_t PowersOfTen[DigitsPerWord] = {
    1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000};

/// How many words the word of 10^\p Power lies before the units word.
static int wordsAboveUnits(int Power) {
  return Power >= 0 ? Power / DigitsPerWord
                    : -((DigitsPerWord - 1 - Power) / DigitsPerWord);
}

Decimal::Decimal(double Value) {
  uint64_t Bits = __builtin_bit_cast(uint64_t, Value);
  int Exponent = static_cast<int>(Bits >> 52 & 0x7FF);
  uint64_t Significand = Bits << 12 >> 12;
  if (Exponent != 0)
    Significand |= uint64_t(1) << 52;
  else
    Exponent = 1;
  Exponent -= 1023 + 52;
  Words[UnitsWord - 1] = static_cast<uint32_t>(Significand / Base);
  Words[UnitsWord] = static_cast<uint32_t>(Significand % Base);
  strip();
  if (isZero())
    return;
  if (Exponent > 0)
    multiplyByPowerOfTwo(static_cast<unsigned>(Exponent));
  else
    divideByPowerOfTwo(static_cast<unsigned>(-Exponent));
}

void Decimal::append(unsigned Digit, int Power) {
  if (Digit == 0)
    return;
  int Above = wordsAboveUnits(Power);
  int Index = UnitsWord - Above;
  if (Index >= NumWords) {
    Words[NumWords - 1] |= 1;
    End = NumWords;
    return;
  }
  if (isZero())
    Begin = Index;
  End = Index + 1;
  Words[Index] += Digit * PowersOfTen[Power - Above * DigitsPerWord];
}

/// For numbers below 10^18.
uint64_t Decimal::wholePart() const {
  return static_cast<uint64_t>(Words[UnitsWord - 1]) * Base + Words[UnitsWord];
}

Decimal::Binary Decimal::toBinary(int Bits, int MinExponent) {
  if (isZero())
    return {0, 0};
  uint64_t Limit = uint64_t(1) << Bits;
  int Exponent = 0;
  for (;;) {
    int Power = exponent();
    // A decimal digit is more than three bits.
    if (Power >= 17) {
      unsigned Step = static_cast<unsigned>(Power - 16) * 3;
      divideByPowerOfTwo(Step);
      Exponent += static_cast<int>(Step);
    } else if (uint64_t Whole = wholePart(); Whole >= Limit) {
      divideByPowerOfTwo(1);
      ++Exponent;
    } else if (Whole < Limit / 2 && Exponent > MinExponent) {
      int Step = Power < 0 ? -Power * 3 : 1;
      if (Step > Exponent - MinExponent)
        Step = Exponent - MinExponent;
      multiplyByPowerOfTwo(static_cast<unsigned>(Step));
      Exponent -= Step;
    } else {
      break;
    }
  }
  round(0);
  return {wholePart(), Exponent};
}

void Decimal::multiplyByPowerOfTwo(unsigned Power) {
  if (End <= UnitsWord)
    End = UnitsWord + 1;
  while (Power != 0) {
    unsigned Step = Power < 29 ? Power : 29;
    uint32_t Carry = 0;
    for (int I = End - 1; I >= Begin; --I) {
      uint64_t Word = (static_cast<uint64_t>(Words[I]) << Step) + Carry;
      Carry = static_cast<uint32_t>(Word / Base);
      Words[I] = static_cast<uint32_t>(Word - uint64_t(Carry) * Base);
    }
    if (Carry != 0)
      Words[--Begin] = Carry;
    Power -= Step;
  }
  strip();
}

void Decimal::divideByPowerOfTwo(unsigned Power) {
  if (End <= UnitsWord)
    End = UnitsWord + 1;
  while (Power != 0) {
    // 10^9 is a multiple of 2^9.
    unsigned Step = Power < 9 ? Power : 9;
    uint32_t Scale = Base >> Step;
    uint32_t Rest = 0;
    for (int I = Begin; I != End; ++I) {
      uint32_t Word = Words[I];
      Words[I] = (Word >> Step) + Rest * Scale;
      Rest = Word & ((1u << Step) - 1);
    }
    // A double's own digits always fit.
    if (Rest != 0 && End != NumWords)
      Words[End++] = Rest * Scale;
    else if (Rest != 0)
      Words[End - 1] |= 1;
    if (Words[Begin] == 0)
      ++Begin;
    Power -= Step;
  }
  strip();
}

void Decimal::strip() {
  while (Begin != End && Words[Begin] == 0)
    ++Begin;
  while (Begin != End && Words[End - 1] == 0)
    --End;
}

int Decimal::exponent() const {
  if (isZero())
    return 0;
  int Digit = DigitsPerWord - 1;
  while (Words[Begin] < PowersOfTen[Digit])
    --Digit;
  return (UnitsWord - Begin) * DigitsPerWord + Digit;
}

int Decimal::lastPower() const {
  if (isZero())
    return 0;
  int Digit = 0;
  while (Digit != DigitsPerWord - 1 &&
         Words[End - 1] % PowersOfTen[Digit + 1] == 0)
    ++Digit;
  return (UnitsWord - (End - 1)) * DigitsPerWord + Digit;
}

unsigned Decimal::digit(int Power) const {
  int Above = wordsAboveUnits(Power);
  int Index = UnitsWord - Above;
  if (Index < Begin || Index >= End)
    return 0;
  return Words[Index] / PowersOfTen[Power - Above * DigitsPerWord] % 10;
}

void Decimal::round(int Power) {
  int Above = wordsAboveUnits(Power);
  int Index = UnitsWord - Above;
  if (Index >= End)
    return;
  if (Index < Begin)
    Begin = Index;
  uint32_t Unit = PowersOfTen[Power - Above * DigitsPerWord];
  uint32_t Rest = Words[Index] % Unit;
  bool Odd = (Words[Index] / Unit & 1) != 0;
  uint32_t Half = Unit / 2;
  int Lower = Index + 1;
  if (Unit == 1) {
    Rest = Lower < End ? Words[Lower] : 0;
    Half = Base / 2;
    ++Lower;
  } else {
    Words[Index] -= Rest;
  }
  bool Up = Rest > Half || (Rest == Half && (Lower < End || Odd));
  End = Index + 1;
  if (Up) {
    Words[Index] += Unit;
    for (int I = Index; Words[I] >= Base; --I) {
      Words[I] -= Base;
      if (I == Begin)
        Words[--Begin] = 0;
      ++Words[I - 1];
    }
  }
  strip();
}

} // namespace tp
