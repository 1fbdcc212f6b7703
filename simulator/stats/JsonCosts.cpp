//===- JsonCosts.cpp - Area and energy by part, as JSON -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/chip/ChipArea.h"
#include "simulator/stats/ChipEnergy.h"
#include "simulator/stats/JsonBlocks.h"
#include "simulator/stats/Ratio.h"

using namespace llvm;

namespace tp {

static void writeSource(const FigureSource &Source, json::OStream &Json) {
  Json.attribute("source", Source.Text);
  Json.attribute("assumption", Source.IsAssumption);
}

void writeArea(const RunSummary &Run, json::OStream &Json) {
  if (!Run.Chip.Technology)
    return;
  std::vector<AreaPart> Parts = chipArea(Run.Chip);
  Json.attributeObject("area_mm2", [&] {
    for (const AreaPart &Part : Parts)
      Json.attribute(Part.Name, Part.TotalMm2);
    Json.attribute("total", totalAreaMm2(Run.Chip));
  });
  Json.attributeObject("area_sources", [&] {
    for (const AreaPart &Part : Parts)
      Json.attributeObject(Part.Name, [&] { writeSource(Part.Source, Json); });
  });
}

void writeEnergy(const RunSummary &Run, json::OStream &Json) {
  if (!Run.Chip.Technology)
    return;
  double Joules = totalEnergyJ(Run.Chip, Run.Stats);
  Json.attributeObject("energy", [&] {
    Json.attribute("joules", Joules);
    Json.attribute("watts", averagePowerW(Run.Chip, Run.Stats));
    if (std::optional<RayRates> Rates = rayRates(Run))
      Json.attribute("nanojoules_per_ray", Joules * 1e9 / double(Rates->Rays));
    Json.attributeObject("parts", [&] {
      for (const EnergyPart &Part : chipEnergy(Run.Chip, Run.Stats))
        Json.attributeObject(Part.Name, [&] {
          Json.attribute("operations", Part.Operations);
          Json.attribute("joules", Part.Joules);
          Json.attribute("watts", ratio(Part.Joules, Run.seconds()));
          writeSource(Part.Source, Json);
        });
    });
  });
}

} // namespace tp
