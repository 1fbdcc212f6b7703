//===- StopReason.h - Why the program stands, for a client ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_STOPREASON_H
#define TP_DEBUGGER_DAP_STOPREASON_H

#include "debugger/session/Session.h"

#include "llvm/ADT/StringRef.h"
#include "llvm/Support/JSON.h"

#include <map>

namespace tp::dap {

/// What the protocol calls a stop at a breakpoint, by the breakpoint's number.
using BreakpointWords = std::map<unsigned, llvm::StringLiteral>;

/// The body of the `stopped` event.
llvm::json::Object stoppedBody(const SessionStop &Stop, Session &Program,
                               const BreakpointWords &Words);

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_STOPREASON_H
