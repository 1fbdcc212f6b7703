//===- SmallRun.h - A run whose sums are right ------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_TEST_UNIT_STATS_SMALLRUN_H
#define TP_TEST_UNIT_STATS_SMALLRUN_H

#include "simulator/stats/RunSummary.h"

namespace tp {

/// 2 TMs of 1 TP for 100 cycles at 2 GHz. Thread 0 issues 60 `add` and 10
/// `lw`, waits 20 cycles for memory and 10 for the INTADD unit. Thread 1 issues
/// 40 `add` and has finished at cycle 40. The text is the two instructions.
struct SmallRun {
  ChipConfig Chip;
  Statistics Stats;
  std::vector<Opcode> Opcodes = {Opcode::ADD, Opcode::LW};

  SmallRun() {
    Chip.Name = "small";
    Chip.TmCount = 2;
    Chip.ClockGHz = 2;
    Chip.IcacheBanks = 1;
    Chip.IcachePorts = 1;
    Chip.Units[unsigned(Unit::MEMORY)].Interval = 2;
    constexpr Opcode Add = Opcode::ADD, Load = Opcode::LW;
    Stats.Cycles = 100;
    Stats.Executed[unsigned(Add)] = 100;
    Stats.Executed[unsigned(Load)] = 10;
    Stats.DataStall[unsigned(Load)] = 20;
    Stats.UnitConflict[unsigned(Add)] = 10;
    Stats.Threads.resize(2);
    Stats.Threads[0].Instructions = 70;
    Stats.Threads[0].FinishCycle = 100;
    Stats.Threads[0].Lost[unsigned(Loss::Memory)] = 20;
    Stats.Threads[0].Lost[unsigned(Loss::UnitConflict)] = 10;
    Stats.Threads[1].Instructions = 40;
    Stats.Threads[1].FinishCycle = 40;
    Stats.Threads[1].Lost[unsigned(Loss::Finished)] = 60;
    Stats.Pcs.resize(2);
    Stats.Pcs[0].Executed = 100;
    Stats.Pcs[0].Lost[unsigned(Loss::Memory)] = 20;
    Stats.Pcs[0].Lost[unsigned(Loss::UnitConflict)] = 10;
    Stats.Pcs[1].Executed = 10;
  }

  RunSummary summary() const {
    RunSummary Run{Chip, Stats, "finished", 0, {}, std::nullopt};
    Run.TextBegin = 0x10000;
    Run.Opcodes = Opcodes;
    return Run;
  }
};

} // namespace tp

#endif // TP_TEST_UNIT_STATS_SMALLRUN_H
