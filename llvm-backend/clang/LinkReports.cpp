//===- LinkReports.cpp - Options for the reports of the link --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/LinkReports.h"
#include "clang/Options/Options.h"
#include "llvm/Support/Path.h"

using namespace clang::options;
using namespace llvm;
using namespace llvm::opt;

namespace tp {

// `-R<name>` and `-Rno-<name>` switch all passes on and off. The last counts.
static std::string readPattern(const ArgList &Arguments, OptSpecifier WithValue,
                               StringRef Name) {
  std::string Pattern;
  for (const Arg *Given : Arguments) {
    if (Given->getOption().matches(WithValue)) {
      Pattern = Given->getValue();
    } else if (Given->getOption().matches(OPT_R_Joined)) {
      StringRef Word = Given->getValue();
      const bool IsNegative = Word.consume_front("no-");
      if (Word == Name || Word == "everything")
        Pattern = IsNegative ? "" : ".*";
    }
  }
  return Pattern;
}

// The names are those that clang's driver gives to the linkers that it knows.
static void readRecord(const ArgList &Arguments, StringRef OutputPath,
                       ProgramReports &Reports) {
  if (!Arguments.hasFlag(OPT_fsave_optimization_record,
                         OPT_fno_save_optimization_record, false) &&
      !Arguments.hasArg(OPT_fsave_optimization_record_EQ,
                        OPT_foptimization_record_file_EQ,
                        OPT_foptimization_record_passes_EQ))
    return;
  Reports.RecordFormat =
      Arguments.getLastArgValue(OPT_fsave_optimization_record_EQ, "yaml");
  Reports.RecordPasses =
      Arguments.getLastArgValue(OPT_foptimization_record_passes_EQ);
  StringRef Path =
      Arguments.getLastArgValue(OPT_foptimization_record_file_EQ, OutputPath);
  Reports.RecordPath = (Path + ".opt.ld." + Reports.RecordFormat).str();
}

ProgramReports readProgramReports(const ArgList &Arguments,
                                  StringRef OutputPath) {
  ProgramReports Reports;
  Reports.Remarks = {
      readPattern(Arguments, OPT_Rpass_EQ, "pass"),
      readPattern(Arguments, OPT_Rpass_missed_EQ, "pass-missed"),
      readPattern(Arguments, OPT_Rpass_analysis_EQ, "pass-analysis")};
  readRecord(Arguments, OutputPath, Reports);
  if (Arguments.hasArg(OPT_fstack_usage))
    Reports.StackUsagePath = (OutputPath + ".su").str();
  if (const Arg *Save = Arguments.getLastArg(OPT_save_temps_EQ))
    Reports.TemporariesPath =
        (StringRef(Save->getValue()) == "obj" ? OutputPath
                                              : sys::path::filename(OutputPath))
            .str();
  return Reports;
}

TimeTrace::Settings readTimeTrace(const ArgList &Arguments,
                                  StringRef OutputPath) {
  TimeTrace::Settings Settings;
  if (!Arguments.hasArg(OPT_ftime_trace, OPT_ftime_trace_EQ))
    return Settings;
  Settings.Path = (OutputPath + ".time-trace").str();
  // The front end has refused what is no number.
  Arguments.getLastArgValue(OPT_ftime_trace_granularity_EQ)
      .getAsInteger(10, Settings.Granularity);
  Settings.IsVerbose = Arguments.hasArg(OPT_ftime_trace_verbose);
  return Settings;
}

} // namespace tp
