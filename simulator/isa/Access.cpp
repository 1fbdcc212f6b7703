//===- Access.cpp - What memory an instruction accesses -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/isa/Access.h"
#include "simulator/isa/Bodies.h"

namespace tp {

namespace {

/// The context of an instruction that is not executed (see Bodies.h).
class AccessProbe : public FloatRules<Subnormals::Keep> {
public:
  std::optional<MemoryAccess> Found;

  template <class T> T load(uint32_t At) {
    Found = {At, sizeof(T), true, false};
    return T();
  }
  template <class T> void store(uint32_t At, T) {
    Found = {At, sizeof(T), false, true};
  }
  template <class Function>
  uint32_t atomic(uint32_t At, uint32_t, uint32_t, Function) {
    Found = {At, 4, true, true};
    return 0;
  }
  template <class Function>
  uint32_t stream(uint32_t Descriptor, uint32_t, Function) {
    Found = {Descriptor, 4, true, true, true};
    return 0;
  }

  void branch(int32_t) {}
  void jump(uint32_t) {}
  uint32_t link() const { return 0; }
  void keepDestination() {}
  uint32_t special(SpecialRegister) const { return 0; }
  void marker(uint32_t) {}
  void profileValue(uint32_t, uint32_t) {}
  void barrier() {}
  void sync() {}
  void sleep(uint32_t) {}
  void halt(int32_t) {}
  uint32_t hostCall(uint32_t, uint32_t, uint32_t, uint32_t) { return 0; }
  void trap(TrapKind, uint32_t = 0) {}
};

using ProbeFunction = std::optional<MemoryAccess> (*)(
    const Instruction &, const std::array<uint32_t, NumRegisters> &);

} // namespace

template <Opcode Op>
static std::optional<MemoryAccess>
probe(const Instruction &Decoded,
      const std::array<uint32_t, NumRegisters> &Registers) {
  Body<Op> Run(Decoded, Registers.data());
  AccessProbe Context;
  Run.run(Context);
  return Context.Found;
}

std::optional<MemoryAccess>
accessOf(const Instruction &Decoded,
         const std::array<uint32_t, NumRegisters> &Registers) {
  static constexpr ProbeFunction Table[] = {
#define TP_PROBE_OF(NAME) probe<Opcode::NAME>,
      TP_EACH_OPCODE(TP_PROBE_OF)
#undef TP_PROBE_OF
  };
  if (Decoded.Op == IllegalOpcode)
    return std::nullopt;
  return Table[unsigned(Decoded.Op)](Decoded, Registers);
}

bool accessesMemory(Opcode Op) {
  Instruction Decoded;
  Decoded.Op = Op;
  return accessOf(Decoded, {}).has_value();
}

} // namespace tp
