//===- IntervalFigures.cpp - What is told of an interval ------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/stats/IntervalFigures.h"

#include "simulator/stats/MemoryCounts.h"
#include "simulator/stats/MemorySummary.h"
#include "simulator/stats/Ratio.h"
#include "simulator/stats/RunSummary.h"

namespace tp {
namespace {

class FigureCollector {
public:
  FigureCollector(const ChipConfig &Chip, const Statistics &Counts)
      : Chip(Chip), Counts(Counts) {}

  std::vector<IntervalFigure> collect() {
    collectCycles();
    if (Counts.Memory)
      collectMemory(summarizeMemory(Chip, Counts.Cycles, *Counts.Memory));
    return std::move(Figures);
  }

private:
  const ChipConfig &Chip;
  const Statistics &Counts;
  std::vector<IntervalFigure> Figures;

  void count(std::string Column, uint64_t Value) {
    Figures.push_back({std::move(Column), double(Value), true});
  }

  void curve(std::string Column, double Value, std::string Track,
             std::string Curve, double Scale = 1) {
    Figures.push_back({std::move(Column), Value, false, std::move(Track),
                       std::move(Curve), Scale});
  }

  void collectCycles() {
    double Percent =
        ratio(100, double(Counts.Cycles) * double(Chip.threadCount()));
    auto ThreadCycles = [&](std::string Column, const char *Name,
                            uint64_t Value) {
      Figures.push_back({std::move(Column), double(int64_t(Value)), true,
                         "thread-cycles (%)", Name, Percent});
    };
    ThreadCycles("instructions", "issued", Counts.instructions());
    for (unsigned I = 0; I != NumLosses; ++I)
      ThreadCycles(std::string("lost_") + lossName(Loss(I)), lossName(Loss(I)),
                   Counts.lost(Loss(I)));
    curve("instructions_per_cycle",
          ratio(double(Counts.instructions()), double(Counts.Cycles)),
          "instructions per cycle", "chip");
    count("icache_misses", Counts.Icache.Misses);
    count("global_accesses", Counts.GlobalAccesses);
  }

  template <class Level, size_t Number>
  void collectCounts(const std::string &Prefix, const Level &Values,
                     const MemoryCount<Level> (&Members)[Number]) {
    for (const MemoryCount<Level> &Member : Members)
      if (Member.Kind == CountKind::Sum)
        count(Prefix + Member.Name, Values.*Member.Member);
  }

  void collectTraffic(const std::string &Column, const char *Level,
                      const char *Curve, const Bandwidth &Traffic) {
    curve(Column, Traffic.BytesPerCycle, std::string(Level) + " (GB/s)", Curve,
          Chip.ClockGHz);
  }

  void collectCache(const char *Level, const std::string &Prefix,
                    const CacheSummary &Cache) {
    collectCounts(Prefix, Cache.Counts, CacheCounts);
    curve(Prefix + "hit_rate", Cache.HitRate, std::string(Level) + " hits (%)",
          "hits", 100);
    curve(Prefix + "bank_utilisation", Cache.BankUtilisation,
          std::string(Level) + " banks used (%)", "used", 100);
    collectTraffic(Prefix + "read_bytes_per_cycle", Level, "read", Cache.Read);
    collectTraffic(Prefix + "written_bytes_per_cycle", Level, "written",
                   Cache.Written);
  }

  void collectCrossbar(const CrossbarSummary &Crossbar) {
    collectCounts("crossbar_", Crossbar.Counts, CrossbarCounts);
    collectTraffic("crossbar_request_bytes_per_cycle", "crossbar", "requests",
                   Crossbar.Requests);
    collectTraffic("crossbar_answer_bytes_per_cycle", "crossbar", "answers",
                   Crossbar.Answers);
  }

  void collectDram(const DramSummary &Dram) {
    collectCounts("dram_", Dram.Counts, DramCounts);
    collectTraffic("dram_read_bytes_per_cycle", "DRAM", "read", Dram.Read);
    collectTraffic("dram_written_bytes_per_cycle", "DRAM", "written",
                   Dram.Written);
    curve("dram_share_of_peak", Dram.Data.ShareOfPeak, "DRAM peak (%)", "used",
          100);
    curve("dram_row_hit_rate", Dram.RowHitRate, "DRAM row hits (%)", "hits",
          100);
    curve("dram_mean_read_queue", Dram.MeanReadQueue, "DRAM queue", "reads");
    curve("dram_mean_write_queue", Dram.MeanWriteQueue, "DRAM queue", "writes");
    curve("dram_mean_read_latency_cycles", Dram.MeanReadLatency,
          "DRAM read latency (cycles)", "mean");
  }

  void collectMemory(const MemorySummary &Memory) {
    if (Memory.L1)
      collectCache("L1", "l1_", *Memory.L1);
    if (Memory.Crossbar)
      collectCrossbar(*Memory.Crossbar);
    if (Memory.L2)
      collectCache("L2", "l2_", *Memory.L2);
    if (Memory.Dram)
      collectDram(*Memory.Dram);
  }
};

} // namespace

std::vector<IntervalFigure> intervalFigures(const ChipConfig &Chip,
                                            const Statistics &Counts) {
  return FigureCollector(Chip, Counts).collect();
}

} // namespace tp
