//===- JsonReport.cpp - A run's statistics for programs -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/stats/JsonReport.h"

#include "kernels/profile/RayProfiler.h"
#include "simulator/stats/JsonBlocks.h"
#include "simulator/stats/RayProfileJson.h"

#include "llvm/Support/JSON.h"

using namespace llvm;

namespace tp {
namespace {

class JsonWriter {
public:
  JsonWriter(const RunSummary &Run, raw_ostream &OS)
      : Run(Run), Stats(Run.Stats), Chip(Run.Chip), Json(OS, 2) {}

  void write() {
    Json.object([&] {
      Json.attribute("format_version", JsonFormatVersion);
      Json.attribute("mode", "cycle");
      writeRun();
      writeChip();
      writeImage();
      writeRays();
      if (std::optional<RayProfile> Sum = sumOf(Run.RayProfiles))
        writeRayProfile(*Sum, Json);
      writeThreadCycles();
      writeOpcodes();
      writeUnits();
      writeMarkers();
      writeMemory(Run, Json);
      writeEnergy(Run, Json);
      writePcs(Run, Json);
      writeThreads(Run, Json);
    });
  }

private:
  const RunSummary &Run;
  const Statistics &Stats;
  const ChipConfig &Chip;
  json::OStream Json;

  void writeRun() {
    Json.attributeObject("run", [&] {
      Json.attribute("outcome", Run.Outcome);
      Json.attribute("exit_status", Run.ExitStatus);
      Json.attribute("cycles", Stats.Cycles);
      Json.attribute("seconds_at_chip_clock", Run.seconds());
      Json.attribute("instructions", Stats.instructions());
      Json.attribute("issue_rate", Run.issueRate());
      Json.attribute("instructions_per_cycle_and_tm",
                     Run.instructionsPerCycleAndTm());
    });
  }

  void writeChip() {
    Json.attributeObject("chip", [&] {
      Json.attribute("name", Chip.Name);
      Json.attribute("clock_ghz", Chip.ClockGHz);
      Json.attribute("tm_count", Chip.TmCount);
      Json.attribute("tps_per_tm", Chip.TpsPerTm);
      Json.attribute("arbitration_window_cycles", Chip.ArbitrationWindow);
      Json.attribute("local_store_bytes", Chip.LocalStoreBytes);
      Json.attribute("memory_bytes", Chip.MemoryBytes);
      Json.attribute("memory_latency_cycles", Chip.MemoryLatency);
      Json.attribute("icache_banks", Chip.IcacheBanks);
      Json.attribute("icache_ports_per_bank", Chip.IcachePorts);
      writeArea(Run, Json);
    });
  }

  void writeImage() {
    if (!Run.Image)
      return;
    Json.attributeObject("image", [&] {
      Json.attribute("width", Run.Image->Width);
      Json.attribute("height", Run.Image->Height);
      Json.attribute("samples_per_pixel", Run.Image->SamplesPerPixel);
      Json.attribute("max_depth", Run.Image->MaxDepth);
      Json.attribute("seed", Run.Image->Seed);
    });
  }

  void writeRays() {
    std::optional<RayRates> Rates = rayRates(Run);
    if (!Rates)
      return;
    Json.attributeObject("rays", [&] {
      Json.attribute("total", Rates->Rays);
      Json.attribute("per_second", Rates->Chip);
      Json.attribute("slowest_thread_per_second", Rates->SlowestThread);
      Json.attribute("fastest_thread_per_second", Rates->FastestThread);
      Json.attributeObject("per_thread", [&] {
        Json.attribute("minimum", Rates->PerThread.Minimum);
        Json.attribute("mean", Rates->PerThread.Mean);
        Json.attribute("median", Rates->PerThread.Median);
        Json.attribute("maximum", Rates->PerThread.Maximum);
      });
      Json.attribute("threads_without_rays", Rates->ThreadsWithoutRays);
    });
  }

  void writeThreadCycles() {
    Json.attributeObject("thread_cycles", [&] {
      Json.attribute("total", Run.threadCycles());
      Json.attribute("issued", Stats.instructions());
      Json.attributeObject("lost", [&] {
        for (unsigned I = 0; I != NumLosses; ++I)
          Json.attribute(lossName(Loss(I)), int64_t(Stats.lost(Loss(I))));
      });
    });
  }

  void writeOpcodes() {
    Json.attributeObject("instructions_by_opcode", [&] {
      for (unsigned I = 0; I != NumOpcodes; ++I)
        if (Stats.Executed[I] || Stats.DataStall[I] || Stats.UnitConflict[I])
          Json.attributeObject(StringRef(mnemonic(Opcode(I))), [&] {
            Json.attribute("executed", Stats.Executed[I]);
            Json.attribute("data_stall_cycles", Stats.DataStall[I]);
            Json.attribute("unit_conflict_cycles", Stats.UnitConflict[I]);
          });
    });
  }

  void writeUnits() {
    Json.attributeObject("units", [&] {
      for (unsigned I = 0; I != NumUnits; ++I)
        Json.attributeObject(StringRef(unitName(Unit(I))), [&] {
          Json.attribute("count_per_tm", Chip.Units[I].Count);
          Json.attribute("interval_cycles", Chip.Units[I].Interval);
          Json.attribute("operations", Run.operations(Unit(I)));
          Json.attribute("utilisation", Run.utilisation(Unit(I)));
        });
    });
    Json.attributeObject("icache", [&] {
      Json.attribute("fetches", Stats.instructions());
      Json.attribute("conflict_cycles", Stats.lost(Loss::IcacheConflict));
      Json.attribute("utilisation", Run.icacheUtilisation());
      Json.attribute("lookups", Stats.Icache.Lookups);
      Json.attribute("misses", Stats.Icache.Misses);
      Json.attribute("merged", Stats.Icache.Merged);
      Json.attribute("miss_cycles", Stats.lost(Loss::IcacheMiss));
    });
  }

  void writeMarkers() {
    Json.attributeObject("markers", [&] {
      for (size_t I = 0; I != Stats.Markers.size(); ++I)
        if (Stats.Markers[I] != 0)
          Json.attribute(std::to_string(I), Stats.Markers[I]);
    });
  }
};

} // namespace

void writeJson(const RunSummary &Run, raw_ostream &OS) {
  JsonWriter(Run, OS).write();
  OS << '\n';
}

} // namespace tp
