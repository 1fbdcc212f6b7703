//===- TableReport.cpp - A run's statistics for people --------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/stats/TableReport.h"

#include "kernels/profile/RayProfileText.h"
#include "kernels/profile/RayProfiler.h"
#include "simulator/chip/ChipArea.h"
#include "simulator/stats/ChipEnergy.h"
#include "simulator/stats/TableBlocks.h"
#include "simulator/stats/TableText.h"

#include "llvm/Support/Format.h"

using namespace llvm;

namespace tp {

/// The text if the chip says what its parts cost.
static std::string ifCosted(const RunSummary &Run, const Twine &Text) {
  return Run.Chip.Technology ? Text.str() : "";
}

static void writeHead(const RunSummary &Run, raw_ostream &OS) {
  const ChipConfig &Chip = Run.Chip;
  double Joules = totalEnergyJ(Chip, Run.Stats);
  OS << formatv("{0}: {1} TMs x {2} TPs at {3} GHz{4}\n", Chip.Name,
                Chip.TmCount, Chip.TpsPerTm, format("%g", Chip.ClockGHz),
                ifCosted(Run, formatv(", {0:F1} mm2", totalAreaMm2(Chip))));
  OS << formatv("run ended: {0}, status {1}\n\n", Run.Outcome, Run.ExitStatus);
  OS << formatv("{0,-16}{1,18}   {2:F3} ms at the chip's clock{3}\n", "cycles",
                grouped(Run.Stats.Cycles), Run.seconds() * 1e3,
                ifCosted(Run, formatv(", {0:F2} mJ", Joules * 1e3)));
  OS << formatv("{0,-16}{1,18}   {2:F2} per cycle and TM\n", "instructions",
                grouped(Run.Stats.instructions()),
                Run.instructionsPerCycleAndTm());
  if (std::optional<RayRates> Rates = rayRates(Run)) {
    OS << formatv("{0,-16}{1,18}   {2:F2} Mrays/s{3}\n", "rays",
                  grouped(Rates->Rays), Rates->Chip / 1e6,
                  ifCosted(Run, formatv(", {0:F2} nJ per ray",
                                        Joules * 1e9 / double(Rates->Rays))));
    const auto &Thread = Rates->PerThread;
    OS << format("  of a thread   %.3g to %.3g Mrays/s, mean %.3g, median "
                 "%.3g\n",
                 Thread.Minimum / 1e6, Thread.Maximum / 1e6, Thread.Mean / 1e6,
                 Thread.Median / 1e6);
  }
  OS << '\n';
}

void writeTable(const RunSummary &Run, const HostSpeed &Speed,
                raw_ostream &OS) {
  writeHead(Run, OS);
  if (std::optional<RayProfile> Sum = sumOf(Run.RayProfiles))
    OS << describe(*Sum) << '\n';
  writeLosses(Run, OS);
  writeParts(Run, OS);
  double Million = Speed.Instructions.value_or(Run.Stats.instructions()) / 1e6;
  OS << formatv("simulated in {0:F2} s on {1} host thread{2}: {3:F1} million "
                "thread-instructions/s\n",
                Speed.Seconds, Speed.Threads, Speed.Threads == 1 ? "" : "s",
                Million / std::max(Speed.Seconds, 1e-9));
}

} // namespace tp
