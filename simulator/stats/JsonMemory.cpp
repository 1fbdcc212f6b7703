//===- JsonMemory.cpp - What the memory system did, as JSON ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/stats/JsonBlocks.h"
#include "simulator/stats/MemoryCounts.h"
#include "simulator/stats/MemorySummary.h"

using namespace llvm;

namespace tp {

template <class Counts, size_t Number>
static void writeCounts(const Counts &Values,
                        const MemoryCount<Counts> (&Members)[Number],
                        json::OStream &Json) {
  for (const MemoryCount<Counts> &Count : Members)
    Json.attribute(Count.Name, int64_t(Values.*Count.Member));
}

static void writeRates(const Bandwidth &Traffic, json::OStream &Json) {
  Json.attribute("bytes_per_cycle", Traffic.BytesPerCycle);
  Json.attribute("gb_per_second", Traffic.GBPerSecond);
}

static void writeBandwidth(StringRef Name, const Bandwidth &Traffic,
                           json::OStream &Json) {
  Json.attributeObject(Name, [&] { writeRates(Traffic, Json); });
}

static void writeBandwidth(StringRef Name, const LimitedBandwidth &Traffic,
                           json::OStream &Json) {
  Json.attributeObject(Name, [&] {
    writeRates(Traffic, Json);
    Json.attribute("peak_gb_per_second", Traffic.PeakGBPerSecond);
    Json.attribute("share_of_peak", Traffic.ShareOfPeak);
  });
}

static void writeCache(StringRef Name, const CacheSummary &Cache,
                       json::OStream &Json) {
  Json.attributeObject(Name, [&] {
    Json.attribute("caches", Cache.Caches);
    writeCounts(Cache.Counts, CacheCounts, Json);
    Json.attribute("hit_rate", Cache.HitRate);
    Json.attribute("merged_rate", Cache.MergedRate);
    Json.attribute("bank_utilisation", Cache.BankUtilisation);
    writeBandwidth("read", Cache.Read, Json);
    writeBandwidth("written", Cache.Written, Json);
  });
}

static void writeCrossbar(const CrossbarSummary &Crossbar,
                          json::OStream &Json) {
  Json.attributeObject("crossbar", [&] {
    writeCounts(Crossbar.Counts, CrossbarCounts, Json);
    writeBandwidth("request_bandwidth", Crossbar.Requests, Json);
    writeBandwidth("answer_bandwidth", Crossbar.Answers, Json);
  });
}

static void writeDram(const DramSummary &Dram, json::OStream &Json) {
  writeCounts(Dram.Counts, DramCounts, Json);
  Json.attribute("bytes", Dram.Data.Bytes);
  Json.attribute("row_hit_rate", Dram.RowHitRate);
  writeBandwidth("bandwidth", Dram.Data, Json);
  writeBandwidth("read", Dram.Read, Json);
  writeBandwidth("written", Dram.Written, Json);
  Json.attribute("mean_read_queue", Dram.MeanReadQueue);
  Json.attribute("mean_write_queue", Dram.MeanWriteQueue);
  Json.attribute("mean_read_latency_cycles", Dram.MeanReadLatency);
  writeFlatArray("read_latency_histogram", Dram.Counts.ReadLatency, Json);
}

void writeMemory(const RunSummary &Run, json::OStream &Json) {
  if (!Run.Stats.Memory)
    return;
  MemorySummary Memory =
      summarizeMemory(Run.Chip, Run.Stats.Cycles, *Run.Stats.Memory);
  Json.attributeObject("memory", [&] {
    writeCounts(*Run.Stats.Memory, FlowCounts, Json);
    if (Memory.L1)
      writeCache("l1", *Memory.L1, Json);
    if (Memory.Crossbar)
      writeCrossbar(*Memory.Crossbar, Json);
    if (Memory.L2)
      writeCache("l2", *Memory.L2, Json);
    if (Memory.Dram)
      Json.attributeObject("dram", [&] {
        writeDram(*Memory.Dram, Json);
        Json.attributeArray("channels", [&] {
          for (const DramSummary &Channel : Memory.DramChannels)
            Json.object([&] { writeDram(Channel, Json); });
        });
      });
  });
}

} // namespace tp
