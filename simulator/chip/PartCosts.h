//===- PartCosts.h - What the parts of a chip cost --------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHIP_PARTCOSTS_H
#define TP_SIMULATOR_CHIP_PARTCOSTS_H

#include "simulator/chip/ChipConfig.h"

namespace tp {

// Costs of one part in the size that the chip has it. Without a technology
// they are 0. A figure that was scaled to another size than its source's is an
// assumption.

/// A functional unit; the energy is that of an operation.
PartCost unitCost(const ChipConfig &Chip, Unit Type);
/// The registers of a TP; the energy is that of an access to one.
PartCost registerFileCost(const ChipConfig &Chip);
/// The local store of a TP; the energy is that of an access.
PartCost localStoreCost(const ChipConfig &Chip);
/// The instruction cache of a TM; the energy is that of a fetch.
PartCost icacheCost(const ChipConfig &Chip);
/// An L1 or L2; the energy is that of an access.
PartCost cacheCost(const ChipConfig &Chip, const CacheConfig &Cache);
/// The crossbar's port of a TM; the energy is that of a byte.
PartCost crossbarCost(const ChipConfig &Chip);

} // namespace tp

#endif // TP_SIMULATOR_CHIP_PARTCOSTS_H
