//===- HitCondition.cpp - Which hits of a breakpoint stop -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/HitCondition.h"

#include "llvm/Support/ErrorHandling.h"

using namespace llvm;

namespace tp::dap {

Expected<HitCondition> HitCondition::parse(StringRef Text) {
  HitCondition Result;
  StringRef Rest = Text.trim();
  if (Rest.consume_front(">="))
    Result.How = Comparison::AtLeast;
  else if (Rest.consume_front("<="))
    Result.How = Comparison::AtMost;
  else if (Rest.consume_front("==") || Rest.consume_front("="))
    Result.How = Comparison::Equal;
  else if (Rest.consume_front(">"))
    Result.How = Comparison::Above;
  else if (Rest.consume_front("<"))
    Result.How = Comparison::Below;
  else if (Rest.consume_front("%"))
    Result.How = Comparison::Multiple;
  if (Rest.trim().getAsInteger(10, Result.Bound) || Result.Bound == 0)
    return createStringError("hit condition '" + Text +
                             "': expected a whole number from 1 on, perhaps "
                             "behind one of >= > == < <= %");
  return Result;
}

bool HitCondition::accepts(uint64_t Number) const {
  switch (How) {
  case Comparison::AtLeast:
    return Number >= Bound;
  case Comparison::Equal:
    return Number == Bound;
  case Comparison::Above:
    return Number > Bound;
  case Comparison::Below:
    return Number < Bound;
  case Comparison::AtMost:
    return Number <= Bound;
  case Comparison::Multiple:
    return Number % Bound == 0;
  }
  llvm_unreachable("unknown comparison");
}

} // namespace tp::dap
