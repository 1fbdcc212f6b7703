//===- ContextFloats.h - Float rules of an instruction's context *- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_CONTEXTFLOATS_H
#define TP_SIMULATOR_CORE_CONTEXTFLOATS_H

#include "simulator/isa/FloatRules.h"
#include "simulator/isa/TrapKind.h"

namespace tp {

/// The rules of FloatRules.h for \p Context, which has hasTrapped() and trap():
/// code that wants to know of subnormals traps at the first one.
template <class Context, Subnormals Mode>
class ContextFloats : public FloatRules<Mode> {
  using Rules = FloatRules<Mode>;
  friend Context;

  ContextFloats() = default;

public:
  float operand(float Value) {
    if constexpr (Mode == Subnormals::Trap)
      trapIfSubnormal(TrapKind::SubnormalOperand, Value);
    return Rules::operand(Value);
  }
  float result(float Value) {
    if constexpr (Mode == Subnormals::Trap)
      trapIfSubnormal(TrapKind::SubnormalResult, Value);
    return Rules::result(Value);
  }

private:
  void trapIfSubnormal(TrapKind Reason, float Value) {
    auto &Self = static_cast<Context &>(*this);
    bool IsSubnormal = Value != 0 && isBelowNormal(Value);
    if (IsSubnormal && !Self.hasTrapped())
      Self.trap(Reason, toBits(Value));
  }
};

} // namespace tp

#endif // TP_SIMULATOR_CORE_CONTEXTFLOATS_H
