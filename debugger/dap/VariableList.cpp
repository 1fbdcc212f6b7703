//===- VariableList.cpp - What a client can unfold ------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/VariableList.h"

#include "llvm/ADT/ArrayRef.h"

#include <algorithm>

using namespace llvm;

namespace tp::dap {

VariableList::~VariableList() = default;

Expected<std::vector<VariableRow>>
FixedList::rows(uint32_t First, uint32_t Count, ValueFormat) const {
  uint32_t Begin = std::min(First, count());
  return ArrayRef(Rows).slice(Begin, std::min(Count, count() - Begin)).vec();
}

} // namespace tp::dap
