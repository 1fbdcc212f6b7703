//===- ChipArea.cpp - Area of a chip by part ------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/chip/ChipArea.h"

namespace tp {

std::vector<AreaPart> chipArea(const ChipConfig &Chip) {
  std::vector<AreaPart> Parts;
  auto Add = [&Parts](std::string Name, uint64_t Count, double Mm2Each) {
    Parts.push_back({std::move(Name), Count, double(Count) * Mm2Each});
  };
  for (unsigned I = 0; I != NumUnits; ++I)
    Add(std::string(unitName(Unit(I))),
        uint64_t(Chip.TmCount) * Chip.Units[I].Count, Chip.Units[I].AreaMm2);
  Add("register_file", Chip.threadCount(), Chip.RegisterFileAreaMm2);
  Add("local_store", Chip.threadCount(), Chip.LocalStoreAreaMm2);
  Add("icache", Chip.TmCount, Chip.IcacheAreaMm2);
  return Parts;
}

double totalAreaMm2(const ChipConfig &Chip) {
  double Total = 0;
  for (const AreaPart &Part : chipArea(Chip))
    Total += Part.TotalMm2;
  return Total;
}

} // namespace tp
