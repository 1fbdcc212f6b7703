//===- Channel.h - What the adapter tells its client ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_CHANNEL_H
#define TP_DEBUGGER_DAP_CHANNEL_H

#include "llvm/ADT/StringRef.h"
#include "llvm/Support/Error.h"
#include "llvm/Support/JSON.h"
#include "llvm/Support/raw_ostream.h"

#include <cstdint>
#include <mutex>
#include <string>

namespace tp::dap {

/// A request as the client numbered it.
struct Request {
  int64_t Number = 0;
  std::string Command;
  llvm::json::Value Arguments = llvm::json::Object();
};

/// Reads a message of the client; only requests are expected.
bool fromJSON(const llvm::json::Value &Value, Request &Request,
              llvm::json::Path Path);

/// Sends responses and events; from any thread.
class Channel {
public:
  explicit Channel(llvm::raw_ostream &OS) : OS(OS) {}

  void event(llvm::StringRef Name, llvm::json::Value Body);
  void succeed(const Request &To, llvm::json::Value Body);
  /// \p Short is one of the protocol's words ("cancelled", "notStopped") or
  /// the text itself.
  void fail(const Request &To, llvm::StringRef Short, const llvm::Twine &Text);
  void fail(const Request &To, llvm::Error Problem);

  /// An output event. \p Category: "console", "stdout", "stderr", "important".
  void output(llvm::StringRef Category, llvm::StringRef Text);

private:
  llvm::raw_ostream &OS;
  std::mutex Mutex;
  int64_t NextNumber = 1;

  void send(llvm::json::Object Message);
};

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_CHANNEL_H
