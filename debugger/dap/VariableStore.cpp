//===- VariableStore.cpp - Numbers of lists and frames --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/VariableStore.h"

using namespace llvm;

namespace tp::dap {

void VariableStore::clear() {
  FirstFrame += int64_t(Frames.size());
  FirstList += int64_t(Lists.size());
  Frames.clear();
  FrameNumbers.clear();
  Lists.clear();
}

int64_t VariableStore::frame(FramePlace Place) {
  auto [Known, IsNew] =
      FrameNumbers.try_emplace(Place, FirstFrame + int64_t(Frames.size()));
  if (IsNew)
    Frames.push_back(Place);
  return Known->second;
}

Expected<FramePlace> VariableStore::frame(int64_t Number) const {
  if (Number < FirstFrame || Number >= FirstFrame + int64_t(Frames.size()))
    return createStringError("there is no frame " + Twine(Number) +
                             " at this stop; ask for the stack again");
  return Frames[Number - FirstFrame];
}

int64_t VariableStore::list(std::shared_ptr<VariableList> List,
                            FramePlace Place) {
  if (!List)
    return 0;
  Lists.push_back({std::move(List), Place});
  return FirstList + int64_t(Lists.size()) - 1;
}

Expected<KeptList> VariableStore::list(int64_t Number) const {
  if (Number < FirstList || Number >= FirstList + int64_t(Lists.size()))
    return createStringError("there are no variables " + Twine(Number) +
                             " at this stop; ask for the scopes again");
  return Lists[Number - FirstList];
}

} // namespace tp::dap
