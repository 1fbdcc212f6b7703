//===- ControlCases.cpp - Branches, jumps, traps, synchronisation ---------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/core/Simulation.h"
#include "test/unit/isa/EdgeValues.h"
#include "test/unit/isa/InstructionCases.h"

#include "gtest/gtest.h"

namespace tp::test {

using Condition = std::function<bool(int64_t, int64_t)>;

static int64_t sign(uint32_t Bits) {
  return Bits & 0x80000000 ? int64_t(Bits) - (int64_t(1) << 32) : Bits;
}

static int64_t zeroExtended(uint32_t Bits) { return Bits; }

/// Stores 1 where the branch is taken, 0 where not, forwards and backwards.
static void checkBranch(const char *Mnemonic, int64_t (*Extend)(uint32_t),
                        const Condition &Holds) {
  Assembly A;
  A.constant(20, DataBegin);
  unsigned Number = 0;
  for (uint32_t Left : IntegerEdges)
    for (uint32_t Right : IntegerEdges) {
      std::string Name = std::to_string(Number++);
      std::string Forward = "f" + Name, Back = "b" + Name, End = "e" + Name;
      A.constant(11, Left).constant(12, Right)("addi", 10, 0,
                                               1)("j", Forward.c_str());
      A.label(Back)("j", End.c_str()).label(Forward);
      A(Mnemonic, 11, 12, Back.c_str())("addi", 10, 0, 0);
      A(Mnemonic, 11, 12, 8)("j", End.c_str())("addi", 10, 10, 2);
      A.label(End)("sw", 10, 20, 0)("addi", 20, 20, 4);
    }
  A("halt", 0);
  Simulation S(quietChip(1, 1), A);
  S.cycles();
  uint32_t Address = DataBegin;
  for (uint32_t Left : IntegerEdges)
    for (uint32_t Right : IntegerEdges) {
      EXPECT_EQ(S.word(Address), Holds(Extend(Left), Extend(Right)))
          << Mnemonic << std::hex << ' ' << Left << ' ' << Right;
      Address += 4;
    }
}

static void checkBranchLink(const char *Mnemonic, bool WhenNegative) {
  for (uint32_t Value : IntegerEdges) {
    Assembly A;
    A.constant(11, Value)("addi", 31, 0, 77);
    uint32_t Return = A.nextAddress() + 4;
    A(Mnemonic, 11, "target")("halt", 0).label("target")("addi", 10, 0,
                                                         1)("halt", 0);
    Simulation S(quietChip(1, 1), A);
    S.cycles();
    bool Taken = (Value >= 0x80000000) == WhenNegative;
    EXPECT_EQ(S.registerOf(0, 10), Taken) << Mnemonic;
    EXPECT_EQ(S.registerOf(0, 31), Taken ? Return : 77u) << Mnemonic;
  }
}

static void checkTrap(const char *Mnemonic, int64_t (*Extend)(uint32_t),
                      const Condition &Holds) {
  for (uint32_t Left : IntegerEdges)
    for (uint32_t Right : IntegerEdges) {
      Assembly A;
      A.constant(11, Left).constant(12, Right)(Mnemonic, 11, 12)("halt", 0);
      Simulation S(quietChip(1, 1), A);
      RunResult Result = S.run();
      bool Traps = Holds(Extend(Left), Extend(Right));
      EXPECT_EQ(Result.End, Traps ? RunResult::Trapped : RunResult::Halted)
          << Mnemonic << std::hex << ' ' << Left << ' ' << Right;
      if (Traps && Result.TrapInfo)
        EXPECT_EQ(Result.TrapInfo->Kind, TrapKind::Condition);
    }
}

/// A jump over `halt 9`; \p Links if it sets r31, \p Indirect if its target is
/// in a register.
static void checkJump(const char *Mnemonic, bool Links, bool Indirect) {
  Assembly A;
  A("addi", 31, 0, 77)("addi", 9, 0, 9);
  if (Indirect)
    A.constant(4, TextBegin + 6 * 4)(Mnemonic, 4);
  else
    A("addi", 0, 0, 0)("addi", 0, 0, 0)(Mnemonic, "target");
  uint32_t Return = A.nextAddress();
  A("halt", 9).label("target")("halt", 0);
  ASSERT_EQ(Return, TextBegin + 5 * 4);
  Simulation S(quietChip(1, 1), A);
  EXPECT_EQ(S.run().ExitStatus, 0);
  EXPECT_EQ(S.registerOf(0, 31), Links ? Return : 77u);
}

static void checkSpecialRegisters() {
  ChipConfig Chip = quietChip(3, 4);
  for (unsigned Number = 0; Number != 32; ++Number) {
    Assembly A;
    A.repeat(3, "addi", 5, 0, 1)("mfsr", 4, Number)("halt", 0);
    Simulation S(Chip, A);
    if (Number >= NumSpecialRegisters) {
      RunResult Result = S.run();
      ASSERT_TRUE(Result.TrapInfo);
      EXPECT_EQ(Result.TrapInfo->Kind, TrapKind::IllegalInstruction);
      continue;
    }
    S.cycles();
    std::string Name(specialRegisterName(SpecialRegister(Number)));
    for (uint32_t Thread = 0; Thread != 12; ++Thread) {
      const std::map<std::string, uint32_t> Expected = {
          {"thread", Thread}, {"tp", Thread % 4}, {"tm", Thread / 4},
          {"nthread", 12},    {"ntp", 4},         {"ntm", 3},
          {"lssize", 1024},   {"cycle", 3},       {"cycleh", 0},
          {"instret", 3},     {"instreth", 0}};
      EXPECT_EQ(S.registerOf(Thread, 4), Expected.at(Name)) << Name;
    }
  }
}

static void checkBarrier() {
  // What each stores before the barrier all see after it.
  Assembly A;
  A("mfsr", 4, int(SpecialRegister::thread))("sll", 5, 4, 2)(
      "lui", 20, DataBegin >> 16)("add", 21, 20, 5)("sll", 6, 4, 5)("sleep", 6)(
      "addi", 6, 4, 1)("sw", 6, 21, 0)("barrier")("addi", 7, 0, 4);
  A.label("sum")("lw", 8, 20, 0)("add", 9, 9, 8)("addi", 20, 20, 4)(
      "addi", 7, 7, -1)("bne", 7, 0, "sum")("halt", 0);
  Simulation S(quietChip(2, 2), A);
  S.cycles();
  for (uint32_t Thread = 0; Thread != 4; ++Thread)
    EXPECT_EQ(S.registerOf(Thread, 9), 10u);
}

static void checkSync() {
  Assembly A;
  A("addi", 4, 0, 1)("sync")("addi", 4, 4, 1)("halt", 0);
  Simulation S(quietChip(1, 1), A);
  S.cycles();
  EXPECT_EQ(S.registerOf(0, 4), 2u);
  EXPECT_EQ(S.lost(0, Loss::Sync), 14u);
}

static void checkSleep() {
  for (uint32_t Cycles : {0u, 1u, 13u, 14u, 1000u}) {
    Assembly A;
    A("addi", 4, 0, Cycles)("sleep", 4)("halt", 0);
    Simulation S(quietChip(1, 1), A);
    EXPECT_EQ(S.cycles(), 3 + Cycles);
  }
}

static void checkHalt() {
  for (int Status : {0, 1, -1, 255}) {
    Assembly A;
    A("addi", 4, 0, Status)("halt", 4)("break", 1);
    Simulation S(quietChip(1, 1), A);
    RunResult Result = S.run();
    EXPECT_EQ(Result.End, RunResult::Halted);
    EXPECT_EQ(Result.ExitStatus, Status);
  }
}

static void checkBreak() {
  for (uint32_t Code : {0u, 1u, 0xFFFFu}) {
    Assembly A;
    Simulation S(quietChip(1, 1), A("break", Code));
    RunResult Result = S.run();
    ASSERT_TRUE(Result.TrapInfo);
    EXPECT_EQ(Result.TrapInfo->Kind, TrapKind::Break);
    EXPECT_EQ(Result.TrapInfo->Address, Code);
  }
}

static void checkMarkers() {
  Assembly A;
  A("prof", 3)("prof", 3)("prof", 0xFFFF)("halt", 0);
  Simulation S(quietChip(1, 2), A);
  S.cycles();
  ASSERT_EQ(S.statistics().Markers.size(), 0x10000u);
  EXPECT_EQ(S.statistics().Markers[3], 4u);
  EXPECT_EQ(S.statistics().Markers[0xFFFF], 2u);
  EXPECT_EQ(S.statistics().Markers[4], 0u);
}

static void checkProfileValues() {
  struct : ProfileObserver {
    void profileValue(uint32_t, uint32_t Marker, uint32_t Value) override {
      Seen.push_back({Marker, Value});
    }
    std::vector<std::pair<uint32_t, uint32_t>> Seen;
  } Observer;
  std::vector<std::pair<uint32_t, uint32_t>> Expected;
  Assembly A;
  for (uint32_t Marker : {0u, 0x100u, 0xFFFFu})
    for (uint32_t Value : IntegerEdges) {
      A.constant(11, Value)("profv", Marker, 11);
      Expected.push_back({Marker, Value});
    }
  Simulation S(quietChip(1, 1), A("halt", 0));
  S.setObserver(Observer);
  S.cycles();
  EXPECT_EQ(Observer.Seen, Expected);
}

static void checkHostCall() {
  Assembly A;
  A.constant(5, DataBegin)("addi", 4, 0, 2)("addi", 6, 0, 5)("hostcall", 0)(
      "addi", 7, 2, 0)("lui", 6, 1)("addi", 4, 0, 1)("hostcall", 0)("halt", 0);
  Simulation S(quietChip(1, 1), A);
  EXPECT_TRUE(S.memory().write(DataBegin, "hello world", 11));
  S.cycles();
  // The second asks for 65536 bytes and gets the most there is in one call.
  EXPECT_EQ(S.registerOf(0, 7), 5u);
  EXPECT_EQ(S.registerOf(0, 2), 4096u);
  EXPECT_EQ(S.output().substr(0, 16), "hellohello world");
  EXPECT_EQ(S.output().size(), 5u + 4096u);
}

void addControlCases(InstructionCases &Cases) {
  struct Comparison {
    const char *Branch;
    const char *Trap;
    int64_t (*Extend)(uint32_t);
    Condition Holds;
  };
  const Comparison Comparisons[] = {
      {"beq", "teq", zeroExtended, std::equal_to<>()},
      {"bne", "tne", zeroExtended, std::not_equal_to<>()},
      {"blt", "tlt", sign, std::less<>()},
      {"bge", "tge", sign, std::greater_equal<>()},
      {"bltu", "tltu", zeroExtended, std::less<>()},
      {"bgeu", "tgeu", zeroExtended, std::greater_equal<>()},
  };
  for (const Comparison &Each : Comparisons) {
    Cases[Each.Branch] = [=] {
      checkBranch(Each.Branch, Each.Extend, Each.Holds);
    };
    Cases[Each.Trap] = [=] { checkTrap(Each.Trap, Each.Extend, Each.Holds); };
  }
  Cases["bltzal"] = [] { checkBranchLink("bltzal", true); };
  Cases["bgezal"] = [] { checkBranchLink("bgezal", false); };
  Cases["j"] = [] { checkJump("j", false, false); };
  Cases["jal"] = [] { checkJump("jal", true, false); };
  Cases["jr"] = [] { checkJump("jr", false, true); };
  Cases["jalr"] = [] { checkJump("jalr", true, true); };
  Cases["mfsr"] = checkSpecialRegisters;
  Cases["barrier"] = checkBarrier;
  Cases["sync"] = checkSync;
  Cases["sleep"] = checkSleep;
  Cases["halt"] = checkHalt;
  Cases["break"] = checkBreak;
  Cases["prof"] = checkMarkers;
  Cases["profv"] = checkProfileValues;
  Cases["hostcall"] = checkHostCall;
}

} // namespace tp::test
