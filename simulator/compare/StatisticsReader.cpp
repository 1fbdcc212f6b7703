//===- StatisticsReader.cpp - Runs from their statistics ------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/compare/RunReader.h"
#include "simulator/stats/JsonReport.h"

using namespace llvm;

namespace tp {
namespace json_entries {

/// An entry of `instructions_by_pc`.
struct PcEntry {
  SourceLine Line;
  CycleCounts Counts{};
};

/// An entry of `instructions_by_opcode`.
struct OpcodeEntry {
  int64_t Executed = 0;
};

static bool fromJSON(const json::Value &Json, PcEntry &Entry, json::Path Path) {
  json::ObjectMapper Object(Json, Path);
  const json::Object *Fields = Json.getAsObject();
  return Object && Object.map("executed", Entry.Counts[0]) &&
         Object.mapOptional("function", Entry.Line.Function) &&
         Object.mapOptional("file", Entry.Line.File) &&
         Object.mapOptional("line", Entry.Line.Line) &&
         (!Fields->get("lost") ||
          readLost(*Fields->get("lost"), Entry.Counts, Path.field("lost")));
}

static bool fromJSON(const json::Value &Json, OpcodeEntry &Entry,
                     json::Path Path) {
  json::ObjectMapper Object(Json, Path);
  return Object && Object.map("executed", Entry.Executed);
}

} // namespace json_entries

namespace {

/// A figure and the names of the objects that it is in.
struct FigurePlace {
  const char *Name;
  Figure::Kind Is;
  std::vector<const char *> Path;
};

} // namespace

static bool readRun(const json::Object &Statistics, ComparedRun &Run,
                    json::Path Path) {
  return readObject(Statistics, "run", Path, [&](json::ObjectMapper &Object) {
    return Object.map("outcome", Run.Outcome) &&
           Object.map("instructions", Run.Counts[0]) &&
           (!Run.HasCycles || Object.map("cycles", Run.Cycles));
  });
}

static bool readChip(const json::Object &Statistics, ComparedRun &Run,
                     json::Path Path) {
  return readObject(Statistics, "chip", Path, [&](json::ObjectMapper &Object) {
    return Object.map("name", Run.Chip) &&
           Object.map("tm_count", Run.TmCount) &&
           Object.map("tps_per_tm", Run.TpsPerTm);
  });
}

static bool readThreadCycles(const json::Object &Statistics, ComparedRun &Run,
                             json::Path Path) {
  if (!Run.HasCycles)
    return true;
  const json::Object *Block = Statistics.getObject("thread_cycles");
  const json::Value *Lost = Block ? Block->get("lost") : nullptr;
  json::Path Parent = Path.field("thread_cycles");
  if (!Lost) {
    Parent.field("lost").report("missing value");
    return false;
  }
  return readLost(*Lost, Run.Counts, Parent.field("lost"));
}

static bool readPcs(const json::Object &Statistics, ComparedRun &Run,
                    json::Path Path) {
  const json::Value *Block = Statistics.get("instructions_by_pc");
  if (!Block)
    return true;
  std::vector<json_entries::PcEntry> Entries;
  if (!json::fromJSON(*Block, Entries, Path.field("instructions_by_pc")))
    return false;
  Run.Lines.emplace();
  for (const json_entries::PcEntry &Entry : Entries)
    add((*Run.Lines)[Entry.Line], Entry.Counts);
  return true;
}

static bool readOpcodes(const json::Object &Statistics, ComparedRun &Run,
                        json::Path Path) {
  std::map<std::string, json_entries::OpcodeEntry> Entries;
  const json::Value *Block = Statistics.get("instructions_by_opcode");
  if (!Block) {
    Path.field("instructions_by_opcode").report("missing value");
    return false;
  }
  if (!json::fromJSON(*Block, Entries, Path.field("instructions_by_opcode")))
    return false;
  for (const auto &[Name, Entry] : Entries)
    Run.Opcodes[Name] = Entry.Executed;
  return true;
}

void readFigures(const json::Object &Statistics, ComparedRun &Run) {
  static const FigurePlace Places[] = {
      {"rays per second", Figure::Number, {"rays", "per_second"}},
      {"nodes visited", Figure::Count, {"ray_profile", "nodes_visited"}},
      {"triangles visited",
       Figure::Count,
       {"ray_profile", "triangles_visited"}},
      {"icache misses", Figure::Count, {"icache", "misses"}},
      {"L1 hit rate", Figure::Share, {"memory", "l1", "hit_rate"}},
      {"L1 misses", Figure::Count, {"memory", "l1", "misses"}},
      {"L1 bank conflicts", Figure::Count, {"memory", "l1", "bank_conflicts"}},
      {"L2 hit rate", Figure::Share, {"memory", "l2", "hit_rate"}},
      {"L2 misses", Figure::Count, {"memory", "l2", "misses"}},
      {"L2 bank conflicts", Figure::Count, {"memory", "l2", "bank_conflicts"}},
      {"DRAM bytes", Figure::Count, {"memory", "dram", "bytes"}},
      {"DRAM row hit rate", Figure::Share, {"memory", "dram", "row_hit_rate"}},
      {"DRAM read latency",
       Figure::Number,
       {"memory", "dram", "mean_read_latency_cycles"}},
      {"joules", Figure::Number, {"energy", "joules"}},
  };
  for (const FigurePlace &Place : Places) {
    const json::Object *Block = &Statistics;
    for (const char *Name : ArrayRef(Place.Path).drop_back())
      Block = Block ? Block->getObject(Name) : nullptr;
    if (!Block)
      continue;
    if (std::optional<double> Value = Block->getNumber(Place.Path.back()))
      Run.Figures.push_back({Place.Name, Place.Is, *Value});
  }
}

bool readStatistics(const json::Value &Json, ComparedRun &Run,
                    json::Path Path) {
  json::ObjectMapper Object(Json, Path);
  unsigned Version;
  std::string Mode;
  if (!Object || !Object.map("format_version", Version) ||
      !Object.map("mode", Mode))
    return false;
  if (Version != JsonFormatVersion) {
    Path.field("format_version").report("another version");
    return false;
  }
  Run.HasCycles = Mode == "cycle";
  const json::Object &Statistics = *Json.getAsObject();
  readFigures(Statistics, Run);
  return readRun(Statistics, Run, Path) && readChip(Statistics, Run, Path) &&
         readThreadCycles(Statistics, Run, Path) &&
         readPcs(Statistics, Run, Path) && readOpcodes(Statistics, Run, Path);
}

} // namespace tp
