//===- Server.h - The debug adapter -----------------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_SERVER_H
#define TP_DEBUGGER_DAP_SERVER_H

#include "llvm/ADT/StringRef.h"
#include "llvm/Support/Error.h"

#include <cstdint>
#include <optional>

namespace tp::dap {

/// `tpdbg --dap`: serves the client that started the process or, with a port,
/// one client after the other there. Chips by name are below \p ChipFolder.
llvm::Error serve(std::optional<uint16_t> Port, llvm::StringRef ChipFolder);

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_SERVER_H
