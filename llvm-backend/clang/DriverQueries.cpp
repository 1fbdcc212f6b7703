//===- DriverQueries.cpp - Questions that tpcc answers itself -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/DriverQueries.h"
#include "llvm-backend/TPDataLayout.h"
#include "llvm-backend/clang/OwnOptions.h"
#include "llvm-backend/clang/Sysroot.h"
#include "clang/Basic/Version.h"
#include "clang/Options/Options.h"
#include "llvm/ADT/SmallString.h"
#include "llvm/Option/OptTable.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/Format.h"
#include "llvm/Support/Path.h"

using namespace clang::options;
using namespace llvm;
using namespace llvm::opt;

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

// Name in the first of Folders that has it; Name itself if none does.
static std::string findFile(StringRef Name, ArrayRef<std::string> Folders) {
  for (StringRef Folder : Folders) {
    SmallString<128> Path(Folder);
    sys::path::append(Path, Name);
    if (sys::fs::exists(Path))
      return std::string(Path);
  }
  return Name.str();
}

// -print-* options that ask where something is. \returns whether one was given.
static bool answerWhere(const ArgList &UserArguments, StringRef ToolPath) {
  Sysroot Folders(ToolPath);
  const std::string Programs = sys::path::parent_path(ToolPath).str();
  const std::string Resources = Sysroot::resourceFolder();
  if (UserArguments.hasArg(OPT_print_search_dirs)) {
    outs() << "programs: =" << Programs << "\nlibraries: =" << Folders.root()
           << ':' << Resources << '\n';
    return true;
  }
  if (const Arg *File = UserArguments.getLastArg(OPT_print_file_name_EQ)) {
    outs() << findFile(File->getValue(), {Resources, Folders.root()}) << '\n';
    return true;
  }
  if (const Arg *Program = UserArguments.getLastArg(OPT_print_prog_name_EQ)) {
    outs() << findFile(Program->getValue(), {Programs}) << '\n';
    return true;
  }
  if (UserArguments.hasArg(OPT_print_libgcc_file_name)) {
    outs() << Folders.runtimeBitcode() << '\n';
    return true;
  }
  if (UserArguments.hasArg(OPT_print_runtime_dir)) {
    outs() << Folders.root() << '\n';
    return true;
  }
  return false;
}

// The features of the target; those that UserArguments enable, or all.
static void printFeatures(const ArgList &UserArguments, bool OnlyEnabled) {
  const std::vector<std::string> Changes =
      UserArguments.getAllArgValues(OPT_Xclang);
  auto Print = [&](StringRef Name, bool IsEnabled, StringRef Help) {
    for (StringRef Change : Changes)
      if (Change.drop_front(1) == Name)
        IsEnabled = Change.front() == '+';
    if (IsEnabled || !OnlyEnabled)
      outs() << "    " << left_justify(Name, 8) << Help << '\n';
  };
  outs() << (OnlyEnabled ? "Features enabled for the TP\n\n"
                         : "Features of the TP\n\n");
  Print("trig", true, "sin_s and cos_s (-mtrig, -mno-trig)");
  Print("fma", false, "madd_s (-mfma, -mno-fma)");
}

// -print-* options that ask for what there is to choose.
static bool answerWhich(const ArgList &UserArguments) {
  if (UserArguments.hasArg(OPT_print_supported_cpus)) {
    outs() << "Available CPUs for this target:\n\n\tgeneric\n";
    return true;
  }
  if (UserArguments.hasArg(OPT_print_supported_extensions)) {
    printFeatures(UserArguments, /*OnlyEnabled=*/false);
    return true;
  }
  if (UserArguments.hasArg(OPT_print_enabled_extensions)) {
    printFeatures(UserArguments, /*OnlyEnabled=*/true);
    return true;
  }
  return false;
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
  return answerWhere(UserArguments, ToolPath) || answerWhich(UserArguments);
}

} // namespace tp
