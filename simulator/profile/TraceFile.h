//===- TraceFile.h - Traces of threads for Perfetto -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_PROFILE_TRACEFILE_H
#define TP_SIMULATOR_PROFILE_TRACEFILE_H

#include "simulator/loader/ElfProgram.h"
#include "simulator/profile/ThreadTrace.h"

#include "llvm/ADT/ArrayRef.h"
#include "llvm/Support/raw_ostream.h"

namespace tp {

/// Writes traces for https://ui.perfetto.dev and chrome://tracing, in which a
/// microsecond is a cycle: a process for each TM; of each thread a track with
/// its issues and stalls and, below, its accesses to global memory that are
/// under way.
void writeThreadTraces(llvm::ArrayRef<ThreadTrace> Traces,
                       const ChipConfig &Chip, const ElfProgram &Program,
                       llvm::raw_ostream &OS);

} // namespace tp

#endif // TP_SIMULATOR_PROFILE_TRACEFILE_H
