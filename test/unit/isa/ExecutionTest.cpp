//===- ExecutionTest.cpp - Every instruction against its case -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/core/Simulation.h"
#include "test/unit/isa/EdgeValues.h"
#include "test/unit/isa/InstructionCases.h"

#include "gtest/gtest.h"

#include <bit>
#include <cstdlib>
#include <vector>

using namespace tp;
using namespace tp::test;

namespace {

// Registers of the programs: the instruction's own, scratch, and the address of
// the next result.
constexpr unsigned Rd = 10, Rs = 11, Rt = 12, Scratch = 13, Results = 20;

const InstructionCases &allCases() {
  static const InstructionCases Cases = [] {
    InstructionCases Result;
    addIntegerCases(Result);
    addFloatCases(Result);
    addMemoryCases(Result);
    addControlCases(Result);
    return Result;
  }();
  return Cases;
}

std::vector<int64_t> edgesOf(const OperandInfo &Info) {
  if (Info.Kind == OperandKind::IntegerRegister)
    return {std::begin(IntegerEdges), std::end(IntegerEdges)};
  if (Info.Kind == OperandKind::FloatRegister)
    return {std::begin(FloatEdges), std::end(FloatEdges)};
  if (Info.IsSigned)
    return {0, 1, -1, 2, 255, -256, 32767, -32768};
  if (Info.Width == 5)
    return {0, 1, 7, 8, 16, 30, 31};
  return {0, 1, 2, 0xFF, 0x1234, 0x7FFF, 0x8000, 0xFFFF};
}

/// All combinations of edge values for the operands that are read, with the
/// destination's value before.
std::vector<Inputs> combinations(Opcode Op, uint32_t Old) {
  std::vector<Inputs> Result = {{0, 0, Old, 0, 0}};
  unsigned Immediates = 0;
  for (const OperandInfo &Info : operandsOf(Op)) {
    if (Info.IsDestination)
      continue;
    bool Second = Info.Kind == OperandKind::Immediate && Immediates++ != 0;
    std::vector<Inputs> Longer;
    for (const Inputs &Each : Result)
      for (int64_t Value : edgesOf(Info)) {
        Inputs Next = Each;
        if (Info.Kind != OperandKind::Immediate)
          (Info.Name == "rs" ? Next.Rs : Next.Rt) = uint32_t(Value);
        else
          (Second ? Next.Second : Next.First) = Value;
        Longer.push_back(Next);
      }
    Result = std::move(Longer);
  }
  return Result;
}

void load(Assembly &A, OperandKind Kind, unsigned Register, uint32_t Value) {
  A.constant(Kind == OperandKind::FloatRegister ? Scratch : Register, Value);
  if (Kind == OperandKind::FloatRegister)
    A("mtc1", Register, Scratch);
}

/// Sets the registers and executes the instruction; gives the destination's
/// kind.
OperandKind emit(Assembly &A, Opcode Op, const Inputs &In) {
  std::vector<Assembly::Operand> Operands;
  OperandKind DestinationKind = OperandKind::IntegerRegister;
  unsigned Immediates = 0;
  for (const OperandInfo &Info : operandsOf(Op)) {
    if (Info.Kind == OperandKind::Immediate) {
      Operands.push_back(Immediates++ == 0 ? In.First : In.Second);
      continue;
    }
    unsigned Register = Info.IsDestination ? Rd : Info.Name == "rs" ? Rs : Rt;
    uint32_t Value = Info.IsDestination  ? In.Old
                     : Info.Name == "rs" ? In.Rs
                                         : In.Rt;
    if (Info.IsDestination)
      DestinationKind = Info.Kind;
    load(A, Info.Kind, Register, Value);
    Operands.push_back(Register);
  }
  A.add(mnemonic(Op), Operands);
  return DestinationKind;
}

/// Floats in order: the distance of two finite floats in units of the last
/// place.
int64_t ordinal(uint32_t Bits) {
  int64_t Magnitude = Bits & 0x7FFFFFFF;
  return Bits >> 31 ? -Magnitude : Magnitude;
}

bool matches(uint32_t Actual, uint32_t Expected, uint32_t Ulps) {
  if (Ulps == 0 || (Expected & 0x7FFFFFFF) >= 0x7F800000)
    return Actual == Expected;
  return std::llabs(ordinal(Actual) - ordinal(Expected)) <= Ulps;
}

uint32_t flush(uint32_t Bits) {
  return (Bits & 0x7F800000) == 0 ? Bits & 0x80000000 : Bits;
}

void checkValues(Opcode Op, const ValueCase &Case, uint32_t Old,
                 bool FlushToZero) {
  ChipConfig Chip = quietChip(1, 1);
  Chip.FlushToZero = FlushToZero;
  bool FloatSources = false, FloatResult = false;
  for (const OperandInfo &Info : operandsOf(Op))
    if (Info.Kind == OperandKind::FloatRegister)
      (Info.IsDestination ? FloatResult : FloatSources) = true;

  Assembly A;
  A.constant(Results, DataBegin);
  std::vector<std::pair<Inputs, uint32_t>> Expectations;
  for (const Inputs &In : combinations(Op, Old)) {
    Inputs Seen = In;
    if (FlushToZero && Case.Flushes && FloatSources)
      Seen.Rs = flush(In.Rs), Seen.Rt = flush(In.Rt), Seen.Old = flush(In.Old);
    std::optional<uint32_t> Expected = Case.Expected(Seen);
    if (!Expected) {
      Assembly Trapping;
      emit(Trapping, Op, In);
      Trapping("halt", 0);
      Simulation S(Chip, Trapping);
      EXPECT_EQ(S.run().End, RunResult::Trapped)
          << std::hex << In.Rs << ' ' << In.Rt << ' ' << In.First;
      continue;
    }
    if (FlushToZero && Case.Flushes && FloatResult)
      Expected = flush(*Expected);
    if (emit(A, Op, In) == OperandKind::FloatRegister)
      A("mfc1", Rd, Rd);
    A("sw", Rd, Results, 0)("addi", Results, Results, 4);
    Expectations.push_back({In, *Expected});
  }
  A("halt", 0);

  ASSERT_FALSE(Expectations.empty());
  ASSERT_LT(A.nextAddress(), DataBegin);
  Simulation S(Chip, A);
  EXPECT_EQ(S.run().End, RunResult::Halted);
  uint32_t Address = DataBegin;
  for (const auto &[In, Expected] : Expectations) {
    uint32_t Actual = S.word(Address);
    EXPECT_TRUE(matches(Actual, Expected, Case.Ulps))
        << mnemonic(Op) << std::hex << " rs=" << In.Rs << " rt=" << In.Rt
        << " old=" << In.Old << " imm=" << In.First << ',' << In.Second
        << ": got " << Actual << ", expected " << Expected;
    Address += 4;
  }
}

class Execution : public testing::TestWithParam<unsigned> {};

TEST_P(Execution, MatchesTheIndependentComputation) {
  Opcode Op = Opcode(GetParam());
  auto Case = allCases().find(std::string(mnemonic(Op)));
  ASSERT_NE(Case, allCases().end())
      << mnemonic(Op) << " has no entry in the tables of test/unit/isa";
  if (auto *Values = std::get_if<ValueCase>(&Case->second)) {
    std::vector<uint32_t> OldValues = {0xA5A5A5A5, 0x3F800000};
    if (Values->Accumulates)
      OldValues.assign(std::begin(FloatEdges), std::end(FloatEdges));
    for (uint32_t Old : OldValues)
      for (bool FlushToZero : {false, true})
        checkValues(Op, *Values, Old, FlushToZero);
  } else {
    std::get<std::function<void()>>(Case->second)();
  }
}

TEST_P(Execution, DecodingInvertsEncoding) {
  // Each operand alone at its extremes; a decoded word has its opcode, and no
  // other opcode decodes from it.
  Opcode Op = Opcode(GetParam());
  std::span<const OperandInfo> Infos = operandsOf(Op);
  for (size_t Varied = 0; Varied <= Infos.size(); ++Varied) {
    std::vector<int64_t> Values(Infos.size(), 0);
    if (Varied != Infos.size()) {
      const OperandInfo &Info = Infos[Varied];
      int64_t Most = (int64_t(1) << (Info.Width - Info.IsSigned)) - 1;
      Values[Varied] = Most * Info.Scale;
      std::vector<int64_t> TooLarge = Values;
      TooLarge[Varied] += Info.Scale;
      EXPECT_FALSE(encode(Op, TooLarge));
    }
    std::optional<uint32_t> Word = encode(Op, Values);
    ASSERT_TRUE(Word);
    EXPECT_EQ(decode(*Word).Op, Op);
  }
}

INSTANTIATE_TEST_SUITE_P(AllOpcodes, Execution, testing::Range(0u, NumOpcodes),
                         [](const auto &Info) {
                           return std::string(mnemonic(Opcode(Info.param)));
                         });

TEST(ExecutionCases, NameOnlyInstructionsThatExist) {
  for (const auto &[Mnemonic, Case] : allCases())
    EXPECT_TRUE(findOpcode(Mnemonic)) << Mnemonic;
}

TEST(Decoder, RejectsWordsThatAreNoInstruction) {
  EXPECT_EQ(decode(0).Op, IllegalOpcode);
  EXPECT_EQ(decode(0xFFFFFFFF).Op, IllegalOpcode);
  // A reserved field that is not zero: bits 10..6 of add.
  uint32_t Add = *encode(Opcode::ADD, {1, 2, 3});
  EXPECT_EQ(decode(Add).Op, Opcode::ADD);
  EXPECT_EQ(decode(Add | 1 << 6).Op, IllegalOpcode);
}

} // namespace
