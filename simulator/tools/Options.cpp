//===- Options.cpp - Command line of tpsim --------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/tools/Options.h"
#include "simulator/check/Suppressions.h"

#include "simulator/chip/ChipLimits.h"

#include "llvm/ADT/StringExtras.h"
#include "llvm/Option/Arg.h"
#include "llvm/Option/ArgList.h"
#include "llvm/Option/OptTable.h"
#include "llvm/Option/Option.h"

#include <algorithm>
#include <thread>

using namespace llvm;

namespace tp {
namespace {

enum OptionId {
  OPT_INVALID = 0,
#define OPTION(...) LLVM_MAKE_OPT_ID(__VA_ARGS__),
#include "simulator/tools/Options.inc"
#undef OPTION
};

using namespace llvm::opt;

#define OPTTABLE_STR_TABLE_CODE
#include "simulator/tools/Options.inc"
#undef OPTTABLE_STR_TABLE_CODE

#define OPTTABLE_PREFIXES_TABLE_CODE
#include "simulator/tools/Options.inc"
#undef OPTTABLE_PREFIXES_TABLE_CODE

constexpr OptTable::Info InfoTable[] = {
#define OPTION(...) LLVM_CONSTRUCT_OPT_INFO(__VA_ARGS__),
#include "simulator/tools/Options.inc"
#undef OPTION
};

class TpsimOptTable : public GenericOptTable {
public:
  TpsimOptTable()
      : GenericOptTable(OptionStrTable, OptionPrefixesTable, InfoTable) {}
};

/// The largest immediate of `prof`.
constexpr uint32_t MaxMarker = 0xFFFF;

/// Turns parsed arguments into Options and keeps the first error.
class OptionReader {
public:
  explicit OptionReader(const InputArgList &Arguments) : Arguments(Arguments) {}

  Expected<Options> read() {
    Options Result;
    Result.Help = Arguments.hasArg(OPT_help);
    Result.Version = Arguments.hasArg(OPT_version);
    Result.PrintChipSchema = Arguments.hasArg(OPT_print_chip_schema);
    if (Result.Help || Result.Version || Result.PrintChipSchema)
      return Result;
    if (Arguments.hasArg(OPT_compare)) {
      readComparison(Result);
      if (!Message.empty())
        return createStringError(Message);
      return Result;
    }
    readProfile(Result);
    if (Result.Profile && !Result.Profile->Input.empty()) {
      if (!Message.empty())
        return createStringError(Message);
      return Result;
    }
    Result.Quiet = Arguments.hasArg(OPT_quiet);
    Result.PrintChip = Arguments.hasArg(OPT_print_chip);
    Result.Chip = Arguments.getLastArgValue(OPT_chip, "report-512x8").str();
    unsigned Cores = std::max(std::thread::hardware_concurrency(), 1u);
    Result.HostThreads = number(OPT_host_threads, 1, MaxHostThreads,
                                std::min(Cores, MaxHostThreads));
    Result.GenerateCode = readEngine();
    Result.MaxCycles = number(OPT_max_cycles, 1, INT64_MAX, 0);
    Result.ChipSettings = Arguments.getAllArgValues(OPT_set);
    excludeComparison();
    readTrace(Result);
    readStatistics(Result);
    readLongRun(Result);
    readCacheTrace(Result);
    readInstructionTrace(Result);
    readChecks(Result);
    readMemoryDumps(Result);
    readProgram(Result);
    readImage(Result);
    if (!Message.empty())
      return createStringError(Message);
    return Result;
  }

private:
  const InputArgList &Arguments;
  std::string Message;

  void error(const Twine &What) {
    if (Message.empty())
      Message = What.str();
  }

  uint64_t number(OptionId Id, uint64_t Min, uint64_t Max, uint64_t Default) {
    const Arg *Argument = Arguments.getLastArg(Id);
    if (!Argument)
      return Default;
    uint64_t Value;
    StringRef Text = Argument->getValue();
    if (!Text.getAsInteger(10, Value) && Value >= Min && Value <= Max)
      return Value;
    error(Argument->getSpelling().rtrim('=') + " '" + Text +
          "': expected a whole number from " + Twine(Min) + " to " +
          Twine(Max));
    return Default;
  }

  void readComparison(Options &Result) {
    for (const Arg *Argument : Arguments)
      if (!Argument->getOption().matches(OPT_compare) &&
          !Argument->getOption().matches(OPT_compare_output) &&
          !Argument->getOption().matches(OPT_compare_rows) &&
          !Argument->getOption().matches(OPT_INPUT))
        error(Argument->getSpelling().rtrim('=') +
              " has no meaning with --compare, which runs nothing");
    std::vector<std::string> Inputs = Arguments.getAllArgValues(OPT_INPUT);
    if (Inputs.size() != 2) {
      error("--compare needs two files that --stats or --profile has written: "
            "tpsim --compare before.json after.json");
      return;
    }
    ComparisonRequest &Request = Result.Comparison.emplace();
    Request.Before = Inputs[0];
    Request.After = Inputs[1];
    Request.Output = Arguments.getLastArgValue(OPT_compare_output).str();
    if (Arguments.hasArg(OPT_compare_output) && Request.Output.empty())
      error("--compare-output is empty; give it the path of the file to write");
    Request.Rows =
        unsigned(number(OPT_compare_rows, 1, UINT32_MAX, Request.Rows));
  }

  /// Options that need --compare.
  void excludeComparison() {
    for (OptionId Id : {OPT_compare_output, OPT_compare_rows})
      if (const Arg *Argument = Arguments.getLastArg(Id))
        error(Argument->getSpelling().rtrim('=') +
              " has no meaning without --compare");
  }

  void readStatistics(Options &Result) {
    Result.StatisticsOutput = Arguments.getLastArgValue(OPT_stats).str();
    Result.PerPc = Arguments.hasArg(OPT_per_pc);
    if (Result.PerPc && Result.StatisticsOutput.empty())
      error("--per-pc has no meaning without --stats; give the file to write");
    Result.Interval = number(OPT_interval, 1, INT64_MAX, 0);
    Result.IntervalOutput =
        Arguments.getLastArgValue(OPT_interval_output).str();
    if (Arguments.hasArg(OPT_interval) != Arguments.hasArg(OPT_interval_output))
      error("--interval and --interval-output need each other: cycles of an "
            "interval, and the file to write");
    StringRef Path = Result.IntervalOutput;
    if (Arguments.hasArg(OPT_interval_output) && !Path.ends_with(".csv") &&
        !Path.ends_with(".json"))
      error("--interval-output '" + Path +
            "': expected a file that ends in .csv or .json");
    exclude(OPT_functional, OPT_interval, "the functional mode has no cycles");
  }

  /// The path of a file that must be named if the option is given.
  std::string path(OptionId Id) {
    const Arg *Argument = Arguments.getLastArg(Id);
    if (!Argument)
      return "";
    if (StringRef(Argument->getValue()).empty())
      error(Argument->getSpelling().rtrim('=') +
            " is empty; give it the path of a file");
    return Argument->getValue();
  }

  void readProfile(Options &Result) {
    constexpr OptionId Ids[] = {OPT_profile_sort,       OPT_profile_by,
                                OPT_profile_rows,       OPT_profile_folded,
                                OPT_profile_speedscope, OPT_profile_html};
    bool IsRead = Arguments.hasArg(OPT_read_profile);
    if (!Arguments.hasArg(OPT_profile, OPT_profile_EQ) && !IsRead) {
      for (OptionId Id : Ids)
        if (const Arg *Argument = Arguments.getLastArg(Id))
          error(Argument->getSpelling().rtrim('=') +
                " has no meaning without --profile or --read-profile");
      return;
    }
    ProfileRequest &Request = Result.Profile.emplace();
    Request.Input = path(OPT_read_profile);
    Request.Output = path(OPT_profile_EQ);
    Request.FoldedOutput = path(OPT_profile_folded);
    Request.SpeedscopeOutput = path(OPT_profile_speedscope);
    Request.HtmlOutput = path(OPT_profile_html);
    readProfileTable(Request.Table);
    if (IsRead)
      for (const Arg *Argument : Arguments)
        if (!Argument->getOption().matches(OPT_read_profile) &&
            none_of(Ids, [&](OptionId Id) {
              return Argument->getOption().matches(Id);
            }))
          error(Argument->getAsString(Arguments) +
                " has no meaning with --read-profile, which runs nothing");
    for (OptionId Profile : {OPT_profile, OPT_profile_EQ}) {
      exclude(Profile, OPT_functional, "the functional mode has no cycles");
      exclude(Profile, OPT_regions, "a profile is of a whole run");
    }
  }

  void readTrace(Options &Result) {
    if (!Arguments.hasArg(OPT_trace_tps, OPT_trace_output, OPT_trace_cycles))
      return;
    TraceRequest &Request = Result.Trace.emplace();
    if (!Arguments.hasArg(OPT_trace_tps) || !Arguments.hasArg(OPT_trace_output))
      error("a trace needs --trace-tps <tm.tp,...>, what to trace, and "
            "--trace-output <file>");
    Request.Output = path(OPT_trace_output);
    for (StringRef Text :
         split(Arguments.getLastArgValue(OPT_trace_tps), ',')) {
      auto [Tm, Tp] = Text.split('.');
      TracedTp Which;
      if (Tm.getAsInteger(10, Which.Tm) || Tp.getAsInteger(10, Which.Tp))
        error("--trace-tps '" + Text +
              "': expected the numbers of a TM and of a TP in it, <tm.tp>");
      Request.Tps.push_back(Which);
    }
    if (const Arg *Argument = Arguments.getLastArg(OPT_trace_cycles)) {
      auto [First, End] = StringRef(Argument->getValue()).split(':');
      if (First.getAsInteger(10, Request.FirstCycle) ||
          End.getAsInteger(10, Request.EndCycle) ||
          Request.FirstCycle >= Request.EndCycle)
        error(Twine("--trace-cycles '") + Argument->getValue() +
              "': expected <first>:<end>, the first cycle and the one behind "
              "the last");
    }
    for (OptionId Trace : {OPT_trace_tps, OPT_trace_output}) {
      exclude(Trace, OPT_functional, "the functional mode has no cycles");
      for (OptionId Id : {OPT_checkpoint, OPT_restore, OPT_fast_forward})
        exclude(Trace, Id, "a trace follows its threads from the first cycle");
    }
    if (const Arg *Engine = Arguments.getLastArg(OPT_engine);
        Engine && Result.GenerateCode)
      error("--trace-tps and --engine=jit exclude each other: generated code "
            "is not traced");
    Result.GenerateCode = false;
  }

  void readProfileTable(ProfileTableOptions &Table) {
    Table.MaxRows = number(OPT_profile_rows, 1, UINT32_MAX, Table.MaxRows);
    if (const Arg *Argument = Arguments.getLastArg(OPT_profile_by)) {
      std::optional<ProfileRows> Rows = findProfileRows(Argument->getValue());
      if (!Rows)
        error(Twine("--profile-by '") + Argument->getValue() +
              "': expected line, function, path or instruction");
      Table.Rows = Rows.value_or(Table.Rows);
    }
    if (const Arg *Argument = Arguments.getLastArg(OPT_profile_sort)) {
      std::optional<ProfileOrder> Order =
          findProfileOrder(Argument->getValue());
      if (!Order)
        error(Twine("--profile-sort '") + Argument->getValue() +
              "': expected one of " + join(profileOrderNames(), ", "));
      Table.Order = Order.value_or(Table.Order);
    }
  }

  /// Whether the engine is the one that generates code.
  bool readEngine() {
    StringRef Name = Arguments.getLastArgValue(OPT_engine, "jit");
    if (Name != "jit" && Name != "reference")
      error("--engine '" + Name + "': expected jit or reference");
    return Name == "jit";
  }

  /// Two options that exclude each other.
  void exclude(OptionId First, OptionId Second, const char *Why) {
    const Arg *A = Arguments.getLastArg(First);
    const Arg *B = Arguments.getLastArg(Second);
    if (A && B)
      error(A->getSpelling().rtrim('=') + " and " +
            B->getSpelling().rtrim('=') + " exclude each other: " + Why);
  }

  void readRegions(Options &Result) {
    StringRef Text = Arguments.getLastArgValue(OPT_regions);
    auto [Begin, End] = Text.split(':');
    MarkerRegion Region;
    if (Begin.getAsInteger(10, Region.Begin) ||
        End.getAsInteger(10, Region.End) || Region.Begin > MaxMarker ||
        Region.End > MaxMarker || Region.Begin == Region.End)
      error("--regions '" + Text +
            "': expected the numbers of two different profile markers, "
            "<begin>:<end>");
    Result.Regions = Region;
  }

  void readLongRun(Options &Result) {
    Result.Functional = Arguments.hasArg(OPT_functional);
    if (Arguments.hasArg(OPT_fast_forward))
      Result.FastForward = uint32_t(number(OPT_fast_forward, 0, MaxMarker, 0));
    if (Arguments.hasArg(OPT_regions))
      readRegions(Result);
    Result.CheckpointOutput = Arguments.getLastArgValue(OPT_checkpoint).str();
    Result.CheckpointEvery = number(OPT_checkpoint_every, 1, INT64_MAX, 0);
    Result.RestoreInput = Arguments.getLastArgValue(OPT_restore).str();
    for (OptionId Id : {OPT_checkpoint, OPT_restore})
      if (Arguments.hasArg(Id) && Arguments.getLastArgValue(Id).empty())
        error(Arguments.getLastArg(Id)->getSpelling().rtrim('=') +
              " is empty; give it the path of a checkpoint file");
    if (Arguments.hasArg(OPT_checkpoint_every) &&
        !Arguments.hasArg(OPT_checkpoint))
      error("--checkpoint-every has no meaning without --checkpoint; give the "
            "file to write");
    for (OptionId Id : {OPT_fast_forward, OPT_regions, OPT_checkpoint,
                        OPT_restore, OPT_max_cycles})
      exclude(OPT_functional, Id, "the functional mode has no cycles");
  }

  void readCacheTrace(Options &Result) {
    Result.CacheTraceOutput = Arguments.getLastArgValue(OPT_trace_cache).str();
    Result.TracedDeletion.Thread =
        uint32_t(number(OPT_trace_cache_thread, 0, MaxThreads - 1, 0));
    Result.TracedDeletion.Deletion =
        number(OPT_trace_cache_deletion, 1, INT64_MAX, 1);
    if (Arguments.hasArg(OPT_trace_cache)) {
      if (Result.CacheTraceOutput.empty())
        error("--trace-cache is empty; give it the path of the file to write");
      return;
    }
    for (OptionId Id : {OPT_trace_cache_thread, OPT_trace_cache_deletion})
      if (const Arg *Argument = Arguments.getLastArg(Id))
        error(Argument->getSpelling().rtrim('=') +
              " has no meaning without --trace-cache");
  }

  void readInstructionTrace(Options &Result) {
    Result.InstructionTraceOutput =
        Arguments.getLastArgValue(OPT_trace_instructions).str();
    Result.TracedThread =
        uint32_t(number(OPT_trace_instructions_thread, 0, MaxThreads - 1, 0));
    if (!Arguments.hasArg(OPT_trace_instructions)) {
      if (Arguments.hasArg(OPT_trace_instructions_thread))
        error("--trace-instructions-thread has no meaning without "
              "--trace-instructions");
      return;
    }
    if (Result.InstructionTraceOutput.empty())
      error("--trace-instructions is empty; give it the path of the file to "
            "write");
    if (!Arguments.hasArg(OPT_functional))
      error("--trace-instructions needs --functional: with timing, several "
            "instructions are under way at once");
  }

  void readChecks(Options &Result) {
    if (!Arguments.hasArg(OPT_check)) {
      for (OptionId Id : {OPT_check_suppressions, OPT_check_output})
        if (const Arg *Argument = Arguments.getLastArg(Id))
          error(Argument->getSpelling().rtrim('=') +
                " has no meaning without --check");
      return;
    }
    for (const Arg *Argument : Arguments.filtered(OPT_check))
      for (StringRef Name : split(Argument->getValue(), ',')) {
        if (Name == "all")
          append_range(Result.Checkers, CheckerNames);
        else if (is_contained(CheckerNames, Name))
          Result.Checkers.push_back(Name.str());
        else
          error("--check '" + Name + "': expected one of " +
                join(std::begin(CheckerNames), std::end(CheckerNames), ", ") +
                ", all, or several with commas");
      }
    Result.Functional = true;
    Result.CheckSuppressions =
        Arguments.getLastArgValue(OPT_check_suppressions).str();
    Result.CheckOutput = Arguments.getLastArgValue(OPT_check_output).str();
    for (OptionId Id : {OPT_check_suppressions, OPT_check_output})
      if (Arguments.hasArg(Id) && Arguments.getLastArgValue(Id).empty())
        error(Arguments.getLastArg(Id)->getSpelling().rtrim('=') +
              " is empty; give it the path of a file");
    for (OptionId Id : {OPT_fast_forward, OPT_regions, OPT_checkpoint,
                        OPT_restore, OPT_max_cycles, OPT_interval, OPT_profile,
                        OPT_profile_EQ, OPT_trace_tps, OPT_trace_output})
      exclude(OPT_check, Id, "checks execute without timing");
    exclude(OPT_check, OPT_trace_instructions,
            "trace the instructions in a run of their own");
  }

  void readMemoryDumps(Options &Result) {
    for (const Arg *Argument : Arguments.filtered(OPT_dump_memory)) {
      StringRef Text = Argument->getValue();
      auto [Symbol, Path] = Text.split('=');
      if (Symbol.empty() || Path.empty())
        error("--dump-memory '" + Text + "': expected <variable>=<file>");
      Result.MemoryDumps.push_back({Symbol.str(), Path.str()});
    }
  }

  void readProgram(Options &Result) {
    std::vector<std::string> Inputs = Arguments.getAllArgValues(OPT_INPUT);
    if (Inputs.size() > 1)
      error("more than one program: '" + Inputs[0] + "' and '" + Inputs[1] +
            "'; arguments of the program go behind --");
    if (Inputs.empty() && !Result.PrintChip)
      error("no program; usage: tpsim [options] program.elf (see --help)");
    if (!Inputs.empty())
      Result.Program = Inputs[0];
    Result.ProgramArguments = Arguments.getAllArgValues(OPT_end_of_options);
  }

  void readImage(Options &Result) {
    Result.Scene = Arguments.getLastArgValue(OPT_scene).str();
    Result.ImageOutput = Arguments.getLastArgValue(OPT_o).str();
    if (!Arguments.hasArg(OPT_scene))
      for (OptionId Id : {OPT_o, OPT_size, OPT_spp, OPT_depth, OPT_seed,
                          OPT_bvh, OPT_bvh_output})
        if (const Arg *Argument = Arguments.getLastArg(Id))
          error(Argument->getSpelling().rtrim('=') +
                " has no meaning without --scene; give the scene to render");
    if (Arguments.hasArg(OPT_scene) && Result.Scene.empty())
      error("--scene is empty; give it the path of a glTF or GLB file");
    if (Arguments.hasArg(OPT_o) && Result.ImageOutput.empty())
      error("-o is empty; give it the path of the PNG file to write");

    RenderOptions &Rendering = Result.Rendering;
    Rendering.SamplesPerPixel =
        number(OPT_spp, 1, kMaxSamplesPerPixel, Rendering.SamplesPerPixel);
    Rendering.MaxDepth =
        number(OPT_depth, 1, kMaxPathDepth, Rendering.MaxDepth);
    Rendering.Seed = number(OPT_seed, 0, UINT32_MAX, Rendering.Seed);
    if (const Arg *Size = Arguments.getLastArg(OPT_size))
      if (Status S = parseImageSize(Size->getValue(), Rendering); !S)
        error(S.message());
    if (const Arg *Builder = Arguments.getLastArg(OPT_bvh))
      if (Status S = parseBvhOrigin(Builder->getValue(), Rendering); !S)
        error(S.message());
    Result.BvhOutput = Arguments.getLastArgValue(OPT_bvh_output).str();
    if (Arguments.hasArg(OPT_bvh_output)) {
      if (Rendering.Bvh != BvhOrigin::Kernel)
        error("--bvh-output has no meaning without --bvh kernel");
      else if (Result.BvhOutput.empty())
        error("--bvh-output is empty; give it the path of the file to write");
    }
  }
};

} // namespace

Expected<Options> parseOptions(ArrayRef<const char *> Arguments) {
  TpsimOptTable Table;
  unsigned MissingIndex, MissingCount;
  InputArgList Parsed = Table.ParseArgs(Arguments, MissingIndex, MissingCount);
  if (const Arg *Unknown = Parsed.getLastArg(OPT_UNKNOWN)) {
    std::string Text = Unknown->getAsString(Parsed), Nearest;
    bool IsNear = Table.findNearest(Text, Nearest) <= 2;
    return createStringError(
        "unknown option '" + Text + "'" +
        (IsNear ? "; did you mean '" + Nearest + "'?" : " (see --help)"));
  }
  if (MissingCount != 0)
    return createStringError(Twine("option '") +
                             Parsed.getArgString(MissingIndex) +
                             "' needs a value (see --help)");
  return OptionReader(Parsed).read();
}

void printHelp(raw_ostream &OS) {
  TpsimOptTable().printHelp(
      OS, "tpsim [options] program.elf [-- arguments of the program]",
      "Simulates a ray-tracing chip cycle by cycle");
}

} // namespace tp
