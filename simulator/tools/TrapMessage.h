//===- TrapMessage.h - A trap in words --------------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_TOOLS_TRAPMESSAGE_H
#define TP_SIMULATOR_TOOLS_TRAPMESSAGE_H

#include "simulator/chip/ChipConfig.h"
#include "simulator/core/Program.h"
#include "simulator/core/Trap.h"
#include "simulator/loader/Symbolizer.h"

#include <string>

namespace tp {

/// Who trapped, when, why, and where in the source with the calls that were
/// inlined there. Several lines, without `tpsim: error: ` and the last line
/// end.
std::string trapMessage(const Trap &T, const ChipConfig &Chip,
                        const Program &Text, Symbolizer &Symbols);

} // namespace tp

#endif // TP_SIMULATOR_TOOLS_TRAPMESSAGE_H
