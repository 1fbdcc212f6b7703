//===- ChipEnergy.h - Energy of a run by part -------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_STATS_CHIPENERGY_H
#define TP_SIMULATOR_STATS_CHIPENERGY_H

#include "simulator/chip/ChipConfig.h"
#include "simulator/stats/Statistics.h"

#include <string>
#include <vector>

namespace tp {

/// Energy of one kind of part over the whole chip and run.
struct EnergyPart {
  std::string Name;
  /// What was done: operations of a unit, accesses to a memory, bytes through
  /// the crossbar, commands to DRAM.
  uint64_t Operations = 0;
  double Joules = 0;
  FigureSource Source;
};

/// The functional units in the order of Unit, then `register_file`,
/// `local_store` and `icache`, then of those that the chip has `l1`, `l2`,
/// `crossbar` and `dram`. All but `dram` are 0 if the chip names no technology.
///
/// Each register operand of an instruction is an access to the register file,
/// each instruction a fetch. A cache is accessed by each request that it
/// serves, by each fill and each line written back.
std::vector<EnergyPart> chipEnergy(const ChipConfig &Chip,
                                   const Statistics &Stats);

/// Sum of chipEnergy() in joules.
double totalEnergyJ(const ChipConfig &Chip, const Statistics &Stats);

/// Mean power in watts; 0 for no time.
double averagePowerW(const ChipConfig &Chip, const Statistics &Stats);

} // namespace tp

#endif // TP_SIMULATOR_STATS_CHIPENERGY_H
