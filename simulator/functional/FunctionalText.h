//===- FunctionalText.h - A text, ready for the functional mode -*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_FUNCTIONAL_FUNCTIONALTEXT_H
#define TP_SIMULATOR_FUNCTIONAL_FUNCTIONALTEXT_H

#include "simulator/core/Program.h"
#include "simulator/functional/FunctionalHandlers.h"

#include <vector>

namespace tp {

/// The text with the handler of each instruction, one slot per word and one
/// behind it. \p FlushToZero as in the chip's description.
std::vector<FunctionalSlot> decodeFunctional(const Program &Text,
                                             bool FlushToZero);

} // namespace tp

#endif // TP_SIMULATOR_FUNCTIONAL_FUNCTIONALTEXT_H
