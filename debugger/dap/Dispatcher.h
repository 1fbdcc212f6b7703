//===- Dispatcher.h - Who answers which request -----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_DISPATCHER_H
#define TP_DEBUGGER_DAP_DISPATCHER_H

#include "debugger/dap/Arguments.h"
#include "debugger/dap/Channel.h"

#include "llvm/ADT/StringMap.h"

#include <functional>

namespace tp::dap {

/// The body of a response, or why there is none.
using Response = llvm::Expected<llvm::json::Value>;

/// How far the session must be for a request.
enum class Stage {
  /// Nothing is loaded yet.
  Connected,
  /// The program is loaded; it may be running.
  Launched,
  /// The program stands.
  Stopped,
};

/// Takes requests to what answers them.
class Dispatcher {
public:
  /// \p Name is answered by \p Method of \p Owner, which must outlive the
  /// dispatcher.
  template <typename Owner, typename ArgumentsType>
  void on(llvm::StringRef Name, Stage Needs, Owner *Object,
          Response (Owner::*Method)(const ArgumentsType &)) {
    Handlers[Name] = {Needs, [=](const llvm::json::Value &Given) -> Response {
                        llvm::Expected<ArgumentsType> Arguments =
                            readArguments<ArgumentsType>(Given);
                        if (!Arguments)
                          return Arguments.takeError();
                        return (Object->*Method)(*Arguments);
                      }};
  }

  /// The same with the arguments as they came.
  void onRaw(llvm::StringRef Name, Stage Needs,
             std::function<Response(const llvm::json::Value &)> Handler) {
    Handlers[Name] = {Needs, std::move(Handler)};
  }

  /// Answers \p Wish, whose session has reached \p Reached. A request that was
  /// \p Cancelled meanwhile fails.
  void handle(const Request &Wish, Stage Reached, Channel &Out,
              llvm::function_ref<bool()> Cancelled) const;

private:
  struct Entry {
    Stage Needs = Stage::Connected;
    std::function<Response(const llvm::json::Value &)> Handler;
  };

  llvm::StringMap<Entry> Handlers;
};

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_DISPATCHER_H
