//===- TrapMessage.h - A trap in words --------------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_TOOLS_TRAPMESSAGE_H
#define TP_SIMULATOR_TOOLS_TRAPMESSAGE_H

#include "simulator/chip/ChipConfig.h"
#include "simulator/core/Trap.h"
#include "simulator/loader/Symbolizer.h"

#include <cstdint>
#include <functional>
#include <string>

namespace tp {

/// Reads a register of the thread that trapped: 0..31 integer, 32..63 float.
using RegisterFunction = std::function<uint32_t(unsigned Register)>;

/// What Trap::Cycle counts: cycles, or the thread's instructions in the
/// functional mode.
enum class TrapClock { Cycles, Instructions };

/// Who trapped, when, why, where in the source with the calls that were inlined
/// there, and the instruction with its operands. Several lines, without
/// `tpsim: error: ` and the last line end.
std::string trapMessage(const Trap &T, TrapClock Clock, const ChipConfig &Chip,
                        const ElfProgram &Program, Symbolizer &Symbols,
                        const RegisterFunction &Registers);

} // namespace tp

#endif // TP_SIMULATOR_TOOLS_TRAPMESSAGE_H
