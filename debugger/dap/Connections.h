//===- Connections.h - How clients reach the adapter ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_CONNECTIONS_H
#define TP_DEBUGGER_DAP_CONNECTIONS_H

#include "llvm/Support/Error.h"
#include "llvm/Support/raw_ostream.h"

#include <cstdint>
#include <functional>

namespace tp::dap {

/// Talks to one client: reads from the file, writes to the stream, and returns
/// when the client has gone.
using Conversation = std::function<void(int Input, llvm::raw_ostream &Output)>;

/// The client that started this process. From then on what anyone prints on
/// standard output goes to standard error: the client would not understand it.
llvm::Error talkOnStandardStreams(const Conversation &Talk);

/// One client after the other on a TCP port of this computer; 0 takes a free
/// one. Prints on \p Log which one, and returns only with an error.
llvm::Error talkOnPort(uint16_t Port, const Conversation &Talk,
                       llvm::raw_ostream &Log);

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_CONNECTIONS_H
