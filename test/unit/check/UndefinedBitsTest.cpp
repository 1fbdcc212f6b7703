//===- UndefinedBitsTest.cpp - What results of undefined bits are ---------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Against all values that the undefined bits can have.
//
//===----------------------------------------------------------------------===//

#include "simulator/check/UndefinedBits.h"

#include "gtest/gtest.h"

#include <array>
#include <random>
#include <vector>

using namespace tp;

namespace {

using Operands = std::array<uint32_t, 3>;

/// Operands of which some bits are undefined.
class RandomOperands {
public:
  explicit RandomOperands(unsigned Seed) : Random(Seed) {
    // Half of the values are small: comparisons and shifts are close then.
    for (uint32_t &Value : Values)
      Value = Random() % 2 ? Random() : Random() % 8;
    for (unsigned Count = 1 + Random() % 7; Count != 0; --Count)
      Bits[Random() % 3] |= 1u << (Random() % 2 ? Random() % 32 : Random() % 4);
  }

  /// Calls \p Function with each value that the operands can have.
  template <class FunctionType> void forEach(FunctionType Function) const {
    std::vector<std::pair<unsigned, uint32_t>> Places;
    for (unsigned I = 0; I != 3; ++I)
      for (uint32_t Bit = 1; Bit != 0; Bit <<= 1)
        if (Bits[I] & Bit)
          Places.push_back({I, Bit});
    for (uint32_t Choice = 0; Choice != 1u << Places.size(); ++Choice) {
      Operands Now = Values;
      for (size_t I = 0; I != Places.size(); ++I)
        if (Choice >> I & 1)
          Now[Places[I].first] ^= Places[I].second;
      Function(Now);
    }
  }

  uint32_t below(uint32_t Limit) { return Random() % Limit; }

  Operands Values{};
  UndefinedBits Bits[3] = {};

private:
  std::mt19937 Random;
};

} // namespace

static Instruction instruction(uint32_t Immediate, uint32_t Second) {
  Instruction Decoded;
  Decoded.Immediate = int32_t(Immediate);
  Decoded.SecondImmediate = uint8_t(Second);
  for (uint8_t I = 0; I != 3; ++I)
    Decoded.Source[I] = I;
  return Decoded;
}

/// Compares with the bits that really differ: none is missing, and if
/// \p IsExact, none is too many.
template <Opcode Op> static void compare(bool IsExact) {
  for (unsigned Seed = 0; Seed != 3000; ++Seed) {
    RandomOperands Given(Seed);
    for (unsigned I = Body<Op>::NumSources; I != 3; ++I)
      Given.Bits[I] = 0;
    const uint32_t Lowest = Given.below(32);
    const Instruction Decoded =
        movesBits(Op)
            ? instruction(Lowest, Lowest + Given.below(32 - Lowest))
            : instruction(
                  Given.below(2) ? Given.below(9) - 4 : Given.below(65536), 0);
    NoContext Context;
    auto ResultOf = [&](const Operands &Values) {
      Body<Op> Run(Decoded, Values.data());
      Run.run(Context);
      return Run.result();
    };
    const uint32_t Result = ResultOf(Given.Values);
    UndefinedBits Really = 0;
    Given.forEach(
        [&](const Operands &Now) { Really |= ResultOf(Now) ^ Result; });
    if ((Given.Bits[0] | Given.Bits[1] | Given.Bits[2]) == 0)
      continue;
    const UndefinedBits Called = undefinedResult<Op>(
        Decoded, Body<Op>(Decoded, Given.Values.data()), Given.Bits);
    ASSERT_EQ(Really & ~Called, 0u) << mnemonic(Op) << ", seed " << Seed;
    if (IsExact)
      ASSERT_EQ(Called, Really) << mnemonic(Op) << ", seed " << Seed;
  }
}

template <Opcode... Ops> static void compareEach(bool IsExact) {
  (compare<Ops>(IsExact), ...);
}

TEST(UndefinedBits, LogicMovesAndShiftsAreExact) {
  compareEach<Opcode::AND, Opcode::OR, Opcode::NOR, Opcode::XOR, Opcode::ANDI,
              Opcode::ORI, Opcode::XORI, Opcode::SLL, Opcode::SRL, Opcode::SRA,
              Opcode::ROTR, Opcode::EXT, Opcode::INS, Opcode::SEB, Opcode::SEH,
              Opcode::MOV_S, Opcode::MFC1, Opcode::MTC1, Opcode::NEG_S,
              Opcode::ABS_S>(/*IsExact=*/true);
}

TEST(UndefinedBits, ComparisonsAreExact) {
  compareEach<Opcode::SLT, Opcode::SLTU, Opcode::SLTI, Opcode::SLTIU,
              Opcode::ADDC, Opcode::SUBC>(/*IsExact=*/true);
}

TEST(UndefinedBits, OthersMissNothing) {
  compareEach<Opcode::ADD, Opcode::ADDI, Opcode::SUB, Opcode::MUL, Opcode::MULH,
              Opcode::SLLV, Opcode::SRLV, Opcode::SRAV, Opcode::ROTRV,
              Opcode::MOVN, Opcode::MOVZ, Opcode::CLZ>(/*IsExact=*/false);
}

namespace {

/// Tells what an atomic operation leaves of a word.
struct AtomicContext {
  template <class Function>
  uint32_t atomic(uint32_t, uint32_t Operand, uint32_t Expected,
                  Function Update) {
    New = Update(Old, Operand, Expected);
    return Old;
  }

  uint32_t Old = 0;
  uint32_t New = 0;
};

} // namespace

/// The first operand is the word in memory.
template <Opcode Op> static void compareAtomic(bool IsExact) {
  constexpr bool HasExpected = Op == Opcode::ATOM_CAS;
  for (unsigned Seed = 0; Seed != 3000; ++Seed) {
    RandomOperands Given(Seed);
    if (!HasExpected)
      Given.Bits[2] = 0;
    else if (Given.below(2))
      Given.Values[2] = Given.Values[0];
    auto RunOn = [&](const Operands &Values) {
      const uint32_t Registers[3] = {Values[HasExpected ? 2 : 1], Values[1], 0};
      return Body<Op>(instruction(0, 0), Registers);
    };
    auto WordAfter = [&](const Operands &Values) {
      AtomicContext Context{Values[0]};
      RunOn(Values).run(Context);
      return Context.New;
    };
    const uint32_t Word = WordAfter(Given.Values);
    UndefinedBits Really = 0;
    Given.forEach(
        [&](const Operands &Now) { Really |= WordAfter(Now) ^ Word; });
    const UndefinedBits Called =
        undefinedWord<Op>(RunOn(Given.Values), Given.Values[0], Given.Bits[0],
                          Given.Bits[1], Given.Bits[2]);
    ASSERT_EQ(Really & ~Called, 0u) << mnemonic(Op) << ", seed " << Seed;
    if (IsExact)
      ASSERT_EQ(Called, Really) << mnemonic(Op) << ", seed " << Seed;
  }
}

TEST(UndefinedBits, AtomicOperations) {
  compareAtomic<Opcode::ATOM_AND>(/*IsExact=*/true);
  compareAtomic<Opcode::ATOM_OR>(/*IsExact=*/true);
  compareAtomic<Opcode::ATOM_XOR>(/*IsExact=*/true);
  compareAtomic<Opcode::ATOM_SWAP>(/*IsExact=*/true);
  compareAtomic<Opcode::ATOM_ADD>(/*IsExact=*/false);
  compareAtomic<Opcode::ATOM_MIN>(/*IsExact=*/false);
  compareAtomic<Opcode::ATOM_MAX>(/*IsExact=*/false);
  compareAtomic<Opcode::ATOM_MINU>(/*IsExact=*/false);
  compareAtomic<Opcode::ATOM_MAXU>(/*IsExact=*/false);
  compareAtomic<Opcode::ATOM_CAS>(/*IsExact=*/false);
}

template <Opcode Op>
static void compareCondition(bool (*IsTrue)(uint32_t, uint32_t)) {
  size_t Both = 0;
  for (unsigned Seed = 0; Seed != 3000; ++Seed) {
    RandomOperands Given(Seed);
    Given.Bits[2] = 0;
    const bool Answer = IsTrue(Given.Values[0], Given.Values[1]);
    bool Really = false;
    Given.forEach([&](const Operands &Now) {
      Really |= IsTrue(Now[0], Now[1]) != Answer;
    });
    const Body<Op> Run(instruction(0, 0), Given.Values.data());
    ASSERT_EQ(isConditionUndefined<Op>(Run, Given.Bits[0], Given.Bits[1]),
              Really)
        << mnemonic(Op) << ", seed " << Seed;
    Both += Really;
  }
  EXPECT_GT(Both, 10u);
}

TEST(UndefinedBits, ConditionsAreExact) {
  compareCondition<Opcode::BEQ>([](uint32_t A, uint32_t B) { return A == B; });
  compareCondition<Opcode::BNE>([](uint32_t A, uint32_t B) { return A != B; });
  compareCondition<Opcode::BLTU>([](uint32_t A, uint32_t B) { return A < B; });
  compareCondition<Opcode::BGE>(
      [](uint32_t A, uint32_t B) { return int32_t(A) >= int32_t(B); });
  compareCondition<Opcode::TLT>(
      [](uint32_t A, uint32_t B) { return int32_t(A) < int32_t(B); });
}
