//===- NullAccess.cpp - Kernels that use a null pointer -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/native/NullAccess.h"

#include "tp/memory_map.h"

#include <csignal>
#include <cstdint>
#include <cstring>
#include <unistd.h>

namespace tp {

static const char *ProgramName;

/// Only what a signal handler may use.
static void print(const char *Text) {
  [[maybe_unused]] const ssize_t Written =
      write(STDERR_FILENO, Text, std::strlen(Text));
}

static void handleFault(int Signal, siginfo_t *Fault, void *) {
  if (reinterpret_cast<uintptr_t>(Fault->si_addr) >= kGlobalMemoryBegin) {
    // The access is repeated, without this handler.
    std::signal(Signal, SIG_DFL);
    return;
  }
  print(ProgramName);
  print(": error: the kernel used a null pointer; if it renders, give it a "
        "scene with --scene FILE\n");
  _exit(1);
}

void reportNullAccess(const char *Program) {
  ProgramName = Program;
  struct sigaction Action = {};
  Action.sa_sigaction = handleFault;
  Action.sa_flags = SA_SIGINFO;
  sigaction(SIGSEGV, &Action, nullptr);
}

} // namespace tp
