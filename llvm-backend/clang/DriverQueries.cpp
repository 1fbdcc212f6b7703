//===- DriverQueries.cpp - Questions that tpcc answers itself -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/DriverQueries.h"
#include "llvm-backend/TPDataLayout.h"
#include "llvm-backend/clang/HostPaths.h"
#include "llvm-backend/clang/OwnOptions.h"
#include "clang/Basic/Version.h"
#include "clang/Options/Options.h"
#include "llvm/Option/OptTable.h"
#include "llvm/Support/Path.h"

using namespace clang::options;
using namespace llvm;

namespace tp {

static constexpr const char LinkHelp[] = R"(
Options of the link:
  -nostdlib                 Link without the runtime (no _start, no C library)
  -Wl,--entry=<symbol>      Start at <symbol> instead of _start
  -Wl,--no-gc-sections      Keep code and data that nothing refers to
  -Wl,-Map=<file>           Write where everything lies in the program

Link order is free: all C, C++, LLVM IR and bitcode inputs are optimized as one
program with the runtime at the -O level of the command.
)";

void printVersion(raw_ostream &Stream, StringRef ToolPath) {
  Stream << "tpcc version " TP_VERSION " (clang " CLANG_VERSION_STRING ")\n"
         << "Target: " << llvm::TPTriple << '\n'
         << "Thread model: posix\n"
         << "InstalledDir: " << sys::path::parent_path(ToolPath) << '\n';
}

bool answerQuery(const opt::ArgList &UserArguments, StringRef ToolPath) {
  if (UserArguments.hasArg(OPT_help, OPT__help_hidden)) {
    clang::getDriverOptTable().printHelp(
        outs(), "tpcc [options] file...",
        "Compiler for the thread processor (TP): C, C++, LLVM IR and assembly "
        "to ELF",
        UserArguments.hasArg(OPT__help_hidden), /*ShowAllAliases=*/false,
        opt::Visibility(ClangOption));
    outs() << "\nBesides clang's options:\n";
    printOwnOptions(outs());
    outs() << LinkHelp;
    return true;
  }
  if (UserArguments.hasArg(OPT__version)) {
    printVersion(outs(), ToolPath);
    return true;
  }
  if (UserArguments.hasArg(OPT_dumpversion)) {
    outs() << CLANG_VERSION_STRING "\n";
    return true;
  }
  if (UserArguments.hasArg(OPT_dumpmachine, OPT_print_target_triple,
                           OPT_print_effective_triple)) {
    outs() << llvm::TPTriple << '\n';
    return true;
  }
  return false;
}

} // namespace tp
