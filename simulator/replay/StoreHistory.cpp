//===- StoreHistory.cpp - Tells a history each functional store -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/replay/StoreHistory.h"
#include "simulator/functional/FunctionalText.h"

namespace tp {

std::vector<FunctionalSlot> StoreHistory::decode(const Program &Text,
                                                 bool FlushToZero) {
  return decodeWithChecks<StoreHistory>(Text, FlushToZero,
                                        /*WatchesStack=*/false);
}

} // namespace tp
