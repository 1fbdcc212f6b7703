//===- FunctionalReport.cpp - A run without timing ------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/stats/FunctionalReport.h"

#include "kernels/profile/RayProfileText.h"
#include "kernels/profile/RayProfiler.h"
#include "simulator/stats/JsonBlocks.h"
#include "simulator/stats/JsonReport.h"
#include "simulator/stats/RayProfileJson.h"
#include "simulator/stats/TableText.h"

#include "llvm/Support/FormatVariadic.h"
#include "llvm/Support/JSON.h"

#include <algorithm>
#include <numeric>

using namespace llvm;

namespace tp {

static uint64_t raysOf(const RunSummary &Run) {
  return std::accumulate(Run.Rays.begin(), Run.Rays.end(), uint64_t(0));
}

static void writeThreadCounts(const RunSummary &Run, json::OStream &Json) {
  Json.attributeObject("threads", [&] {
    Json.attributeArray("instructions", [&] {
      for (const ThreadStatistics &Thread : Run.Stats.Threads)
        Json.value(Thread.Instructions);
    });
    if (!Run.Rays.empty())
      Json.attributeArray("rays", [&] {
        for (uint32_t Rays : Run.Rays)
          Json.value(Rays);
      });
  });
}

void writeFunctionalJson(const RunSummary &Run, raw_ostream &OS) {
  json::OStream Json(OS, 2);
  Json.object([&] {
    Json.attribute("format_version", JsonFormatVersion);
    Json.attribute("mode", "functional");
    Json.attributeObject("run", [&] {
      Json.attribute("outcome", Run.Outcome);
      Json.attribute("exit_status", Run.ExitStatus);
      Json.attribute("instructions", Run.Stats.instructions());
    });
    Json.attributeObject("chip", [&] {
      Json.attribute("name", Run.Chip.Name);
      Json.attribute("tm_count", Run.Chip.TmCount);
      Json.attribute("tps_per_tm", Run.Chip.TpsPerTm);
    });
    if (!Run.Rays.empty())
      Json.attributeObject("rays",
                           [&] { Json.attribute("total", raysOf(Run)); });
    if (std::optional<RayProfile> Sum = sumOf(Run.RayProfiles))
      writeRayProfile(*Sum, Json);
    Json.attributeObject("instructions_by_opcode", [&] {
      for (unsigned I = 0; I != NumOpcodes; ++I)
        if (uint64_t Count = Run.Stats.Executed[I])
          Json.attributeObject(StringRef(mnemonic(Opcode(I))),
                               [&] { Json.attribute("executed", Count); });
    });
    Json.attributeObject("markers", [&] {
      for (size_t I = 0; I != Run.Stats.Markers.size(); ++I)
        if (uint64_t Passes = Run.Stats.Markers[I])
          Json.attribute(std::to_string(I), Passes);
    });
    writePcs(Run, Json);
    writeThreadCounts(Run, Json);
  });
  OS << '\n';
}

void writeFunctionalTable(const RunSummary &Run, const HostSpeed &Speed,
                          raw_ostream &OS) {
  constexpr size_t MostOpcodes = 10;
  const ChipConfig &Chip = Run.Chip;
  uint64_t Instructions = Run.Stats.instructions();
  OS << formatv("{0}: {1} TMs x {2} TPs, without timing\n", Chip.Name,
                Chip.TmCount, Chip.TpsPerTm);
  OS << formatv("run ended: {0}, status {1}\n\n", Run.Outcome, Run.ExitStatus);
  OS << formatv("{0,-16}{1,18}\n", "instructions", grouped(Instructions));
  if (!Run.Rays.empty())
    OS << formatv("{0,-16}{1,18}\n", "rays", grouped(raysOf(Run)));
  OS << '\n';
  if (std::optional<RayProfile> Sum = sumOf(Run.RayProfiles))
    OS << describe(*Sum) << '\n';
  std::vector<OpcodeCount> Counts = largestFirst(Run.Stats.Executed);
  Counts.resize(std::min(Counts.size(), MostOpcodes));
  OS << "most frequent instructions\n";
  for (const OpcodeCount &Count : Counts)
    OS << formatv("  {0,-14}{1,18} {2,7:F1} %\n", mnemonic(Count.Op),
                  grouped(Count.Count), 100.0 * Count.Count / Instructions);
  OS << formatv("\nexecuted in {0:F2} s: {1:F1} million "
                "thread-instructions/s\n",
                Speed.Seconds,
                Instructions / 1e6 / std::max(Speed.Seconds, 1e-9));
}

llvm::Error checkFunctionalSums(const ChipConfig &Chip,
                                const Statistics &Stats) {
  uint64_t ByThread = 0, ByWord = 0;
  for (const ThreadStatistics &Thread : Stats.Threads)
    ByThread += Thread.Instructions;
  for (const PcStatistics &Word : Stats.Pcs)
    ByWord += Word.Executed;
  uint64_t ByOpcode = Stats.instructions();
  if (ByOpcode != ByThread || ByOpcode != ByWord)
    return createStringError("internal error: " + Twine(ByOpcode) +
                             " instructions by opcode, " + Twine(ByThread) +
                             " by thread, " + Twine(ByWord) + " by address");
  return llvm::Error::success();
}

} // namespace tp
