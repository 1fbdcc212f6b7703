//===- Breakpoints.cpp - Where and when to stop ---------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/session/Breakpoints.h"

#include "llvm/ADT/STLExtras.h"

using namespace llvm;

namespace tp {

Breakpoint &BreakpointTable::add(Breakpoint New) {
  New.Number = ++Last;
  return *All.emplace_back(std::make_unique<Breakpoint>(std::move(New)));
}

bool BreakpointTable::remove(unsigned Number) {
  size_t Before = All.size();
  erase_if(All, [&](const std::unique_ptr<Breakpoint> &B) {
    return B->Number == Number;
  });
  return All.size() != Before;
}

void BreakpointTable::forgetRun() {
  erase_if(All, [](const std::unique_ptr<Breakpoint> &B) {
    return B->isWatchpoint() && B->Watched->ScopeCfa;
  });
  for (std::unique_ptr<Breakpoint> &B : All)
    B->Hits = 0;
}

Breakpoint *BreakpointTable::find(unsigned Number) {
  for (std::unique_ptr<Breakpoint> &B : All)
    if (B->Number == Number)
      return B.get();
  return nullptr;
}

} // namespace tp
