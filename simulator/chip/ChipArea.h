//===- ChipArea.h - Area of a chip by part ----------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHIP_CHIPAREA_H
#define TP_SIMULATOR_CHIP_CHIPAREA_H

#include "simulator/chip/ChipConfig.h"

#include <string>
#include <vector>

namespace tp {

/// Silicon of one kind of part over the whole chip.
struct AreaPart {
  std::string Name;
  uint64_t Count = 0;
  double TotalMm2 = 0;
  FigureSource Source;
};

/// Every part: the functional units in the order of Unit, then `register_file`,
/// `local_store`, `icache`, and of those that the chip has `l1`, `l2` and
/// `crossbar`. All are 0 if the chip names no technology. Wires, the memory's
/// controllers and what else the table does not know are not in it.
std::vector<AreaPart> chipArea(const ChipConfig &Chip);

/// Sum of chipArea() in mm2.
double totalAreaMm2(const ChipConfig &Chip);

/// Caches of the L2 level; 0 if the chip has none.
uint32_t l2Count(const ChipConfig &Chip);

} // namespace tp

#endif // TP_SIMULATOR_CHIP_CHIPAREA_H
