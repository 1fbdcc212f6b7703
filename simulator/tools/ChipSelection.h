//===- ChipSelection.h - The chip of a command line -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_TOOLS_CHIPSELECTION_H
#define TP_SIMULATOR_TOOLS_CHIPSELECTION_H

#include "simulator/chip/ChipConfig.h"
#include "simulator/tools/Options.h"

#include "llvm/ADT/StringRef.h"
#include "llvm/Support/Error.h"

#include <string>

namespace tp {

/// The folder of the chips that go by name: `<bin>/../share/tp/chips` of the
/// running program.
std::string chipFolder(const char *Argv0);

/// The chip that \p Request names, with its settings.
llvm::Expected<ChipConfig> selectChip(const Options &Request,
                                      llvm::StringRef ChipFolder);

} // namespace tp

#endif // TP_SIMULATOR_TOOLS_CHIPSELECTION_H
