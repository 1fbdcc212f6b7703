//===- JobRunner.cpp - Runs the jobs of one compilation -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/JobRunner.h"
#include "llvm-backend/clang/AssemblerJob.h"
#include "llvm-backend/clang/FrontendJob.h"
#include "clang/Basic/DiagnosticDriver.h"
#include "clang/Basic/DiagnosticFrontend.h"
#include "clang/Driver/Driver.h"
#include "llvm/Bitcode/BitcodeWriter.h"
#include "llvm/Support/CrashRecoveryContext.h"
#include "llvm/Support/FileSystem.h"

using namespace clang;
using namespace clang::driver;
using namespace llvm;

namespace tp {

namespace {
enum class JobKind { Frontend, Assembler, Link };
} // namespace

static JobKind kindOf(const Command &Job) {
  if (isa<LinkJobAction>(Job.getSource()))
    return JobKind::Link;
  return StringRef(Job.getArguments().front()) == "-cc1as" ? JobKind::Assembler
                                                           : JobKind::Frontend;
}

static const char *nameOf(JobKind Kind) {
  switch (Kind) {
  case JobKind::Frontend:
    return "frontend";
  case JobKind::Assembler:
    return "assembler";
  case JobKind::Link:
    return "linker";
  }
  return "";
}

bool JobRunner::dependsOnFailure(const Command &Job) const {
  return any_of(Job.getInputInfos(), [&](const InputInfo &Input) {
    return Input.isFilename() && MissingOutputs.contains(Input.getFilename());
  });
}

// What -save-temps keeps.
static bool writeBitcode(const llvm::Module &Unit, StringRef Path,
                         DiagnosticsEngine &Diags) {
  std::error_code Failure;
  raw_fd_ostream File(Path, Failure, sys::fs::OF_None);
  if (Failure) {
    Diags.Report(diag::err_fe_unable_to_open_output)
        << Path << Failure.message();
    return false;
  }
  WriteBitcodeToFile(Unit, File);
  return true;
}

bool JobRunner::compile(const Command &Job) {
  ArrayRef<const char *> Arguments(Job.getArguments());
  Arguments = Arguments.drop_front();
  if (!Plan.isUnit(Job))
    return runFrontend(Arguments, ToolPath.c_str());
  std::unique_ptr<llvm::Module> Unit =
      compileToModule(Arguments, ToolPath.c_str(), Link.context());
  if (!Unit)
    return false;
  StringRef Output = Job.getOutputFilenames().front();
  const bool IsTemporary = is_contained(Jobs.getTempFiles(), Output);
  if (!IsTemporary && !writeBitcode(*Unit, Output, Jobs.getDriver().getDiags()))
    return false;
  Link.addUnit(Output, std::move(Unit));
  return true;
}

bool JobRunner::run(const Command &Job) {
  switch (kindOf(Job)) {
  case JobKind::Frontend:
    return compile(Job);
  case JobKind::Assembler:
    return runAssembler(ArrayRef(Job.getArguments()).drop_front(),
                        Jobs.getDriver().getDiags());
  case JobKind::Link:
    return Link.run(Job);
  }
  return false;
}

JobRunner::Outcome JobRunner::runSafely(const Command &Job) {
  CrashRecoveryContext Guard;
  Guard.DumpStackAndCleanupOnFailure = true;
  bool Succeeded = false;
  if (Guard.RunSafely([&] { Succeeded = run(Job); }))
    return Succeeded ? Outcome::Succeeded : Outcome::Failed;
  CrashStatus = Guard.RetCode;
  if (CrashStatus == FatalErrorStatus)
    return Outcome::Crashed;
  Jobs.getDriver().getDiags().Report(diag::err_drv_command_failed)
      << (Twine("tpcc ") + nameOf(kindOf(Job))).str() << CrashStatus;
  return Outcome::Crashed;
}

JobRunner::Outcome JobRunner::runAll(bool Verbose) {
  Outcome Total = Outcome::Succeeded;
  for (const Command &Job : Jobs.getJobs()) {
    if (Plan.isDropped(Job))
      continue;
    if (Verbose)
      Job.Print(errs(), "\n", /*Quote=*/false);
    const Outcome Own =
        dependsOnFailure(Job) ? Outcome::Failed : runSafely(Job);
    if (Own == Outcome::Succeeded)
      continue;
    Total = Own;
    for (const std::string &Output : Job.getOutputFilenames())
      MissingOutputs.insert(Output);
    const auto *Action = cast<JobAction>(&Job.getSource());
    Jobs.CleanupFileMap(Jobs.getResultFiles(), Action, /*IssueErrors=*/true);
    if (Own == Outcome::Crashed)
      break;
  }
  return Total;
}

} // namespace tp
