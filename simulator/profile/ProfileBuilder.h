//===- ProfileBuilder.h - Makes a profile of a run --------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_PROFILE_PROFILEBUILDER_H
#define TP_SIMULATOR_PROFILE_PROFILEBUILDER_H

#include "simulator/loader/ElfProgram.h"
#include "simulator/profile/Profile.h"
#include "simulator/stats/ExecutionRecord.h"
#include "simulator/stats/RunSummary.h"

namespace tp {

/// The profile of \p Run, which executed \p Program. Sources are read from the
/// files that its debug information names.
Profile makeProfile(const RunSummary &Run, const ElfProgram &Program,
                    const ExecutionRecord &Record, Utilisation Tms);

} // namespace tp

#endif // TP_SIMULATOR_PROFILE_PROFILEBUILDER_H
