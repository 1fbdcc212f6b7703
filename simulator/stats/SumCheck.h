//===- SumCheck.h - Whether a run's counts add up ---------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_STATS_SUMCHECK_H
#define TP_SIMULATOR_STATS_SUMCHECK_H

#include "simulator/chip/ChipConfig.h"
#include "simulator/stats/Statistics.h"

#include "llvm/ADT/ArrayRef.h"
#include "llvm/Support/Error.h"

namespace tp {

/// Checks the statistics of a run, or of a part of one, whose text consists of
/// \p Opcodes: each thread's instructions and losses add up to the cycles; the
/// counts by opcode, by instruction word and by thread agree; and so do those
/// of each level of memory. An error is a bug of the simulator.
llvm::Error checkSums(const ChipConfig &Chip, const Statistics &Stats,
                      llvm::ArrayRef<Opcode> Opcodes);

} // namespace tp

#endif // TP_SIMULATOR_STATS_SUMCHECK_H
