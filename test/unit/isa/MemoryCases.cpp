//===- MemoryCases.cpp - Loads, stores, atomics and streams ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/core/Simulation.h"
#include "test/unit/isa/EdgeValues.h"
#include "test/unit/isa/InstructionCases.h"

#include "gtest/gtest.h"

#include <algorithm>

namespace tp::test {

namespace {

/// Bytes at the address that the memory tests use, with all sign bits.
constexpr uint8_t Pattern[8] = {0x81, 0x7F, 0xFE, 0x02, 0x10, 0x80, 0xFF, 0x44};
constexpr uint32_t Middle = DataBegin + 0x8000;

struct AccessShape {
  const char *Mnemonic;
  /// With the address as the sum of two registers.
  const char *Indexed;
  unsigned Bytes;
  bool SignExtends;
  bool Float;
};

/// The pattern's value at an offset, from its bytes.
uint32_t patternAt(unsigned Offset, unsigned Bytes, bool SignExtends) {
  uint32_t Value = 0;
  for (unsigned I = Bytes; I-- != 0;)
    Value = Value * 256 + Pattern[Offset + I];
  if (SignExtends && Pattern[Offset + Bytes - 1] >= 128)
    for (unsigned I = Bytes; I != 4; ++I)
      Value += 255u << I * 8;
  return Value;
}

/// Writes the pattern at the address in r20 by byte stores.
void storePattern(Assembly &A) {
  for (unsigned I = 0; I != 8; ++I)
    A("addi", 4, 0, Pattern[I])("sb", 4, 20, I);
}

/// The address of an access at \p Offset from r20: through an immediate from a
/// base that lies apart, or as the sum of two registers.
void access(Assembly &A, const AccessShape &Shape, bool Indexed, int Register,
            int Offset) {
  for (int Apart : {32000, -32000, 0}) {
    A.constant(21, uint32_t(Apart));
    if (Indexed) {
      A("sub", 22, 20, 21)("addi", 22, 22, Offset);
      A(Shape.Indexed, Register, 22, 21);
    } else {
      A("add", 22, 20, 21)(Shape.Mnemonic, Register, 22, Offset - Apart);
    }
  }
}

void checkLoad(const AccessShape &Shape, bool Indexed) {
  for (uint32_t Base : {Middle, LocalBegin + 16})
    for (unsigned Offset = 0; Offset + Shape.Bytes <= 8;
         Offset += Shape.Bytes) {
      Assembly A;
      A.constant(20, Base);
      storePattern(A);
      A("sync");
      access(A, Shape, Indexed, 10, int(Offset));
      A("halt", 0);
      Simulation S(quietChip(1, 1), A);
      S.cycles();
      EXPECT_EQ(S.registerOf(0, Shape.Float ? 32 + 10 : 10),
                patternAt(Offset, Shape.Bytes, Shape.SignExtends))
          << Shape.Mnemonic << " +" << Offset;
    }
}

void checkStore(const AccessShape &Shape, bool Indexed) {
  constexpr uint32_t Stored = 0xC3B2A190;
  for (uint32_t Base : {Middle, LocalBegin + 16})
    for (unsigned Offset = 0; Offset + Shape.Bytes <= 8;
         Offset += Shape.Bytes) {
      Assembly A;
      A.constant(20, Base);
      storePattern(A);
      A.constant(10, Stored)("mtc1", 10, 10);
      access(A, Shape, Indexed, 10, int(Offset));
      for (int I = 0; I != 8; ++I)
        A("lbu", 24 + I, 20, I);
      A("halt", 0);
      Simulation S(quietChip(1, 1), A);
      S.cycles();
      for (unsigned I = 0; I != 8; ++I) {
        bool Inside = I >= Offset && I < Offset + Shape.Bytes;
        uint32_t Expected =
            Inside ? Stored >> (I - Offset) * 8 & 255 : Pattern[I];
        EXPECT_EQ(S.registerOf(0, 24 + I), Expected)
            << Shape.Mnemonic << " +" << Offset << " byte " << I;
      }
    }
}

void addLoad(InstructionCases &Cases, AccessShape Shape) {
  Cases[Shape.Mnemonic] = [=] { checkLoad(Shape, false); };
  Cases[Shape.Indexed] = [=] { checkLoad(Shape, true); };
}

void addStore(InstructionCases &Cases, AccessShape Shape) {
  Cases[Shape.Mnemonic] = [=] { checkStore(Shape, false); };
  Cases[Shape.Indexed] = [=] { checkStore(Shape, true); };
}

using NewWord =
    std::function<uint32_t(uint32_t Old, uint32_t Operand, uint32_t Expected)>;

/// Runs the atomic on global memory and on the local store over all pairs of
/// edge values; the destination holds \p Expected before.
void checkAtomic(const char *Mnemonic, const NewWord &Function) {
  for (uint32_t Base : {Middle, LocalBegin + 16})
    for (uint32_t Old : IntegerEdges) {
      Assembly A;
      A.constant(20, Base).constant(21, DataBegin).constant(10, Old);
      for (uint32_t Operand : IntegerEdges) {
        // The destination is the old value for some, another for the others.
        A.constant(9, Old)("sw", 9, 20, 0).constant(11, Operand);
        A.constant(10, Operand % 2 ? Old : Old + 1)(Mnemonic, 10, 11, 20)(
            "lw", 12, 20, 0)("sw", 10, 21, 0)("sw", 12, 21, 4)("addi", 21, 21,
                                                               8);
      }
      A("halt", 0);
      Simulation S(quietChip(1, 1), A);
      S.cycles();
      uint32_t Address = DataBegin;
      for (uint32_t Operand : IntegerEdges) {
        uint32_t Expected = Operand % 2 ? Old : Old + 1;
        EXPECT_EQ(S.word(Address), Old) << Mnemonic;
        EXPECT_EQ(S.word(Address + 4), Function(Old, Operand, Expected))
            << Mnemonic << std::hex << ' ' << Old << ' ' << Operand;
        Address += 8;
      }
    }
}

int64_t sign(uint32_t Bits) {
  return Bits & 0x80000000 ? int64_t(Bits) - (int64_t(1) << 32) : Bits;
}

/// Counters near their overflow; a ring of two words.
void checkStreams() {
  Assembly A;
  A.constant(20, Middle);
  for (int I = 0; I != 3; ++I)
    A("addi", 4, 0, 50 + I)("stream_push", 5 + I, 4, 20);
  for (int I = 0; I != 3; ++I)
    A("stream_pop", 8 + I, 20);
  A("stream_push", 11, 4, 20)("stream_pop", 12, 20)("halt", 0);
  Simulation S(quietChip(1, 1), A);
  S.setWord(Middle, 0xFFFFFFFF);
  S.setWord(Middle + 4, 0xFFFFFFFF);
  S.setWord(Middle + 8, 2);
  S.cycles();
  const uint32_t Expected[] = {1, 1, 0, 50, 51, 0xFFFFFFFF, 1, 52};
  for (unsigned I = 0; I != 8; ++I)
    EXPECT_EQ(S.registerOf(0, 5 + I), Expected[I]) << I;
  EXPECT_EQ(S.word(Middle), 2u);
  EXPECT_EQ(S.word(Middle + 4), 2u);
}

} // namespace

void addMemoryCases(InstructionCases &Cases) {
  addLoad(Cases, {"lb", "lbx", 1, true, false});
  addLoad(Cases, {"lbu", "lbux", 1, false, false});
  addLoad(Cases, {"lh", "lhx", 2, true, false});
  addLoad(Cases, {"lhu", "lhux", 2, false, false});
  addLoad(Cases, {"lw", "lwx", 4, false, false});
  addLoad(Cases, {"lwc1", "lwxc1", 4, false, true});
  addStore(Cases, {"sb", "sbx", 1, false, false});
  addStore(Cases, {"sh", "shx", 2, false, false});
  addStore(Cases, {"sw", "swx", 4, false, false});
  addStore(Cases, {"swc1", "swxc1", 4, false, true});

  auto Atomic = [&](const char *Mnemonic, NewWord Function) {
    Cases[Mnemonic] = [=] { checkAtomic(Mnemonic, Function); };
  };
  Atomic("atom_add", [](uint32_t Old, uint32_t Operand, uint32_t) {
    return uint32_t(sign(Old) + sign(Operand));
  });
  Atomic("atom_and", [](uint32_t Old, uint32_t Operand, uint32_t) {
    return ~(~Old | ~Operand);
  });
  Atomic("atom_or", [](uint32_t Old, uint32_t Operand, uint32_t) {
    return ~(~Old & ~Operand);
  });
  Atomic("atom_xor", [](uint32_t Old, uint32_t Operand, uint32_t) {
    return (Old | Operand) - (Old & Operand);
  });
  Atomic("atom_min", [](uint32_t Old, uint32_t Operand, uint32_t) {
    return uint32_t(std::min(sign(Old), sign(Operand)));
  });
  Atomic("atom_max", [](uint32_t Old, uint32_t Operand, uint32_t) {
    return uint32_t(std::max(sign(Old), sign(Operand)));
  });
  Atomic("atom_minu", [](uint32_t Old, uint32_t Operand, uint32_t) {
    return std::min(Old, Operand);
  });
  Atomic("atom_maxu", [](uint32_t Old, uint32_t Operand, uint32_t) {
    return std::max(Old, Operand);
  });
  Atomic("atom_swap",
         [](uint32_t, uint32_t Operand, uint32_t) { return Operand; });
  Atomic("atom_cas", [](uint32_t Old, uint32_t Operand, uint32_t Expected) {
    return Expected - Old == 0 ? Operand : Old;
  });
  Cases["stream_push"] = checkStreams;
  Cases["stream_pop"] = checkStreams;
}

} // namespace tp::test
