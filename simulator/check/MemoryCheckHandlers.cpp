//===- MemoryCheckHandlers.cpp - Instructions with memory checks ----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/check/MemoryChecks.h"
#include "simulator/functional/FunctionalText.h"

namespace tp {

std::vector<FunctionalSlot> MemoryChecks::decode(const tp::Program &Text,
                                                 bool FlushToZero) {
  return decodeWithChecks<MemoryChecks>(Text, FlushToZero,
                                        /*WatchesStack=*/true);
}

} // namespace tp
