//===- Driver.cpp - The compiler driver tpcc ------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/Driver.h"
#include "llvm-backend/TPDataLayout.h"
#include "llvm-backend/clang/AssemblerJob.h"
#include "llvm-backend/clang/CrashReproducer.h"
#include "llvm-backend/clang/DriverArguments.h"
#include "llvm-backend/clang/DriverQueries.h"
#include "llvm-backend/clang/FloatingPointFlagWarnings.h"
#include "llvm-backend/clang/FloatingPointReport.h"
#include "llvm-backend/clang/FrontendJob.h"
#include "llvm-backend/clang/JobPlan.h"
#include "llvm-backend/clang/JobRunner.h"
#include "llvm-backend/clang/LinkJob.h"
#include "llvm-backend/clang/OwnOptions.h"
#include "llvm-backend/clang/RefusedOptions.h"
#include "clang/Basic/DiagnosticDriver.h"
#include "clang/Basic/DiagnosticFrontend.h"
#include "clang/Driver/Compilation.h"
#include "clang/Driver/Driver.h"
#include "clang/Frontend/CompilerInstance.h"
#include "clang/Frontend/CompilerInvocation.h"
#include "clang/Frontend/TextDiagnosticPrinter.h"
#include "clang/Options/Options.h"
#include "llvm/ADT/StringSet.h"
#include "llvm/Bitcode/BitcodeWriter.h"
#include "llvm/Option/OptTable.h"
#include "llvm/Support/CrashRecoveryContext.h"
#include "llvm/Support/ErrorHandling.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/PrettyStackTrace.h"
#include "llvm/Support/Process.h"
#include "llvm/Support/Signals.h"
#include "llvm/Support/VirtualFileSystem.h"
#include "llvm/Support/WithColor.h"

#include <cstdlib>

using namespace clang;
using namespace clang::driver;
using namespace clang::options;
using namespace llvm;
using namespace llvm::opt;

namespace tp {

static bool isWholeProgram(const ArgList &UserArguments) {
  return UserArguments.hasFlag(OPT_flto, OPT_flto_EQ, OPT_fno_lto, true);
}

// What goes to clang's driver: the defaults, then the user's words without
// -### and -v, at which clang's driver would print its own version, and
// without -flto where it is the default.
static SmallVector<const char *, 64>
driverArguments(const TranslatedCommandLine &User, const ArgList &UserArguments,
                const std::string &ToolPath) {
  SmallVector<const char *, 64> Arguments{ToolPath.c_str(),
                                          "--start-no-unused-arguments"};
  append_range(Arguments, defaultDriverArguments());
  append_range(Arguments, User.Defaults);
  // The trap of a failed check is named in line tables.
  if (UserArguments.hasArg(OPT_fsanitize_EQ))
    Arguments.push_back("-gline-tables-only");
  Arguments.push_back("--end-no-unused-arguments");
  if (UserArguments.hasArg(OPT_v))
    append_range(Arguments, ArrayRef<const char *>{"-Xclang", "-v"});
  // Objects are bitcode only if -flto says so.
  const bool Links = !UserArguments.hasArg(OPT_c, OPT_S);
  for (const CommandLineOption &Option : splitCommandLine(User.Words)) {
    const bool IsImplied =
        Option.ID == OPT__HASH_HASH_HASH || Option.ID == OPT_v ||
        (Links && (Option.ID == OPT_flto || Option.ID == OPT_flto_EQ));
    if (!IsImplied)
      append_range(Arguments, Option.Words);
  }
  return Arguments;
}

// Gives the jobs that clang's driver has planned what it does not know.
static void completeJobs(Compilation &Jobs, const JobPlan &Plan,
                         const ArgList &UserArguments,
                         ArrayRef<const char *> WarningWords,
                         const Sysroot &Folders, const std::string &ToolPath) {
  for (Command &Job : Jobs.getJobs()) {
    if (isa<LinkJobAction>(Job.getSource())) {
      LinkJob::describe(Jobs, Plan, ToolPath, WarningWords, Job);
      continue;
    }
    ArgStringList JobArguments = Job.getArguments();
    completeJobArguments(UserArguments, WarningWords, Folders, Jobs.getArgs(),
                         JobArguments);
    if (Plan.isUnit(Job))
      compileForWholeProgram(JobArguments);
    Job.replaceArguments(std::move(JobArguments));
  }
}

static void printJobs(const Compilation &Jobs, const JobPlan &Plan) {
  for (const Command &Job : Jobs.getJobs())
    if (!Plan.isDropped(Job))
      Job.Print(errs(), "\n", /*Quote=*/true);
}

static bool isInternalTool(ArrayRef<const char *> Arguments) {
  return !Arguments.empty() && (StringRef(Arguments[0]) == "-cc1" ||
                                StringRef(Arguments[0]) == "-cc1as");
}

static int runInternalTool(ArrayRef<const char *> Arguments,
                           const std::string &ToolPath,
                           DiagnosticsEngine &Diags) {
  if (StringRef(Arguments[0]) == "-cc1")
    return !runFrontend(Arguments.drop_front(), ToolPath.c_str());
  return !runAssembler(Arguments.drop_front(), Diags);
}

namespace {
/// The driver's messages, as a command line wants them.
struct DriverDiagnostics {
  DriverDiagnostics(const std::string &ToolPath, ArrayRef<const char *> Words);

  std::unique_ptr<DiagnosticOptions> Options;
  DiagnosticsEngine Engine;

private:
  static std::unique_ptr<DiagnosticOptions>
  readOptions(const std::string &ToolPath, ArrayRef<const char *> Words) {
    SmallVector<const char *, 64> WithToolName{ToolPath.c_str()};
    append_range(WithToolName, Words);
    return CreateAndPopulateDiagOpts(WithToolName);
  }
};
} // namespace

DriverDiagnostics::DriverDiagnostics(const std::string &ToolPath,
                                     ArrayRef<const char *> Words)
    : Options(readOptions(ToolPath, Words)),
      Engine(DiagnosticIDs::create(), *Options) {
  auto *Printer = new TextDiagnosticPrinter(errs(), *Options);
  Printer->setPrefix("tpcc");
  Engine.setClient(Printer);
  ProcessWarningOptions(Engine, *Options, *vfs::getRealFileSystem(),
                        /*ReportDiags=*/false);
}

static int reportFailure(Error Failure) {
  errs() << "tpcc: error: " << toString(std::move(Failure)) << '\n';
  return 1;
}

// --print-fp.
static int printFloatingPoint(const FloatingPointResolver &Resolver,
                              ArrayRef<CommandLineOption> Options) {
  auto Decisions = decideFloatingPoint(Resolver, Options);
  if (!Decisions)
    return reportFailure(createStringError(
        "clang's front end refuses these options; compile to see why"));
  printFloatingPointTable(outs(), *Decisions, Options);
  return 0;
}

// What the optimizer and the code generator cannot do ends the run.
[[noreturn]] static void exitOnFatalError(void *, const char *Message, bool) {
  errs() << "tpcc: error: " << Message << '\n';
  sys::RunInterruptHandlers();
  if (CrashRecoveryContext *Guard = CrashRecoveryContext::GetCurrent()) {
    Guard->DumpStackAndCleanupOnFailure = false;
    Guard->HandleExit(JobRunner::FatalErrorStatus);
  }
  sys::Process::Exit(1);
}

// \returns the exit status.
static int runJobs(Compilation &Jobs, const JobPlan &Plan,
                   const ArgList &UserArguments,
                   ArrayRef<CommandLineOption> Given,
                   const WarningOptions &Warnings,
                   const std::string &ToolPath) {
  using Outcome = JobRunner::Outcome;
  const Sysroot Folders(ToolPath);
  const ReproducerLevel Level = reproducerLevel(UserArguments);
  JobRunner Runner(Jobs, Plan, ToolPath, Folders, Warnings);
  const Outcome Result = Runner.runAll(UserArguments.hasArg(OPT_v));
  Jobs.CleanupFileList(Jobs.getTempFiles());
  DiagnosticsEngine &Diags = Jobs.getDriver().getDiags();
  bool IsReproduced = Level == ReproducerLevel::Always;
  if (IsReproduced) {
    Diags.Report(diag::err_drv_force_crash) << /*-gen-reproducer*/ 1;
  } else if (Result == Outcome::Crashed &&
             Runner.crashStatus() != JobRunner::FatalErrorStatus) {
    IsReproduced = Level != ReproducerLevel::Off;
  } else if (Result != Outcome::Succeeded && Level == ReproducerLevel::Error) {
    IsReproduced = true;
    Diags.Report(diag::err_drv_command_failed) << "tpcc" << 1;
  }
  if (IsReproduced)
    writeReproducer(Jobs, Given, ToolPath);
  // What a crash has left is not worth taking apart.
  if (Result == Outcome::Crashed)
    sys::Process::Exit(Runner.crashStatus(), /*NoCleanup=*/true);
  return Result == Outcome::Failed || Diags.hasErrorOccurred();
}

// Does what the translated command line says; \p Given is the user's own.
static int compileAndLink(TranslatedCommandLine &Translated,
                          ArrayRef<CommandLineOption> Given,
                          const std::string &ToolPath,
                          DiagnosticsEngine &Diags) {
  unsigned MissingIndex, MissingCount;
  InputArgList UserArguments =
      getDriverOptTable().ParseArgs(Translated.Words, MissingIndex,
                                    MissingCount, opt::Visibility(ClangOption));
  if (answerQuery(UserArguments, ToolPath))
    return 0;
  if (Error Refused = checkRefusedOptions(UserArguments))
    return reportFailure(std::move(Refused));
  bool DryRun = UserArguments.hasArg(OPT__HASH_HASH_HASH);
  bool Verbose = UserArguments.hasArg(OPT_v);
  bool AnyInput = UserArguments.hasArg(OPT_INPUT);
  if (DryRun || Verbose)
    printVersion(errs(), ToolPath);
  if (Translated.PrintsFloatingPoint && !AnyInput)
    append_range(Translated.Words,
                 ArrayRef<const char *>{"-fsyntax-only", "-x", "c++", "-"});
  else if (Verbose && !AnyInput)
    return 0;

  clang::driver::Driver TheDriver(ToolPath, llvm::TPTriple, Diags,
                                  "tpcc, compiler for the thread processor");
  TheDriver.Name = "tpcc";
  SmallVector<const char *, 64> AllArguments =
      driverArguments(Translated, UserArguments, ToolPath);
  std::unique_ptr<Compilation> Jobs(TheDriver.BuildCompilation(AllArguments));
  if (!Jobs)
    return Diags.hasErrorOccurred();
  if (Jobs->containsError() || Diags.hasErrorOccurred())
    return 1;

  FloatingPointResolver Resolver(ToolPath);
  if (warnOfFloatingPointFlags(Resolver, Given, Translated.Warnings))
    return 1;
  if (Translated.PrintsFloatingPoint)
    return printFloatingPoint(Resolver, Given);

  Sysroot Folders(ToolPath);
  const JobPlan Plan(*Jobs, isWholeProgram(UserArguments));
  completeJobs(*Jobs, Plan, UserArguments, Translated.WarningWords, Folders,
               ToolPath);
  if (DryRun) {
    if (auto Settings = Resolver.resolve(Given))
      printFloatingPointComment(errs(), *Settings);
    printJobs(*Jobs, Plan);
    Jobs->CleanupFileList(Jobs->getTempFiles());
    return Diags.hasErrorOccurred();
  }
  if (UserArguments.hasArg(OPT_fdriver_only)) {
    if (Verbose)
      printJobs(*Jobs, Plan);
    Jobs->CleanupFileList(Jobs->getTempFiles());
    return Diags.hasErrorOccurred();
  }
  return runJobs(*Jobs, Plan, UserArguments, Given, Translated.Warnings,
                 ToolPath);
}

// The environment's edits of the command line.
static void applyOverrides(SmallVectorImpl<const char *> &Arguments,
                           StringSet<> &EditedWords) {
  static constexpr char Variable[] = "CCC_OVERRIDE_OPTIONS";
  const char *Edits = ::getenv(Variable);
  if (!Edits)
    return;
  Arguments.insert(Arguments.begin(), "tpcc");
  applyOverrideOptions(Arguments, Edits, EditedWords, Variable, &errs());
  Arguments.erase(Arguments.begin());
}

// The linker's messages and the driver's own are colored like clang's.
static void setColors(const DiagnosticOptions &Options) {
  static bool AreOn;
  AreOn = Options.ShowColors;
  errs().enable_colors(AreOn);
  WithColor::setAutoDetectFunction([](const raw_ostream &) { return AreOn; });
}

int runDriver(ArrayRef<const char *> CommandLine, void *MainAddress) {
  ScopedFatalErrorHandler FatalErrors(exitOnFatalError);
  setBugReportMsg("This is a bug of tpcc.\n");
  SmallVector<const char *, 64> Arguments(CommandLine.drop_front());
  BumpPtrAllocator Strings;
  if (Error Failure =
          expandResponseFiles(Arguments, /*ClangCLMode=*/false, Strings))
    return reportFailure(std::move(Failure));
  // Response files may have brought in line-end markers.
  llvm::erase(Arguments, nullptr);
  std::string ToolPath =
      sys::fs::getMainExecutable(CommandLine.front(), MainAddress);
  if (isInternalTool(Arguments)) {
    DriverDiagnostics Diags(ToolPath, Arguments);
    return runInternalTool(Arguments, ToolPath, Diags.Engine);
  }

  StringSet<> EditedWords;
  applyOverrides(Arguments, EditedWords);
  CrashRecoveryContext::Enable();
  std::vector<CommandLineOption> Given = splitCommandLine(Arguments);
  Expected<TranslatedCommandLine> Translated = translateOwnOptions(Arguments);
  if (!Translated)
    return reportFailure(Translated.takeError());
  DriverDiagnostics Diags(ToolPath, Translated->Words);
  setColors(*Diags.Options);
  return compileAndLink(*Translated, Given, ToolPath, Diags.Engine);
}

} // namespace tp
