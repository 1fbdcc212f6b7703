//===- Options.td - Command line of tpsim ------------------*- tablegen -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

include "llvm/Option/OptParser.td"

class LongFlag<string name, string help>
    : Option<["--"], name, KIND_FLAG>, HelpText<help>;

// `--name value` and `--name=value`.
multiclass LongValue<string name, string metaVar, string help> {
  def NAME : Option<["--"], name, KIND_SEPARATE>, MetaVarName<metaVar>,
             HelpText<help>;
  def NAME#_EQ : Option<["--"], name#"=", KIND_JOINED>,
                 Alias<!cast<Option>(NAME)>;
}

def help : LongFlag<"help", "Print this text">;
def help_short : Option<["-"], "h", KIND_FLAG>, Alias<help>;
def version : LongFlag<"version", "Print the version">;
def quiet : LongFlag<"quiet", "No table and no progress line">;
def print_chip : LongFlag<"print-chip",
                      "Print the chip with every value resolved, as a chip file">;
def print_chip_schema : LongFlag<"print-chip-schema",
                             "Print the keys of chip files as a table">;

defm chip : LongValue<"chip", "<name|file.yaml>", "Chip (default: report-512x8)">;
defm set : LongValue<"set", "<path>=<value>",
                 "Another value for a key of the chip file">;
defm scene : LongValue<"scene", "<file>", "glTF or GLB scene to render">;
defm size : LongValue<"size", "<width>x<height>",
                  "Size of the image (default: 256x256)">;
defm spp : LongValue<"spp", "<n>", "Samples per pixel (default: 1)">;
defm depth : LongValue<"depth", "<n>",
                   "Bounces; 1 is primary and shadow rays (default: 1)">;
defm seed : LongValue<"seed", "<n>", "Seed of the random numbers (default: 1)">;
defm bvh : LongValue<"bvh", "<host|kernel>",
                 "Who builds the scene's BVH (default: host)">;
defm bvh_output : LongValue<"bvh-output", "<file>",
                        "Write the BVH that the kernel built">;
defm stats : LongValue<"stats", "<file>",
                   "Write the statistics as JSON; - is standard output">;
def per_pc : LongFlag<"per-pc",
                     "Counts and stalls of each instruction in the statistics">;
defm interval : LongValue<"interval", "<n>",
                      "Length of an interval of the series in cycles">;
defm interval_output : LongValue<"interval-output", "<file.csv|file.json>",
                             "Write a series of intervals; JSON is a trace for Perfetto">;
def profile : LongFlag<"profile",
                      "Print where the cycles went, by source line">;
def profile_EQ : Option<["--"], "profile=", KIND_JOINED>,
                 MetaVarName<"<file>">,
                 HelpText<"Likewise, and write the profile as JSON">;
defm profile_sort : LongValue<"profile-sort", "<key>",
                          "What the table is sorted by (default: cycles)">;
defm profile_by : LongValue<"profile-by", "<line|function|path|instruction>",
                        "What the rows of the table are (default: line)">;
defm profile_rows : LongValue<"profile-rows", "<n>",
                          "How many rows the table has (default: 16)">;
defm profile_folded : LongValue<"profile-folded", "<file>",
                            "Write cycles by stack for flame graphs">;
defm profile_speedscope : LongValue<"profile-speedscope", "<file>",
                                "Write cycles by stack for speedscope">;
defm profile_html : LongValue<"profile-html", "<file.html>",
                          "Write a report to look at in a browser">;
defm read_profile : LongValue<"read-profile", "<file>",
                          "Show a profile that was written, run nothing">;
defm trace_tps : LongValue<"trace-tps", "<tm.tp,...>",
                       "Trace these TPs cycle by cycle">;
defm trace_cycles : LongValue<"trace-cycles", "<first>:<end>",
                          "The cycles to trace (default: 0:10000)">;
defm trace_output : LongValue<"trace-output", "<file>",
                          "Write the trace, for Perfetto">;
def compare : LongFlag<"compare",
                       "Compare two runs: tpsim --compare before.json after.json,"
                       " which --stats or --profile has written">;
defm compare_output : LongValue<"compare-output", "<file>",
                            "Write the comparison as JSON; - is standard output">;
defm compare_rows : LongValue<"compare-rows", "<n>",
                          "Most lines of each table (default: 10)">;
defm dump_memory : LongValue<"dump-memory", "<variable>=<file>",
                         "Write a variable's bytes after the run">;
defm trace_cache : LongValue<"trace-cache", "<file>",
                         "Show a deletion in a cache of the BVH; write it as JSON">;
defm trace_cache_thread : LongValue<"trace-cache-thread", "<n>",
                                "Whose cache (default: 0)">;
defm trace_cache_deletion : LongValue<"trace-cache-deletion", "<n>",
                                  "Its how many-th deletion (default: 1)">;
defm trace_instructions : LongValue<"trace-instructions", "<file>",
                                "With --functional, write each instruction's "
                                "address and the registers that have changed">;
defm trace_instructions_thread : LongValue<"trace-instructions-thread", "<n>",
                                       "Whose instructions (default: 0)">;
defm host_threads : LongValue<"host-threads", "<n>",
                          "Threads of the host to use (default: all)">;
defm engine : LongValue<"engine", "<jit|reference>",
                    "Whether hot code is compiled (default: jit); changes "
                    "nothing but speed">;
defm max_cycles : LongValue<"max-cycles", "<n>",
                        "Stop with status 1 after so many cycles">;
defm check : LongValue<"check", "<checker>[,<checker>...]",
                   "Execute without timing and look for faults: memory, init, "
                   "stack, race, or all">;
defm check_suppressions : LongValue<"check-suppressions", "<file>",
                                "Faults that are not to be shown">;
defm check_output : LongValue<"check-output", "<file>",
                          "Write the faults as JSON; - is standard output">;
def functional : LongFlag<"functional",
                         "Execute without timing: no cycles, but fast">;
defm fast_forward : LongValue<"fast-forward", "<marker>",
                          "Without timing up to this profile marker">;
defm regions : LongValue<"regions", "<begin>:<end>",
                     "Count only between these profile markers">;
defm checkpoint : LongValue<"checkpoint", "<file>",
                        "Where to save the run's state, also on Ctrl-C">;
defm checkpoint_every : LongValue<"checkpoint-every", "<n>",
                              "Save it every so many cycles">;
defm restore : LongValue<"restore", "<file>",
                     "Go on from a saved state of the same run">;
def o : Option<["-"], "o", KIND_JOINED_OR_SEPARATE>, MetaVarName<"<file.png>">,
        HelpText<"Write the image">;
def end_of_options : Option<["--"], "", KIND_REMAINING_ARGS>,
                     MetaVarName<"<arguments>">,
                     HelpText<"Arguments of the program">;
