//===- Dispatcher.cpp - Who answers which request -------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/Dispatcher.h"

using namespace llvm;

namespace tp::dap {

void Dispatcher::handle(const Request &Wish, Stage Reached, Channel &Out,
                        function_ref<bool()> Cancelled) const {
  auto Found = Handlers.find(Wish.Command);
  if (Found == Handlers.end()) {
    Out.fail(Wish, "notSupported",
             "tpdbg does not know the request '" + Wish.Command + "'");
    return;
  }
  const Entry &Answerer = Found->second;
  if (Answerer.Needs != Stage::Connected && Reached == Stage::Connected) {
    Out.fail(Wish, "notLaunched",
             "'" + Wish.Command + "' needs a program; launch one first");
    return;
  }
  if (Answerer.Needs == Stage::Stopped && Reached != Stage::Stopped) {
    Out.fail(Wish, "notStopped",
             "'" + Wish.Command + "' needs a program that stands; pause it");
    return;
  }
  Response Body = Answerer.Handler(Wish.Arguments);
  if (Cancelled()) {
    consumeError(Body.takeError());
    Out.fail(Wish, "cancelled", "the client cancelled this request");
  } else if (Body) {
    Out.succeed(Wish, std::move(*Body));
  } else {
    Out.fail(Wish, Body.takeError());
  }
}

} // namespace tp::dap
