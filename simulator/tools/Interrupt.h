//===- Interrupt.h - Ctrl-C -------------------------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_TOOLS_INTERRUPT_H
#define TP_SIMULATOR_TOOLS_INTERRUPT_H

#include <atomic>

namespace tp {

/// From now on the first SIGINT or SIGTERM sets the flag that comes back; a
/// second one ends the process.
const std::atomic<bool> &stopOnInterrupt();

} // namespace tp

#endif // TP_SIMULATOR_TOOLS_INTERRUPT_H
