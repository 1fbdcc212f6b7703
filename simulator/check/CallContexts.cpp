//===- CallContexts.cpp - The calls that led to any moment ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/check/CallContexts.h"

namespace tp {

CallContext CallContexts::child(CallContext Context, uint32_t CallPc) {
  if (Nodes.size() == MaxNodes) {
    auto Known = Children.find(uint64_t(Context) << 32 | CallPc);
    return Known == Children.end() ? 0 : Known->second;
  }
  auto [Child, IsNew] = Children.try_emplace(uint64_t(Context) << 32 | CallPc,
                                             CallContext(Nodes.size()));
  if (IsNew)
    Nodes.push_back({Context, CallPc});
  return Child->second;
}

std::vector<uint32_t> CallContexts::calls(CallContext Context) const {
  std::vector<uint32_t> Result;
  for (; Context != 0; Context = Nodes[Context].Caller)
    Result.push_back(Nodes[Context].CallPc);
  return Result;
}

std::vector<uint32_t> CallContexts::stackAt(uint32_t Pc,
                                            CallContext Context) const {
  std::vector<uint32_t> Result = calls(Context);
  Result.insert(Result.begin(), Pc);
  return Result;
}

} // namespace tp
