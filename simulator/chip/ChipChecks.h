//===- ChipChecks.h - Whether the values of a chip fit together -*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHIP_CHIPCHECKS_H
#define TP_SIMULATOR_CHIP_CHIPCHECKS_H

#include "simulator/chip/ChipConfig.h"
#include "simulator/chip/YamlSection.h"

namespace tp {

/// Checks what no key can tell alone. \p Tree, which the chip was read from,
/// has the lines.
void checkChip(const ChipConfig &Chip, const YamlValue &Tree,
               YamlErrors &Errors);

} // namespace tp

#endif // TP_SIMULATOR_CHIP_CHIPCHECKS_H
