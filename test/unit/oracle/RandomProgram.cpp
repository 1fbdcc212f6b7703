//===- RandomProgram.cpp - Random programs --------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/oracle/RandomProgram.h"
#include "runtime/include/tp/host_call.h"

#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string_view>

namespace tp::test {

namespace {

constexpr uint32_t TextBegin = 0x10000;
constexpr uint32_t DataBegin = 0x18000;
/// Words of data that programs touch through DataBegin.
constexpr uint32_t DataWords = 32;
constexpr uint32_t StreamBegin = DataBegin + 0x100;
constexpr uint32_t StreamCapacity = 4;

// What the registers are for. Results go to the first FreeRegisters, sources
// are any of the first SourceRegisters.
constexpr unsigned FreeRegisters = 12, SourceRegisters = 15;
constexpr unsigned Computed = 16, Index = 17, Rounds = 18, GlobalBase = 20,
                   LocalBase = 21, StreamBase = 22, TextAddress = 23,
                   Divisor = 25, One = 26;
constexpr unsigned FloatRegisters = 12;

/// Words that computations like to stumble over.
constexpr uint32_t Edges[] = {
    0,          1,          2,          31,         0x7FFFFFFF, 0x80000000,
    0xFFFFFFFF, 0x00000001, 0x007FFFFF, 0x00800000, 0x3F800000, 0xBF800000,
    0x40490FDB, 0x7F7FFFFF, 0x7F800000, 0xFF800000, 0x7FC00000, 0x7FA00001,
    0x4F000000, 0xCF000001, 0x4B000001, 0x34000000, 0x80000001, 0x3FC90FDB};

/// How an immediate depends on where things are.
enum class Place { None, Distance, HighHalf, LowHalf };

struct Line {
  Opcode Op;
  std::vector<int64_t> Operands;
  /// Of the last operand, if it has to do with the address of an item.
  Place Kind = Place::None;
  uint32_t Item = 0;
};

/// Lines that only make sense one after the other. Branches lead to items.
using Item = std::vector<Line>;

class Generator {
public:
  Generator(RandomSource &Random, ProgramShape Shape, const ChipConfig &Chip)
      : Random(Random), Shape(Shape), Chip(Chip) {}

  std::vector<Item> Items;

  void generate() {
    prologue();
    NumItems = uint32_t(Items.size()) + Random.between(10, 60);
    while (Items.size() < NumItems) {
      if (Shape == ProgramShape::Branching && Random.oneIn(12))
        loop();
      else
        instruction(randomOpcode());
    }
    add({{Opcode::HALT, {Random.oneIn(3) ? source() : 0}}});
  }

private:
  RandomSource &Random;
  const ProgramShape Shape;
  const ChipConfig &Chip;
  uint32_t NumItems = 0;

  void add(Item Lines) { Items.push_back(std::move(Lines)); }

  Line immediate(Opcode Op, unsigned Destination, unsigned Source,
                 int64_t Value) {
    return {Op, {Destination, Source, Value}};
  }

  void constant(unsigned Register, uint32_t Value) {
    add({{Opcode::LUI, {Register, Value >> 16}},
         immediate(Opcode::ORI, Register, Register, Value & 0xFFFF)});
  }

  uint32_t value() {
    return Random.oneIn(2) ? Edges[Random.below(std::size(Edges))]
                           : Random.word();
  }

  void prologue() {
    constant(GlobalBase, DataBegin);
    constant(LocalBase, 0 - Chip.LocalStoreBytes + 64);
    constant(StreamBase, StreamBegin);
    constant(StackPointerRegister, 0 - 96);
    constant(Divisor, value() | 1);
    add({immediate(Opcode::ADDI, One, 0, 1)});
    for (unsigned I = 0; I != 5; ++I) {
      constant(1 + Random.below(FreeRegisters), value());
      unsigned Register = 1 + Random.below(FreeRegisters);
      constant(Register, value());
      add({{Opcode::MTC1, {Random.below(FloatRegisters), Register}}});
    }
    // Threads differ from here on.
    add({{Opcode::MFSR,
          {1 + Random.below(FreeRegisters),
           int64_t(SpecialRegister::thread)}}});
  }

  int64_t source() { return Random.below(SourceRegisters); }
  int64_t destination() {
    return Random.oneIn(20) ? 0 : 1 + Random.below(FreeRegisters);
  }
  int64_t base() {
    if (Random.oneIn(300))
      return source();
    constexpr unsigned Bases[] = {GlobalBase, LocalBase, Computed};
    return Bases[Random.below(std::size(Bases))];
  }

  Opcode randomOpcode() {
    // Memory is where threads meet.
    if (Random.oneIn(4))
      return Opcode(
          Random.between(unsigned(Opcode::LB), unsigned(Opcode::STREAM_POP)));
    return Opcode(Random.below(NumOpcodes));
  }

  /// The item to which a branch goes.
  uint32_t target() {
    uint32_t Next = uint32_t(Items.size()) + 1;
    if (Shape == ProgramShape::StraightLine)
      return Next;
    return std::min(NumItems, Next + Random.below(6));
  }

  void loop() {
    add({immediate(Opcode::ADDI, Rounds, 0, Random.between(1, 12))});
    uint32_t Begin = uint32_t(Items.size());
    for (uint32_t Left = Random.between(1, 8); Left != 0; --Left)
      instruction(randomOpcode());
    add({immediate(Opcode::ADDI, Rounds, Rounds, -1)});
    add({{Opcode::BLT, {0, Rounds, 0}, Place::Distance, Begin}});
    NumItems = std::max(NumItems, uint32_t(Items.size()));
  }

  static unsigned accessBytes(Opcode Op) {
    char Size = mnemonic(Op)[1];
    return Size == 'b' ? 1 : Size == 'h' ? 2 : 4;
  }

  int64_t immediateOf(Opcode Op, const OperandInfo &Info) {
    if (Op == Opcode::MFSR)
      return Random.oneIn(100) ? 31 : Random.below(NumSpecialRegisters);
    if (Op == Opcode::PROF || Op == Opcode::PROFV)
      return Random.below(8);
    if (Op == Opcode::HOSTCALL)
      return Random.oneIn(100) ? 1 : kHostCallWrite;
    unsigned Steps = 1u << std::min<unsigned>(Info.Width, 20);
    int64_t Value =
        int64_t(Random.below(Steps)) - (Info.IsSigned ? Steps / 2 : 0);
    return Value * Info.Scale;
  }

  /// Any registers and immediates.
  Line anyOperands(Opcode Op) {
    Line L{Op, {}};
    for (const OperandInfo &Info : operandsOf(Op)) {
      if (Info.Kind == OperandKind::Immediate)
        L.Operands.push_back(immediateOf(Op, Info));
      else if (Info.Kind == OperandKind::FloatRegister)
        L.Operands.push_back(Random.below(FloatRegisters));
      else
        L.Operands.push_back(Info.IsDestination ? destination() : source());
    }
    return L;
  }

  int64_t &operand(Line &L, std::string_view Name) {
    std::span<const OperandInfo> Infos = operandsOf(L.Op);
    for (size_t I = 0; I != Infos.size(); ++I)
      if (Infos[I].Name == Name)
        return L.Operands[I];
    std::fprintf(stderr, "%s has no operand %s\n",
                 std::string(mnemonic(L.Op)).c_str(),
                 std::string(Name).c_str());
    std::abort();
  }

  static bool hasOperand(Opcode Op, std::string_view Name) {
    for (const OperandInfo &Info : operandsOf(Op))
      if (Info.Name == Name)
        return true;
    return false;
  }

  void instruction(Opcode Op) {
    switch (takesTime(Op) ? latencyClassOf(Op) : LatencyClass::IntAdd) {
    case LatencyClass::Load:
    case LatencyClass::Store:
      return memoryAccess(Op);
    case LatencyClass::Atomic:
      return atomic(Op);
    case LatencyClass::IntDiv:
      return division(Op);
    case LatencyClass::Branch:
      return branch(Op);
    case LatencyClass::Control:
      return control(Op);
    default:
      break;
    }
    Line L = anyOperands(Op);
    bool HasField = Op == Opcode::EXT || Op == Opcode::INS;
    if (HasField && !Random.oneIn(50) &&
        operand(L, "lowest") > operand(L, "highest"))
      std::swap(operand(L, "lowest"), operand(L, "highest"));
    if (Op == Opcode::ADDI && Random.oneIn(4))
      return moveStackPointer();
    add({L});
  }

  void moveStackPointer() {
    int64_t Sp = StackPointerRegister;
    add({{Opcode::ADDI, {Sp, Sp, Random.oneIn(2) ? -32 : 32}}});
  }

  /// Makes the address or index that some accesses use.
  Item address() {
    Item Lines;
    if (Random.oneIn(2)) {
      Lines.push_back(immediate(Opcode::ANDI, Index, source(), 0x3C));
      unsigned Base = Random.oneIn(2) ? GlobalBase : LocalBase;
      Lines.push_back({Opcode::ADD, {Computed, Base, Index}});
    }
    return Lines;
  }

  void memoryAccess(Opcode Op) {
    unsigned Bytes = accessBytes(Op);
    Line L = anyOperands(Op);
    Item Lines = address();
    operand(L, "rs") = base();
    if (hasOperand(Op, "rt")) {
      // Base and index have not both been added up.
      operand(L, "rs") = Random.oneIn(2) ? GlobalBase : LocalBase;
      operand(L, "rt") = Index;
    } else {
      operand(L, "imm") = Random.below(64 / Bytes) * Bytes;
      if (Random.oneIn(400))
        operand(L, "imm") += 1;
    }
    Lines.push_back(L);
    add(Lines);
  }

  void atomic(Opcode Op) {
    Line L = anyOperands(Op);
    Item Lines = address();
    bool IsStream = Op == Opcode::STREAM_PUSH || Op == Opcode::STREAM_POP;
    operand(L, "rs") = IsStream && !Random.oneIn(100) ? StreamBase : base();
    int64_t Destination = L.Operands.front();
    Lines.push_back(L);
    add(Lines);
    if (Random.oneIn(4))
      add({{Opcode::PROFV, {Random.below(8), Destination}}});
  }

  void division(Opcode Op) {
    Line L = anyOperands(Op);
    if (!Random.oneIn(20))
      operand(L, "rt") = Divisor;
    add({L});
  }

  void branch(Opcode Op) {
    uint32_t To = target();
    if (Op == Opcode::JR || Op == Opcode::JALR) {
      add({{Opcode::LUI, {TextAddress, 0}, Place::HighHalf, To},
           {Opcode::ORI, {TextAddress, TextAddress, 0}, Place::LowHalf, To},
           {Op, {Random.oneIn(200) ? source() : int64_t(TextAddress)}}});
      return;
    }
    Line L = anyOperands(Op);
    L.Kind = Place::Distance;
    L.Item = To;
    add({L});
  }

  void control(Opcode Op) {
    Line L = anyOperands(Op);
    switch (Op) {
    case Opcode::HALT:
    case Opcode::BREAK:
      if (!Random.oneIn(25))
        return;
      break;
    case Opcode::SLEEP: {
      int64_t Cycles = 1 + Random.below(FreeRegisters);
      return add({immediate(Opcode::ANDI, Cycles, source(),
                            Random.oneIn(4) ? 0x7F : 7),
                  {Op, {Cycles}}});
    }
    case Opcode::HOSTCALL:
      return add(
          {immediate(Opcode::ADDI, 4, 0, Random.between(1, 2)),
           immediate(Opcode::ADDI, 5, Random.oneIn(2) ? GlobalBase : LocalBase,
                     Random.below(32)),
           immediate(Opcode::ANDI, 6, source(), 15), L});
    case Opcode::TEQ:
    case Opcode::TNE:
    case Opcode::TLT:
    case Opcode::TGE:
    case Opcode::TLTU:
    case Opcode::TGEU:
      if (!Random.oneIn(50))
        neverTraps(L);
      break;
    default:
      break;
    }
    add({L});
  }

  void neverTraps(Line &L) {
    bool IfEqual =
        L.Op == Opcode::TEQ || L.Op == Opcode::TGE || L.Op == Opcode::TGEU;
    int64_t Any = source();
    operand(L, "rs") = IfEqual ? 0 : Any;
    operand(L, "rt") = IfEqual ? int64_t(One) : Any;
  }
};

std::vector<uint32_t> assemble(const std::vector<Item> &Items,
                               uint32_t Address) {
  std::vector<uint32_t> Addresses;
  uint32_t Next = Address;
  for (const Item &Lines : Items) {
    Addresses.push_back(Next);
    Next += uint32_t(Lines.size()) * 4;
  }
  std::vector<uint32_t> Words;
  for (const Item &Lines : Items)
    for (Line L : Lines) {
      if (L.Kind != Place::None) {
        uint32_t To = Addresses[L.Item];
        L.Operands.back() = L.Kind == Place::Distance   ? int64_t(To) - Address
                            : L.Kind == Place::HighHalf ? To >> 16
                                                        : To & 0xFFFF;
      }
      std::optional<uint32_t> Word = encode(L.Op, L.Operands);
      if (!Word) {
        std::fprintf(stderr, "cannot encode '%s'\n",
                     std::string(mnemonic(L.Op)).c_str());
        std::abort();
      }
      Words.push_back(*Word);
      Address += 4;
    }
  return Words;
}

} // namespace

RandomProgram::RandomProgram(RandomSource &Random, ProgramShape Shape,
                             const ChipConfig &Chip) {
  Generator G(Random, Shape, Chip);
  G.generate();
  // A word that is no instruction in front of some.
  if (Random.oneIn(4))
    Words.push_back(0);
  Entry = TextBegin + uint32_t(Words.size()) * 4;
  for (uint32_t Word : assemble(G.Items, Entry))
    Words.push_back(Word);
  uint32_t End = TextBegin + uint32_t(Words.size()) * 4;
  ReadOnlyEnd = End + 16 * Random.below(3);
  if (Random.oneIn(3))
    StackLimit = 0 - 96 - 32 * Random.between(1, 4);
  if (Random.oneIn(4)) {
    CheckedBegin = TextBegin + 4 * Random.below(uint32_t(Words.size()));
    CheckedEnd = std::min(End, CheckedBegin + 4 * Random.between(1, 20));
  }
  for (uint32_t I = 0; I != DataWords; ++I)
    if (Random.oneIn(2))
      Data.push_back({DataBegin + 4 * I, Random.word()});
  Data.push_back({StreamBegin + 8, StreamCapacity});
}

Program RandomProgram::text() const {
  Program Text(TextBegin, Words, Entry, ReadOnlyEnd);
  Text.setStackLimit(StackLimit);
  if (CheckedBegin != CheckedEnd)
    Text.addFloatChecked(CheckedBegin, CheckedEnd);
  return Text;
}

void RandomProgram::initialize(Memory &Global) const {
  for (auto [Address, Value] : Data)
    Global.write(Address, &Value, sizeof(Value));
}

} // namespace tp::test
