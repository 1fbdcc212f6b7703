//===- ProfileReader.cpp - A profile from JSON ----------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/profile/ProfileJson.h"
#include "simulator/profile/ProfileNames.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/Support/JSON.h"
#include "llvm/Support/MemoryBuffer.h"

using namespace llvm;

namespace tp {

namespace profile_json {

/// Counts that are an object with an attribute for each that is not 0.
struct NamedLosses {
  std::array<int64_t, NumLosses> Counts{};
};
struct NamedLevels {
  std::array<ServedAccesses, NumServedBy> Served{};
};

} // namespace profile_json

namespace {

/// The parts of a file that are no struct of their own.
struct FileContents {
  int64_t Version = 0;
  Profile Data;
};

} // namespace

template <class Array, class FindFunction>
static bool mapByName(const json::Value &From, Array &To, FindFunction Find,
                      json::Path Where) {
  const json::Object *Object = From.getAsObject();
  if (!Object) {
    Where.report("expected object");
    return false;
  }
  for (const auto &[Name, Value] : *Object) {
    auto Index = Find(StringRef(Name));
    if (!Index) {
      Where.field(Name).report("unknown name");
      return false;
    }
    if (!fromJSON(Value, To[unsigned(*Index)], Where.field(Name)))
      return false;
  }
  return true;
}

static bool fromJSON(const json::Value &From, ServedAccesses &To,
                     json::Path Where) {
  json::ObjectMapper Map(From, Where);
  return Map && Map.map("accesses", To.Accesses) &&
         Map.map("cycles", To.Cycles);
}

namespace profile_json {

static bool fromJSON(const json::Value &From, NamedLosses &To,
                     json::Path Where) {
  return mapByName(From, To.Counts, findLoss, Where);
}

static bool fromJSON(const json::Value &From, NamedLevels &To,
                     json::Path Where) {
  return mapByName(From, To.Served, findLevel, Where);
}

} // namespace profile_json

/// The attributes that \p InstructionsName and `lost` are.
static bool mapCounts(json::ObjectMapper &Map, StringLiteral InstructionsName,
                      ProfileCounts &To) {
  profile_json::NamedLosses Lost;
  if (!Map.map(InstructionsName, To.Instructions) || !Map.map("lost", Lost))
    return false;
  copy(Lost.Counts, To.Lost.begin());
  return true;
}

static bool fromJSON(const json::Value &From, ProfileRun &To,
                     json::Path Where) {
  json::ObjectMapper Map(From, Where);
  return Map && Map.map("program", To.Program) &&
         Map.map("outcome", To.Outcome) && Map.map("chip", To.Chip) &&
         Map.map("clock_ghz", To.ClockGhz) && Map.map("tm_count", To.TmCount) &&
         Map.map("tps_per_tm", To.TpsPerTm) && Map.map("cycles", To.Cycles) &&
         Map.map("finished", To.Finished);
}

static bool fromJSON(const json::Value &From, ProfileFile &To,
                     json::Path Where) {
  json::ObjectMapper Map(From, Where);
  return Map && Map.map("path", To.Path) && Map.map("text", To.Text);
}

static bool fromJSON(const json::Value &From, ProfileFunction &To,
                     json::Path Where) {
  json::ObjectMapper Map(From, Where);
  return Map && Map.map("name", To.Name) && Map.map("file", To.File) &&
         Map.mapOptional("line", To.Line);
}

static bool fromJSON(const json::Value &From, ProfileFrame &To,
                     json::Path Where) {
  json::ObjectMapper Map(From, Where);
  return Map && Map.map("function", To.Function) && Map.map("file", To.File) &&
         Map.mapOptional("line", To.Line) &&
         Map.mapOptional("column", To.Column) &&
         Map.map("inlined_into", To.InlinedInto);
}

static bool fromJSON(const json::Value &From, ProfileInstruction &To,
                     json::Path Where) {
  json::ObjectMapper Map(From, Where);
  std::string Pc;
  profile_json::NamedLevels Levels;
  if (!Map || !Map.map("pc", Pc) || !Map.map("text", To.Text) ||
      !Map.map("frame", To.Frame) || !mapCounts(Map, "executed", To.Counts) ||
      !Map.mapOptional("global", To.Memory.Global) ||
      !Map.mapOptional("served", Levels))
    return false;
  To.Memory.Served = Levels.Served;
  if (StringRef(Pc).getAsInteger(0, To.Pc)) {
    Where.field("pc").report("expected an address");
    return false;
  }
  return true;
}

static bool fromJSON(const json::Value &From, CallNode &To, json::Path Where) {
  json::ObjectMapper Map(From, Where);
  return Map && Map.map("function", To.Function) &&
         Map.map("caller", To.Caller) && Map.map("call_site", To.CallSite) &&
         Map.map("calls", To.Calls) && mapCounts(Map, "instructions", To.Self);
}

static bool fromJSON(const json::Value &From, ProfileCounts &To,
                     json::Path Where) {
  json::ObjectMapper Map(From, Where);
  return Map && mapCounts(Map, "instructions", To);
}

static bool fromJSON(const json::Value &From, Utilisation &To,
                     json::Path Where) {
  json::ObjectMapper Map(From, Where);
  return Map && Map.map("ends", To.Ends) && Map.map("chip", To.Chip) &&
         Map.map("issued", To.Issued) && Map.map("memory", To.Memory) &&
         Map.map("finished", To.Finished);
}

static bool fromJSON(const json::Value &From, FileContents &To,
                     json::Path Where) {
  json::ObjectMapper Map(From, Where);
  if (!Map || !Map.map("format_version", To.Version))
    return false;
  if (To.Version != ProfileFormatVersion) {
    Where.field("format_version").report("another version of the format");
    return false;
  }
  Profile &Data = To.Data;
  if (const json::Value *Statistics = From.getAsObject()->get("statistics")) {
    if (!Statistics->getAsObject()) {
      Where.field("statistics").report("expected object");
      return false;
    }
    Data.Statistics = formatv("{0}", *Statistics).str();
  }
  return Map.map("run", Data.Run) && Map.map("files", Data.Files) &&
         Map.map("functions", Data.Functions) &&
         Map.map("frames", Data.Frames) &&
         Map.map("instructions", Data.Instructions) &&
         Map.map("call_tree", Data.Calls) &&
         Map.mapOptional("call_tree_is_cut", Data.IsCallTreeCut) &&
         Map.map("utilisation", Data.Tms);
}

/// What refers to an entry that is not there; empty if there is nothing.
static std::string badReference(const Profile &Data) {
  auto IsBad = [](std::optional<uint32_t> Index, size_t Count) {
    return Index && *Index >= Count;
  };
  for (auto [I, Function] : enumerate(Data.Functions))
    if (IsBad(Function.File, Data.Files.size()))
      return formatv("functions[{0}]", I);
  for (auto [I, Frame] : enumerate(Data.Frames))
    if (IsBad(Frame.File, Data.Files.size()) ||
        IsBad(Frame.Function, Data.Functions.size()) ||
        IsBad(Frame.InlinedInto, I))
      return formatv("frames[{0}]", I);
  for (auto [I, Instruction] : enumerate(Data.Instructions))
    if (IsBad(Instruction.Frame, Data.Frames.size()))
      return formatv("instructions[{0}]", I);
  for (auto [I, Call] : enumerate(Data.Calls))
    if (IsBad(Call.Function, Data.Functions.size()) || IsBad(Call.Caller, I) ||
        IsBad(Call.CallSite, Data.Instructions.size()))
      return formatv("call_tree[{0}]", I);
  size_t Intervals = Data.Tms.Ends.size();
  if (Data.Tms.Chip.size() != Intervals)
    return "utilisation.chip";
  for (const auto *Tms :
       {&Data.Tms.Issued, &Data.Tms.Memory, &Data.Tms.Finished})
    if (Tms->size() != Data.Run.TmCount ||
        any_of(*Tms, [&](const auto &Tm) { return Tm.size() != Intervals; }))
      return "utilisation";
  return "";
}

Expected<Profile> parseProfile(StringRef Text, StringRef Name) {
  Expected<json::Value> Value = json::parse(Text);
  if (!Value)
    return createStringError(Name +
                             ": not JSON: " + toString(Value.takeError()) +
                             "; give a file that --profile wrote");
  json::Path::Root Root("profile");
  FileContents Contents;
  if (!fromJSON(*Value, Contents, Root))
    return createStringError(Name + ": " + toString(Root.getError()) +
                             "; give a file that --profile of this tpsim "
                             "wrote");
  if (std::string Bad = badReference(Contents.Data); !Bad.empty())
    return createStringError(Name + ": " + Bad +
                             " refers to what is not there; the file is "
                             "damaged, write it again with --profile");
  return std::move(Contents.Data);
}

Expected<Profile> readProfile(const std::string &Path) {
  ErrorOr<std::unique_ptr<MemoryBuffer>> Buffer = MemoryBuffer::getFile(Path);
  if (!Buffer)
    return createStringError("cannot read " + Path + ": " +
                             Buffer.getError().message());
  return parseProfile((*Buffer)->getBuffer(), Path);
}

} // namespace tp
