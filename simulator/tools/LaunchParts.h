//===- LaunchParts.h - What a program finds at its start --------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_TOOLS_LAUNCHPARTS_H
#define TP_SIMULATOR_TOOLS_LAUNCHPARTS_H

#include "simulator/check/MemoryNames.h"
#include "simulator/tools/RunSetup.h"

#include <vector>

namespace tp {

/// The arguments, and with a scene its arrays, the framebuffer and the
/// counters, by address.
std::vector<LaunchPart> launchParts(const RunSetup &Loaded);

} // namespace tp

#endif // TP_SIMULATOR_TOOLS_LAUNCHPARTS_H
