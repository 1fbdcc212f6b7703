//===- LaunchArguments.h - A program's arguments in its memory --*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_COMMON_LAUNCHARGUMENTS_H
#define TP_KERNELS_COMMON_LAUNCHARGUMENTS_H

#include "kernels/common/LaunchSetup.h"

#include <string>
#include <vector>

namespace tp {

/// Places \p Arguments (argv, with the program's name first) in \p Memory and
/// notes them in \p Launch. Fails if there is no room.
Status placeArguments(const std::vector<std::string> &Arguments,
                      LaunchMemory &Memory, LaunchBlock &Launch);

} // namespace tp

#endif // TP_KERNELS_COMMON_LAUNCHARGUMENTS_H
