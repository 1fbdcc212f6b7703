//===- ChipVariables.h - What the chip does with a thread -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_CHIPVARIABLES_H
#define TP_DEBUGGER_DAP_CHIPVARIABLES_H

#include "debugger/dap/VariableList.h"
#include "debugger/session/Session.h"

namespace tp::dap {

/// Cycle, state, why the thread does not issue, what is under way for it, and
/// the cycles that it has lost.
std::shared_ptr<VariableList> chipVariables(const Session &Program,
                                            uint32_t Thread);

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_CHIPVARIABLES_H
