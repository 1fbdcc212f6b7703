//===- ChipArea.cpp - Area of a chip by part ------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/chip/ChipArea.h"

#include "simulator/chip/PartCosts.h"

namespace tp {

uint32_t l2Count(const ChipConfig &Chip) {
  return Chip.L2 ? (Chip.TmCount + Chip.TmsPerL2 - 1) / Chip.TmsPerL2 : 0;
}

std::vector<AreaPart> chipArea(const ChipConfig &Chip) {
  std::vector<AreaPart> Parts;
  auto Add = [&Parts](std::string Name, uint64_t Count, const PartCost &Each) {
    Parts.push_back(
        {std::move(Name), Count, double(Count) * Each.AreaMm2, Each.Source});
  };
  for (unsigned I = 0; I != NumUnits; ++I)
    Add(std::string(unitName(Unit(I))),
        uint64_t(Chip.TmCount) * Chip.Units[I].Count, unitCost(Chip, Unit(I)));
  Add("register_file", Chip.threadCount(), registerFileCost(Chip));
  Add("local_store", Chip.threadCount(), localStoreCost(Chip));
  Add("icache", Chip.TmCount, icacheCost(Chip));
  if (Chip.L1)
    Add("l1", Chip.TmCount, cacheCost(Chip, *Chip.L1));
  if (Chip.L2)
    Add("l2", l2Count(Chip), cacheCost(Chip, *Chip.L2));
  if (Chip.Crossbar)
    Add("crossbar", Chip.TmCount, crossbarCost(Chip));
  return Parts;
}

double totalAreaMm2(const ChipConfig &Chip) {
  double Total = 0;
  for (const AreaPart &Part : chipArea(Chip))
    Total += Part.TotalMm2;
  return Total;
}

} // namespace tp
