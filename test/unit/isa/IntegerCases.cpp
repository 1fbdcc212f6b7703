//===- IntegerCases.cpp - Integer instructions, computed otherwise --------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// In 128-bit integers or bit by bit, not as the simulator does it.
//
//===----------------------------------------------------------------------===//

#include "test/unit/isa/InstructionCases.h"

namespace tp::test {

using Wide = __int128;

static Wide sign(uint32_t Bits) {
  return Bits & 0x80000000 ? Wide(Bits) - (Wide(1) << 32) : Wide(Bits);
}

static bool bit(uint32_t Bits, int64_t Index) { return Bits >> Index & 1; }

/// A word from a function of the bit's number.
template <class Function> static uint32_t eachBit(Function F) {
  uint32_t Result = 0;
  for (int I = 31; I >= 0; --I)
    Result = Result * 2 + (F(I) ? 1 : 0);
  return Result;
}

static uint32_t shiftLeft(uint32_t Value, int64_t Amount) {
  return eachBit([=](int I) { return I >= Amount && bit(Value, I - Amount); });
}

static uint32_t shiftRight(uint32_t Value, int64_t Amount, bool Fill) {
  return eachBit(
      [=](int I) { return I + Amount <= 31 ? bit(Value, I + Amount) : Fill; });
}

static uint32_t rotateRight(uint32_t Value, int64_t Amount) {
  return eachBit([=](int I) { return bit(Value, (I + Amount) % 32); });
}

/// Division towards zero by repeated subtraction of shifted divisors.
static std::pair<uint32_t, uint32_t> divide(uint32_t Numerator,
                                            uint32_t Divisor) {
  uint32_t Quotient = 0;
  uint64_t Remainder = 0;
  for (int I = 31; I >= 0; --I) {
    Remainder = Remainder * 2 + bit(Numerator, I);
    bool Fits = Remainder >= Divisor;
    Quotient = Quotient * 2 + Fits;
    Remainder -= Fits ? Divisor : 0;
  }
  return {Quotient, uint32_t(Remainder)};
}

static uint32_t magnitude(uint32_t Bits) {
  return uint32_t(sign(Bits) < 0 ? -sign(Bits) : sign(Bits));
}

static uint32_t negateIf(bool Negative, uint32_t Value) {
  return Negative ? uint32_t(-Wide(Value)) : Value;
}

void addIntegerCases(InstructionCases &Cases) {
  auto Value = [&](const char *Mnemonic, auto Function) {
    Cases[Mnemonic] =
        ValueCase{[=](const Inputs &In) -> std::optional<uint32_t> {
          return Function(In);
        }};
  };

  Value("add", [](auto &In) { return uint32_t(sign(In.Rs) + sign(In.Rt)); });
  Value("addi", [](auto &In) { return uint32_t(sign(In.Rs) + In.First); });
  Value("sub", [](auto &In) { return uint32_t(sign(In.Rs) - sign(In.Rt)); });
  Value("addc",
        [](auto &In) { return uint32_t((Wide(In.Rs) + Wide(In.Rt)) >> 32); });
  Value("subc",
        [](auto &In) { return uint32_t(Wide(In.Rs) - Wide(In.Rt) < 0); });
  Value("slt", [](auto &In) { return uint32_t(sign(In.Rs) < sign(In.Rt)); });
  Value("sltu", [](auto &In) { return uint32_t(Wide(In.Rs) < Wide(In.Rt)); });
  Value("slti", [](auto &In) { return uint32_t(sign(In.Rs) < In.First); });
  Value("sltiu", [](auto &In) {
    Wide Limit = In.First < 0 ? In.First + (Wide(1) << 32) : Wide(In.First);
    return uint32_t(Wide(In.Rs) < Limit);
  });
  Value("mul", [](auto &In) { return uint32_t(sign(In.Rs) * sign(In.Rt)); });
  Value("mulh",
        [](auto &In) { return uint32_t((sign(In.Rs) * sign(In.Rt)) >> 32); });
  Value("mulhu",
        [](auto &In) { return uint32_t((Wide(In.Rs) * Wide(In.Rt)) >> 32); });

  auto Division = [&](const char *Mnemonic, auto Function) {
    Cases[Mnemonic] =
        ValueCase{[=](const Inputs &In) -> std::optional<uint32_t> {
          if (In.Rt == 0)
            return std::nullopt;
          return Function(In);
        }};
  };
  Division("divu", [](auto &In) { return divide(In.Rs, In.Rt).first; });
  Division("remu", [](auto &In) { return divide(In.Rs, In.Rt).second; });
  Division("div", [](auto &In) {
    return negateIf(bit(In.Rs, 31) != bit(In.Rt, 31),
                    divide(magnitude(In.Rs), magnitude(In.Rt)).first);
  });
  Division("rem", [](auto &In) {
    return negateIf(bit(In.Rs, 31),
                    divide(magnitude(In.Rs), magnitude(In.Rt)).second);
  });

  auto Logic = [&](const char *Register, const char *Immediate, auto Function) {
    Cases[Register] = ValueCase{[=](const Inputs &In) {
      return std::optional(eachBit(
          [&](int I) { return Function(bit(In.Rs, I), bit(In.Rt, I)); }));
    }};
    if (Immediate)
      Cases[Immediate] = ValueCase{[=](const Inputs &In) {
        return std::optional(eachBit([&](int I) {
          return Function(bit(In.Rs, I), bit(uint32_t(In.First), I));
        }));
      }};
  };
  Logic("and", "andi", [](bool A, bool B) { return A ? B : false; });
  Logic("or", "ori", [](bool A, bool B) { return A ? true : B; });
  Logic("xor", "xori", [](bool A, bool B) { return A != B; });
  Logic("nor", nullptr, [](bool A, bool B) { return A ? false : !B; });
  Value("lui", [](auto &In) { return uint32_t(In.First * 65536); });

  Value("sll", [](auto &In) { return shiftLeft(In.Rs, In.First); });
  Value("srl", [](auto &In) { return shiftRight(In.Rs, In.First, false); });
  Value("sra",
        [](auto &In) { return shiftRight(In.Rs, In.First, bit(In.Rs, 31)); });
  Value("rotr", [](auto &In) { return rotateRight(In.Rs, In.First); });
  Value("sllv", [](auto &In) { return shiftLeft(In.Rs, In.Rt % 32); });
  Value("srlv", [](auto &In) { return shiftRight(In.Rs, In.Rt % 32, false); });
  Value("srav",
        [](auto &In) { return shiftRight(In.Rs, In.Rt % 32, bit(In.Rs, 31)); });
  Value("rotrv", [](auto &In) { return rotateRight(In.Rs, In.Rt % 32); });

  Value("clz", [](auto &In) {
    uint32_t Count = 0;
    while (Count != 32 && !bit(In.Rs, 31 - Count))
      ++Count;
    return Count;
  });
  Value("seb", [](auto &In) {
    return eachBit([&](int I) { return bit(In.Rs, I < 8 ? I : 7); });
  });
  Value("seh", [](auto &In) {
    return eachBit([&](int I) { return bit(In.Rs, I < 16 ? I : 15); });
  });
  Cases["ext"] = ValueCase{[](const Inputs &In) -> std::optional<uint32_t> {
    if (In.First > In.Second)
      return std::nullopt;
    return eachBit([&](int I) {
      return I <= In.Second - In.First && bit(In.Rs, I + In.First);
    });
  }};
  Cases["ins"] = ValueCase{[](const Inputs &In) -> std::optional<uint32_t> {
    if (In.First > In.Second)
      return std::nullopt;
    return eachBit([&](int I) {
      return I >= In.First && I <= In.Second ? bit(In.Rs, I - In.First)
                                             : bit(In.Old, I);
    });
  }};

  for (const char *Mnemonic : {"movn", "movn_s"})
    Value(Mnemonic, [](auto &In) { return In.Rt ? In.Rs : In.Old; });
  for (const char *Mnemonic : {"movz", "movz_s"})
    Value(Mnemonic, [](auto &In) { return In.Rt ? In.Old : In.Rs; });
  for (const char *Mnemonic : {"mov_s", "mfc1", "mtc1"})
    Value(Mnemonic, [](auto &In) { return In.Rs; });
  Value("abs_s", [](auto &In) {
    return eachBit([&](int I) { return I != 31 && bit(In.Rs, I); });
  });
  Value("neg_s", [](auto &In) {
    return eachBit([&](int I) { return bit(In.Rs, I) != (I == 31); });
  });
}

} // namespace tp::test
