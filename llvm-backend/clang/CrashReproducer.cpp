//===- CrashReproducer.cpp - What a bug report of tpcc needs --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/CrashReproducer.h"
#include "llvm-backend/clang/DriverQueries.h"
#include "clang/Basic/DiagnosticDriver.h"
#include "clang/Driver/Driver.h"
#include "clang/Driver/InputInfo.h"
#include "clang/Driver/Job.h"
#include "clang/Driver/Types.h"
#include "clang/Options/Options.h"
#include "llvm/ADT/StringMap.h"
#include "llvm/ADT/StringSwitch.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/Path.h"
#include "llvm/Support/Program.h"

using namespace clang;
using namespace clang::driver;
using namespace clang::options;
using namespace llvm;
using namespace llvm::opt;

namespace tp {

ReproducerLevel reproducerLevel(const ArgList &Arguments) {
  if (const Arg *Given = Arguments.getLastArg(OPT_gen_reproducer_eq))
    return StringSwitch<ReproducerLevel>(Given->getValue())
        .Case("off", ReproducerLevel::Off)
        .Case("error", ReproducerLevel::Error)
        .Case("always", ReproducerLevel::Always)
        .Default(ReproducerLevel::Crash);
  if (Arguments.hasArg(OPT_fno_crash_diagnostics) ||
      StringRef(Arguments.getLastArgValue(OPT_fcrash_diagnostics_EQ)) == "off")
    return ReproducerLevel::Off;
  return ReproducerLevel::Crash;
}

// The arguments of Job with which it preprocesses into Output; empty if it does
// not read source code.
static std::vector<StringRef> preprocessingArguments(const Command &Job,
                                                     StringRef Output) {
  static constexpr StringRef Actions[] = {
      "-emit-obj", "-emit-llvm-bc", "-emit-llvm", "-S", "-E", "-fsyntax-only"};
  std::vector<StringRef> Result;
  bool IsPreprocessing = false;
  const ArgStringList &Arguments = Job.getArguments();
  for (size_t I = 0; I < Arguments.size(); ++I) {
    StringRef Word = Arguments[I];
    if (Word == "-o") {
      ++I;
    } else if (is_contained(Actions, Word)) {
      IsPreprocessing = true;
      append_range(Result, ArrayRef<StringRef>{"-E", "-frewrite-includes",
                                               "-disable-pragma-debug-crash",
                                               "-o", Output});
    } else {
      Result.push_back(Word);
    }
  }
  return IsPreprocessing ? Result : std::vector<StringRef>();
}

// Whether the option has done its work in the preprocessed source, or writes
// files of its own.
static bool isSpent(const CommandLineOption &Option) {
  switch (Option.ID) {
  case OPT_I:
  case OPT_include:
  case OPT_isystem:
  case OPT_iquote:
  case OPT_idirafter:
  case OPT_MD:
  case OPT_MMD:
  case OPT_MF:
  case OPT_MT:
  case OPT_MQ:
  case OPT_MP:
  case OPT_MJ:
  case OPT_save_temps_EQ:
  case OPT_gen_reproducer_eq:
  case OPT_fcrash_diagnostics_EQ:
  case OPT_fcrash_diagnostics_dir:
    return true;
  default:
    return false;
  }
}

static bool writeScript(StringRef Path, ArrayRef<CommandLineOption> UserOptions,
                        const StringMap<std::string> &Sources,
                        const std::string &ToolPath) {
  std::error_code Failure;
  raw_fd_ostream Script(Path, Failure, sys::fs::OF_Text);
  if (Failure)
    return false;
  Script << "# Compiles again what tpcc could not compile. The command was:\n#";
  for (const CommandLineOption &Option : UserOptions)
    Script << ' ' << Option.text();
  Script << "\ncd \"$(dirname \"$0\")\"\n";
  sys::printArg(Script, ToolPath, /*Quote=*/true);
  for (const CommandLineOption &Option : UserOptions) {
    if (isSpent(Option))
      continue;
    for (StringRef Word : Option.Words) {
      auto Source = Sources.find(Word);
      Script << ' ';
      sys::printArg(
          Script,
          Source == Sources.end() ? Word : sys::path::filename(Source->second),
          /*Quote=*/true);
    }
  }
  Script << '\n';
  return true;
}

namespace {
/// The files of one reproducer.
class Reproducer {
public:
  Reproducer(const Compilation &Jobs, const std::string &ToolPath)
      : Jobs(Jobs), ToolPath(ToolPath) {}

  /// \returns whether there is a script.
  bool write(ArrayRef<CommandLineOption> UserOptions);

  std::vector<std::string> Files;

private:
  std::string createFile(StringRef Stem, StringRef Extension);
  void preprocess(const Command &Job);

  const Compilation &Jobs;
  const std::string &ToolPath;
  /// What the user calls a source, and what it is here.
  StringMap<std::string> Sources;
};
} // namespace

std::string Reproducer::createFile(StringRef Stem, StringRef Extension) {
  SmallString<128> Folder(
      Jobs.getArgs().getLastArgValue(OPT_fcrash_diagnostics_dir));
  if (Folder.empty())
    sys::path::system_temp_directory(/*ErasedOnReboot=*/true, Folder);
  else if (sys::fs::create_directories(Folder))
    return {};
  sys::path::append(Folder, Stem + "-%%%%%%" + Extension);
  SmallString<128> Path;
  if (sys::fs::createUniqueFile(Folder, Path))
    return {};
  return std::string(Path);
}

void Reproducer::preprocess(const Command &Job) {
  if (Job.getInputInfos().empty() || !Job.getInputInfos().front().isFilename())
    return;
  StringRef Source = Job.getInputInfos().front().getBaseInput();
  if (!sys::fs::exists(Source) || Sources.contains(Source))
    return;
  const std::string Output =
      createFile(sys::path::stem(Source), sys::path::extension(Source));
  std::vector<StringRef> Words{ToolPath};
  std::vector<StringRef> Arguments = preprocessingArguments(Job, Output);
  if (Output.empty() || Arguments.empty())
    return;
  append_range(Words, Arguments);
  const std::optional<StringRef> Redirections[] = {"", "", ""};
  if (sys::ExecuteAndWait(ToolPath, Words, /*Env=*/std::nullopt,
                          Redirections) != 0) {
    [[maybe_unused]] std::error_code Ignored = sys::fs::remove(Output);
    return;
  }
  Sources[Source] = Output;
  Files.push_back(Output);
}

bool Reproducer::write(ArrayRef<CommandLineOption> UserOptions) {
  for (const Command &Job : Jobs.getJobs())
    if (StringRef(Job.getArguments().front()) == "-cc1")
      preprocess(Job);
  SmallString<128> Script;
  if (Files.empty()) {
    Script = createFile("tpcc", ".sh");
  } else {
    Script = Files.front();
    sys::path::replace_extension(Script, ".sh");
  }
  if (Script.empty() || !writeScript(Script, UserOptions, Sources, ToolPath))
    return false;
  Files.push_back(std::string(Script));
  return true;
}

void writeReproducer(const Compilation &Jobs,
                     ArrayRef<CommandLineOption> UserOptions,
                     const std::string &ToolPath) {
  DiagnosticsEngine &Diags = Jobs.getDriver().getDiags();
  auto Note = [&](StringRef Text) {
    Diags.Report(diag::note_drv_command_failed_diag_msg) << Text;
  };
  printVersion(errs(), ToolPath);
  Reproducer Result(Jobs, ToolPath);
  if (!Result.write(UserOptions)) {
    Note("cannot write a reproducer into the folder of temporary files");
    return;
  }
  Note("\n********************\n\nPlease attach these files to the report of "
       "the bug: the preprocessed sources and a script that compiles them.");
  for (StringRef File : Result.Files)
    Note(File);
  Note("\n\n********************");
}

} // namespace tp
