//===- Options.td - Command line of tpdbg ------------------*- tablegen -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

include "llvm/Option/OptParser.td"

class LongFlag<string name, string help>
    : Option<["--", "-"], name, KIND_FLAG>, HelpText<help>;

// `--name value` and `--name=value`.
multiclass LongValue<string name, string metaVar, string help> {
  def NAME : Option<["--", "-"], name, KIND_SEPARATE>, MetaVarName<metaVar>,
             HelpText<help>;
  def NAME#_EQ : Option<["--", "-"], name#"=", KIND_JOINED>,
                 Alias<!cast<Option>(NAME)>;
}

def help : LongFlag<"help", "Print this text">;
def help_short : Option<["-"], "h", KIND_FLAG>, Alias<help>;
def version : LongFlag<"version", "Print the version">;
def batch : LongFlag<"batch", "Leave after the commands of -x and -ex">;
defm command : LongValue<"command", "<file>",
                         "Execute the commands of a file">;
def command_short : Option<["-"], "x", KIND_SEPARATE>, Alias<command>;
defm eval_command : LongValue<"eval-command", "<command>",
                              "Execute a command">;
def eval_command_short : Option<["-"], "ex", KIND_SEPARATE>,
                         Alias<eval_command>;
def dap : LongFlag<"dap", "Serve an editor by the Debug Adapter Protocol">;
defm port : LongValue<"port", "<n>",
                      "Of --dap: on this TCP port of localhost instead of "
                      "standard input and output">;
def end_of_options : Option<["--"], "", KIND_REMAINING_ARGS>,
                     MetaVarName<"<arguments>">,
                     HelpText<"Arguments of the program">;
