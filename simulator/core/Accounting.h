//===- Accounting.h - Statistics at the end of a run ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_ACCOUNTING_H
#define TP_SIMULATOR_CORE_ACCOUNTING_H

#include "simulator/core/TmRunner.h"
#include "simulator/stats/Statistics.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tp {

/// Why the thread does not issue if it waits for something else than data, or
/// no longer runs.
std::optional<Loss> lossWithoutData(const Thread &T);

/// Instructions that a thread, which may go on in \p NextCycle, has issued.
uint64_t issuedBy(const Thread &T, uint64_t NextCycle);

/// The statistics of a run of \p Cycles cycles: the sum of what the host
/// threads counted, and per thread its losses, without those beyond the end.
/// \p NextCycles are the cycles up to which the threads have been accounted
/// for, NeverCycle if their EndCycle says it; \p Opcodes is the text.
Statistics summarize(std::span<const Thread> Threads,
                     std::span<const uint64_t> NextCycles, uint64_t Cycles,
                     std::span<const TmRunnerState *const> Counters,
                     std::span<const Opcode> Opcodes);

} // namespace tp

#endif // TP_SIMULATOR_CORE_ACCOUNTING_H
