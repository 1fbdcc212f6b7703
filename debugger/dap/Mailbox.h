//===- Mailbox.h - Requests that wait for their turn ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_MAILBOX_H
#define TP_DEBUGGER_DAP_MAILBOX_H

#include "debugger/dap/Channel.h"
#include "debugger/dap/MessageStream.h"

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace tp::dap {

/// Reads the client's requests on a thread of its own, so that one can end what
/// another one has started. They are taken out one after the other.
class Mailbox {
public:
  /// \p Arrived is told about each request that comes in, and about the end of
  /// the input by none; on the reading thread.
  using Arrival = std::function<void(const Request *)>;

  Mailbox(llvm::sys::fs::file_t Input, Channel &Out, Arrival Arrived);
  /// The input must be at its end.
  ~Mailbox();

  /// Waits for the next request; nothing when there will be none. The request
  /// is the current one until the next call.
  std::optional<Request> take();

  /// Is a request waiting?
  bool waiting();

  /// Tells once more what is waiting, as if it came now.
  void announceWaiting();

  /// Did the client cancel the current request?
  bool currentCancelled();

private:
  MessageReader Reader;
  Channel &Out;
  Arrival Arrived;
  std::mutex Mutex;
  std::condition_variable Change;
  std::deque<Request> Queue;
  std::optional<int64_t> Current;
  bool Cancelled = false;
  bool Ended = false;
  std::thread Thread;

  void readAll();
  bool accept(const llvm::json::Value &Message);
  void cancel(const Request &Wish);
};

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_MAILBOX_H
