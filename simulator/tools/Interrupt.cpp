//===- Interrupt.cpp - Ctrl-C ---------------------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/Interrupt.h"

#include <csignal>

namespace tp {

static std::atomic<bool> Interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free,
              "a signal handler may set it");

const std::atomic<bool> &stopOnInterrupt() {
  struct sigaction Action = {};
  Action.sa_handler = [](int) { Interrupted = true; };
  Action.sa_flags = SA_RESETHAND | SA_RESTART;
  sigemptyset(&Action.sa_mask);
  sigaction(SIGINT, &Action, nullptr);
  sigaction(SIGTERM, &Action, nullptr);
  return Interrupted;
}

} // namespace tp
