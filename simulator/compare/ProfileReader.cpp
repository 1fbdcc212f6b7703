//===- ProfileReader.cpp - Runs from their profiles -----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/compare/RunReader.h"

#include "llvm/ADT/StringExtras.h"

using namespace llvm;

namespace tp {
namespace {

/// Entries of the arrays that a profile consists of, as far as they are needed.
struct FileEntry {
  std::string Path;
};

struct FunctionEntry {
  std::string Name;
};

struct FrameEntry {
  size_t Function = 0;
  std::optional<size_t> File;
  uint32_t Line = 0;
};

struct ServedEntry {
  int64_t Accesses = 0;
  int64_t Cycles = 0;
};

struct InstructionEntry {
  std::string Text;
  size_t Frame = 0;
  CycleCounts Counts{};
  std::map<std::string, ServedEntry> Served;
};

bool fromJSON(const json::Value &Json, FileEntry &File, json::Path Path) {
  json::ObjectMapper Object(Json, Path);
  return Object && Object.map("path", File.Path);
}

bool fromJSON(const json::Value &Json, FunctionEntry &Function,
              json::Path Path) {
  json::ObjectMapper Object(Json, Path);
  return Object && Object.map("name", Function.Name);
}

bool fromJSON(const json::Value &Json, FrameEntry &Frame, json::Path Path) {
  json::ObjectMapper Object(Json, Path);
  return Object && Object.map("function", Frame.Function) &&
         Object.map("file", Frame.File) &&
         Object.mapOptional("line", Frame.Line);
}

bool fromJSON(const json::Value &Json, ServedEntry &Served, json::Path Path) {
  json::ObjectMapper Object(Json, Path);
  return Object && Object.map("accesses", Served.Accesses) &&
         Object.map("cycles", Served.Cycles);
}

bool fromJSON(const json::Value &Json, InstructionEntry &Instruction,
              json::Path Path) {
  json::ObjectMapper Object(Json, Path);
  if (!Object || !Object.map("text", Instruction.Text) ||
      !Object.map("frame", Instruction.Frame) ||
      !Object.map("executed", Instruction.Counts[0]) ||
      !Object.mapOptional("served", Instruction.Served))
    return false;
  const json::Value *Lost = Json.getAsObject()->get("lost");
  return !Lost || readLost(*Lost, Instruction.Counts, Path.field("lost"));
}

/// The arrays.
struct ProfileEntries {
  std::vector<FileEntry> Files;
  std::vector<FunctionEntry> Functions;
  std::vector<FrameEntry> Frames;
  std::vector<InstructionEntry> Instructions;
};

} // namespace

/// Whether all numbers of entries are those of entries.
static bool checkIndices(const ProfileEntries &Entries, json::Path Path) {
  for (const FrameEntry &Frame : Entries.Frames)
    if (Frame.Function >= Entries.Functions.size() ||
        Frame.File.value_or(0) > Entries.Files.size() ||
        (Frame.File && *Frame.File == Entries.Files.size())) {
      Path.field("frames").report("a function or file that is not there");
      return false;
    }
  for (const InstructionEntry &Instruction : Entries.Instructions)
    if (Instruction.Frame >= Entries.Frames.size()) {
      Path.field("instructions").report("a frame that is not there");
      return false;
    }
  return true;
}

/// The source line of each frame.
static std::vector<SourceLine> linesOf(const ProfileEntries &Entries) {
  std::vector<SourceLine> Lines;
  for (const FrameEntry &Frame : Entries.Frames)
    Lines.push_back({Entries.Functions[Frame.Function].Name,
                     Frame.File ? Entries.Files[*Frame.File].Path : "",
                     Frame.Line});
  return Lines;
}

static void addServed(const std::map<std::string, ServedEntry> &Served,
                      ComparedRun &Run) {
  for (const auto &[Level, Entry] : Served) {
    Run.Figures.push_back(
        {"served by " + Level, Figure::Count, double(Entry.Accesses)});
    Run.Figures.push_back({"cycles of an access to " + Level, Figure::Number,
                           double(Entry.Cycles) / double(Entry.Accesses)});
  }
}

static bool readRun(const json::Object &Profile, ComparedRun &Run,
                    json::Path Path) {
  return readObject(Profile, "run", Path, [&](json::ObjectMapper &Object) {
    return Object.map("outcome", Run.Outcome) && Object.map("chip", Run.Chip) &&
           Object.map("tm_count", Run.TmCount) &&
           Object.map("tps_per_tm", Run.TpsPerTm) &&
           Object.map("cycles", Run.Cycles) &&
           Object.map("finished", Run.Counts[useOf(Loss::Finished)]);
  });
}

bool readProfile(const json::Value &Json, ComparedRun &Run, json::Path Path) {
  ProfileEntries Entries;
  unsigned Version;
  json::ObjectMapper Object(Json, Path);
  if (!Object || !Object.map("format_version", Version) ||
      !Object.map("files", Entries.Files) ||
      !Object.map("functions", Entries.Functions) ||
      !Object.map("frames", Entries.Frames) ||
      !Object.map("instructions", Entries.Instructions) ||
      !checkIndices(Entries, Path) || !readRun(*Json.getAsObject(), Run, Path))
    return false;
  if (Version != 1) {
    Path.field("format_version").report("another version");
    return false;
  }
  std::vector<SourceLine> Lines = linesOf(Entries);
  std::map<std::string, ServedEntry> Served;
  Run.Lines.emplace();
  for (const InstructionEntry &Entry : Entries.Instructions) {
    add((*Run.Lines)[Lines[Entry.Frame]], Entry.Counts);
    add(Run.Counts, Entry.Counts);
    Run.Opcodes[StringRef(Entry.Text).take_until(isSpace).str()] +=
        Entry.Counts[0];
    for (const auto &[Level, Part] : Entry.Served) {
      Served[Level].Accesses += Part.Accesses;
      Served[Level].Cycles += Part.Cycles;
    }
  }
  addServed(Served, Run);
  return true;
}

} // namespace tp
