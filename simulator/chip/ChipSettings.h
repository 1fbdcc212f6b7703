//===- ChipSettings.h - A chip with some other values -----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHIP_CHIPSETTINGS_H
#define TP_SIMULATOR_CHIP_CHIPSETTINGS_H

#include "simulator/chip/ChipConfig.h"

#include "llvm/ADT/ArrayRef.h"
#include "llvm/Support/Error.h"

#include <string>

namespace tp {

/// \p Base with other values: each of \p Settings is `<path>=<value>`, the path
/// of a chip file's key such as `memory.latency_cycles`, and the value as the
/// file would have it; `none` takes an optional key or section out. Of two with
/// one path the later counts. Files that a value names are looked for below
/// \p Folders. Errors name the setting and what would be right.
llvm::Expected<ChipConfig> withSettings(const ChipConfig &Base,
                                        llvm::ArrayRef<std::string> Settings,
                                        llvm::ArrayRef<std::string> Folders);

} // namespace tp

#endif // TP_SIMULATOR_CHIP_CHIPSETTINGS_H
