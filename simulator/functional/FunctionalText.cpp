//===- FunctionalText.cpp - A text, ready for the functional mode ---------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/functional/FunctionalText.h"

namespace tp {

std::vector<FunctionalSlot> decodeFunctional(const Program &Text,
                                             bool FlushToZero) {
  return decodeWithChecks<NoChecks>(Text, FlushToZero, /*WatchesStack=*/false);
}

} // namespace tp
