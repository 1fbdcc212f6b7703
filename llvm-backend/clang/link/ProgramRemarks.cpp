//===- ProgramRemarks.cpp - What LLVM says of the program -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/link/ProgramRemarks.h"
#include "llvm-backend/clang/link/AssemblyMessages.h"
#include "llvm-backend/clang/link/FunctionPlaces.h"
#include "llvm/Demangle/Demangle.h"
#include "llvm/IR/DiagnosticPrinter.h"
#include "llvm/Support/FileSystem.h"

using namespace llvm;

namespace tp {

static constexpr const char SilentAttribute[] = "tp-no-remarks";

void silenceRemarks(Function &F) { F.addFnAttr(SilentAttribute); }

// The front end has refused patterns that are none.
static std::optional<Regex> compile(const std::string &Pattern) {
  if (Pattern.empty())
    return std::nullopt;
  return Regex(Pattern);
}

ProgramRemarks::ProgramRemarks(const llvm::Module &Program,
                               LinkDiagnostics &Diags,
                               const RemarkPatterns &Patterns)
    : Program(Program), Diags(Diags), Passed(compile(Patterns.Passed)),
      Missed(compile(Patterns.Missed)), Analysis(compile(Patterns.Analysis)) {}

bool ProgramRemarks::isPassedOptRemarkEnabled(StringRef Pass) const {
  return Passed && Passed->match(Pass);
}

bool ProgramRemarks::isMissedOptRemarkEnabled(StringRef Pass) const {
  return Missed && Missed->match(Pass);
}

bool ProgramRemarks::isAnalysisRemarkEnabled(StringRef Pass) const {
  return Analysis && Analysis->match(Pass);
}

bool ProgramRemarks::isAnyRemarkEnabled() const {
  return Passed || Missed || Analysis;
}

static SourcePlace placeOf(const DiagnosticInfoWithLocationBase &Info) {
  if (!Info.isLocationAvailable())
    return functionPlace(Info.getFunction()).Place;
  StringRef File;
  SourcePlace Place;
  Info.getLocation(File, Place.Line, Place.Column);
  // Clang's debug data splits a path where the folder of the compilation ends.
  Place.File = sys::fs::exists(File) ? File.str() : Info.getAbsolutePath();
  return Place;
}

void ProgramRemarks::reportRemark(
    const DiagnosticInfoOptimizationBase &Remark) {
  if (!Remark.isEnabled() ||
      Remark.getFunction().hasFnAttribute(SilentAttribute))
    return;
  const char *Option = Remark.isPassed()   ? "-Rpass="
                       : Remark.isMissed() ? "-Rpass-missed="
                                           : "-Rpass-analysis=";
  Diags.report(SourceMgr::DK_Remark, placeOf(Remark),
               Remark.getMsg() + " [" + Option + Remark.getPassName() + "]");
}

void ProgramRemarks::reportFrame(const DiagnosticInfoStackSize &Frame) {
  const FunctionPlace Known = functionPlace(Frame.getFunction());
  const bool IsError = Known.IsFrameLimitAnError;
  Diags.report(IsError ? SourceMgr::DK_Error : SourceMgr::DK_Warning,
               Known.Place,
               "stack frame size (" + Twine(Frame.getStackSize()) +
                   ") exceeds limit (" + Twine(Frame.getStackLimit()) +
                   ") in '" + demangle(Frame.getFunction().getName()) + "' [" +
                   (IsError ? "-Werror," : "") + "-Wframe-larger-than]");
}

bool ProgramRemarks::handleDiagnostics(const DiagnosticInfo &Info) {
  if (const auto *Frame = dyn_cast<DiagnosticInfoStackSize>(&Info)) {
    reportFrame(*Frame);
    return true;
  }
  if (const auto *Failure = dyn_cast<DiagnosticInfoOptimizationFailure>(&Info))
    if (Failure->getSeverity() == DS_Warning) {
      Diags.report(SourceMgr::DK_Warning, placeOf(*Failure),
                   Failure->getMsg() +
                       " [-Wpass-failed=" + Failure->getPassName() + "]");
      return true;
    }
  if (const auto *Remark = dyn_cast<DiagnosticInfoOptimizationBase>(&Info)) {
    reportRemark(*Remark);
    return true;
  }
  if (reportAssemblyMessage(Info, Program, Diags))
    return true;
  std::string Message;
  raw_string_ostream Stream(Message);
  DiagnosticPrinterRawOStream Printer(Stream);
  Info.print(Printer);
  if (Info.getSeverity() == DS_Error)
    Diags.error(Message);
  else if (Info.getSeverity() == DS_Warning)
    Diags.warning(Message);
  return true;
}

} // namespace tp
