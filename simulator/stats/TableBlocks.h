//===- TableBlocks.h - The blocks of the table for people -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_STATS_TABLEBLOCKS_H
#define TP_SIMULATOR_STATS_TABLEBLOCKS_H

#include "simulator/stats/RunSummary.h"

#include "llvm/Support/raw_ostream.h"

namespace tp {

/// Where the thread-cycles went, as shares of all of them.
void writeLosses(const RunSummary &Run, llvm::raw_ostream &OS);

/// The chip's parts: how many, what they did, how busy they were, what they
/// cost.
void writeParts(const RunSummary &Run, llvm::raw_ostream &OS);

} // namespace tp

#endif // TP_SIMULATOR_STATS_TABLEBLOCKS_H
