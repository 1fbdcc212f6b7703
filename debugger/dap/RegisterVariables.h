//===- RegisterVariables.h - A frame's registers as a list ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_REGISTERVARIABLES_H
#define TP_DEBUGGER_DAP_REGISTERVARIABLES_H

#include "debugger/dap/VariableList.h"
#include "debugger/source/FrameContext.h"

namespace tp::dap {

/// The pc, the integer registers, and a group of the float registers.
std::shared_ptr<VariableList> registerVariables(const FrameContext &Frame);

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_REGISTERVARIABLES_H
