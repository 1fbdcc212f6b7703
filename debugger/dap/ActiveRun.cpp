//===- ActiveRun.cpp - How a request stops what goes on -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/ActiveRun.h"

using namespace llvm;

namespace tp::dap {

/// Whether a request is to end what goes on.
static bool isEnding(const Request *Next) {
  return !Next || Next->Command == "cancel" || Next->Command == "pause" ||
         Next->Command == "terminate" || Next->Command == "disconnect" ||
         Next->Command == "restart";
}

void ActiveRun::begin(Session &Running, Interest Wanted) {
  std::lock_guard Lock(Mutex);
  Program = &Running;
  By = Wanted;
}

void ActiveRun::end() {
  std::lock_guard Lock(Mutex);
  Program = nullptr;
}

void ActiveRun::arrived(const Request *Next) {
  std::lock_guard Lock(Mutex);
  if (Program && (By == Interest::Any || isEnding(Next)))
    Program->interrupt();
}

} // namespace tp::dap
