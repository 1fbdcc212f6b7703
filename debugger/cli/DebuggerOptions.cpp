//===- DebuggerOptions.cpp - Command line of tpdbg ------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/cli/DebuggerOptions.h"

#include "llvm/Option/Arg.h"
#include "llvm/Option/ArgList.h"
#include "llvm/Option/OptTable.h"
#include "llvm/Option/Option.h"

using namespace llvm;

namespace tp {
namespace {

enum OptionId {
  OPT_INVALID = 0,
#define OPTION(...) LLVM_MAKE_OPT_ID(__VA_ARGS__),
#include "debugger/Options.inc"
#undef OPTION
};

using namespace llvm::opt;

#define OPTTABLE_STR_TABLE_CODE
#include "debugger/Options.inc"
#undef OPTTABLE_STR_TABLE_CODE

#define OPTTABLE_PREFIXES_TABLE_CODE
#include "debugger/Options.inc"
#undef OPTTABLE_PREFIXES_TABLE_CODE

constexpr OptTable::Info InfoTable[] = {
#define OPTION(...) LLVM_CONSTRUCT_OPT_INFO(__VA_ARGS__),
#include "debugger/Options.inc"
#undef OPTION
};

class DebuggerOptTable : public GenericOptTable {
public:
  DebuggerOptTable()
      : GenericOptTable(OptionStrTable, OptionPrefixesTable, InfoTable) {}
};

/// What is not the debugger's own says what to debug.
Expected<SessionOptions> readSession(const InputArgList &Arguments) {
  std::vector<std::string> Text;
  for (const Arg *Argument : Arguments) {
    const opt::Option &Of = Argument->getOption();
    if (Of.matches(OPT_INPUT) || Of.matches(OPT_UNKNOWN))
      Text.push_back(Argument->getAsString(Arguments));
    if (Of.matches(OPT_end_of_options)) {
      Text.push_back("--");
      append_range(Text, Argument->getValues());
    }
  }
  std::vector<const char *> Pointers;
  for (const std::string &T : Text)
    Pointers.push_back(T.c_str());
  return parseSessionOptions(Pointers);
}

} // namespace

Expected<DebuggerOptions>
parseDebuggerOptions(ArrayRef<const char *> Arguments) {
  unsigned MissingIndex, MissingCount;
  InputArgList Parsed =
      DebuggerOptTable().ParseArgs(Arguments, MissingIndex, MissingCount);
  if (MissingCount != 0)
    return createStringError(Twine("option '") +
                             Parsed.getArgString(MissingIndex) +
                             "' needs a value (see --help)");
  DebuggerOptions Result;
  Result.Help = Parsed.hasArg(OPT_help);
  Result.Version = Parsed.hasArg(OPT_version);
  if (Result.Help || Result.Version)
    return Result;
  Result.Batch = Parsed.hasArg(OPT_batch);
  for (const Arg *Argument : Parsed.filtered(OPT_command, OPT_eval_command))
    Result.Commands.push_back(
        {Argument->getOption().matches(OPT_command), Argument->getValue()});
  Result.ServesEditor = Parsed.hasArg(OPT_dap);
  if (const Arg *Port = Parsed.getLastArg(OPT_port)) {
    uint16_t Number;
    if (!Result.ServesEditor)
      return createStringError("--port has no meaning without --dap");
    if (StringRef(Port->getValue()).getAsInteger(10, Number))
      return createStringError(Twine("--port '") + Port->getValue() +
                               "': expected a whole number up to 65535");
    Result.Port = Number;
  }
  if (Result.ServesEditor) {
    if (!Result.Commands.empty() || Result.Batch)
      return createStringError("--dap takes no commands; the editor sends "
                               "them");
    if (const Arg *Rest =
            Parsed.getLastArg(OPT_INPUT, OPT_UNKNOWN, OPT_end_of_options))
      return createStringError(
          "--dap takes no program and no options of it ('" +
          Rest->getAsString(Parsed) +
          "'); the launch configuration names them");
    return Result;
  }
  Expected<SessionOptions> Session = readSession(Parsed);
  if (!Session)
    return Session.takeError();
  Result.Session = std::move(*Session);
  return Result;
}

void printDebuggerHelp(raw_ostream &OS) {
  DebuggerOptTable().printHelp(
      OS, "tpdbg [options] program.elf [-- arguments of the program]",
      "Debugs a program on a simulated chip, forwards and backwards");
  OS << "  --checkpoint-memory <MiB>\n"
        "                          Memory for going back (default: 512)\n"
        "\nOptions of tpsim that say what is run (see tpsim --help): --chip, "
        "--set, --scene,\n--size, --spp, --depth, --seed, --bvh, --functional, "
        "--max-cycles, --host-threads.\n";
}

} // namespace tp
