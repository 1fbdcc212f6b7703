//===- HitCondition.h - Which hits of a breakpoint stop ---------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_HITCONDITION_H
#define TP_DEBUGGER_DAP_HITCONDITION_H

#include "llvm/ADT/StringRef.h"
#include "llvm/Support/Error.h"

#include <cstdint>

namespace tp::dap {

/// A hit condition as editors know it: `5` and `>= 5` stop at the fifth hit
/// and at all later ones, `== 5` only at the fifth, `% 5` at every fifth;
/// also `>`, `<` and `<=`.
class HitCondition {
public:
  /// Every hit.
  HitCondition() = default;
  static llvm::Expected<HitCondition> parse(llvm::StringRef Text);

  /// Whether hit \p Number, from 1 on, stops.
  bool accepts(uint64_t Number) const;

private:
  enum class Comparison { AtLeast, Equal, Above, Below, AtMost, Multiple };
  Comparison How = Comparison::AtLeast;
  uint64_t Bound = 1;
};

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_HITCONDITION_H
