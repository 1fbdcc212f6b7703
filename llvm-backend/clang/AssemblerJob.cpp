//===- AssemblerJob.cpp - One run of the assembler ------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/AssemblerJob.h"
#include "llvm-backend/MachineCode/MachineCode.h"
#include "llvm-backend/TPDataLayout.h"
#include "llvm-backend/clang/FrontendJob.h"
#include "clang/Basic/DiagnosticDriver.h"
#include "clang/Basic/DiagnosticFrontend.h"
#include "clang/Options/OptionUtils.h"
#include "clang/Options/Options.h"
#include "llvm/ADT/StringExtras.h"
#include "llvm/ADT/StringSwitch.h"
#include "llvm/Option/ArgList.h"
#include "llvm/Option/OptTable.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/MemoryBuffer.h"
#include "llvm/Support/SourceMgr.h"
#include "llvm/Support/ToolOutputFile.h"

using namespace clang;
using namespace clang::options;
using namespace llvm;
using namespace llvm::opt;

namespace tp {

static bool reportBadArguments(const InputArgList &Arguments,
                               unsigned MissingIndex, unsigned MissingCount,
                               DiagnosticsEngine &Diags) {
  if (MissingCount)
    Diags.Report(diag::err_drv_missing_argument)
        << Arguments.getArgString(MissingIndex) << MissingCount;
  for (const Arg *Unknown : Arguments.filtered(OPT_UNKNOWN))
    Diags.Report(diag::err_drv_unknown_argument)
        << Unknown->getAsString(Arguments);
  return Diags.hasErrorOccurred();
}

static void setDebugOptions(MachineCode &Code, const InputArgList &Arguments,
                            StringRef InputName, StringRef InputText,
                            DiagnosticsEngine &Diags) {
  MCContext &Context = Code.Context;
  Context.setDwarfVersion(
      clang::getLastArgIntValue(Arguments, OPT_dwarf_version_EQ, 5, Diags));
  if (const Arg *Folder = Arguments.getLastArg(OPT_ffile_compilation_dir_EQ,
                                               OPT_fdebug_compilation_dir_EQ))
    Context.setCompilationDir(Folder->getValue());
  for (StringRef Map : Arguments.getAllArgValues(OPT_fdebug_prefix_map_EQ)) {
    auto [From, To] = Map.split('=');
    Context.addDebugPrefixMapEntry(From.str(), To.str());
  }
  if (const Arg *Name = Arguments.getLastArg(OPT_main_file_name))
    Context.setMainFileName(Name->getValue());
  if (const Arg *Producer = Arguments.getLastArg(OPT_dwarf_debug_producer))
    Context.setDwarfDebugProducer(Producer->getValue());
  if (Arguments.hasArg(OPT_debug_info_kind_EQ))
    Code.describeLines(InputName, InputText);
}

static DebugCompressionType readCompression(const InputArgList &Arguments) {
  StringRef Kind = Arguments.hasArg(OPT_compress_debug_sections) ? "zlib" : "";
  return StringSwitch<DebugCompressionType>(
             Arguments.getLastArgValue(OPT_compress_debug_sections_EQ, Kind))
      .Case("zlib", DebugCompressionType::Zlib)
      .Case("zstd", DebugCompressionType::Zstd)
      .Default(DebugCompressionType::None);
}

static bool defineSymbols(MCContext &Context, MCStreamer &Streamer,
                          const InputArgList &Arguments,
                          DiagnosticsEngine &Diags) {
  for (StringRef Definition : Arguments.getAllArgValues(OPT_defsym)) {
    auto [Name, Text] = Definition.split('=');
    int64_t Value;
    if (Text.getAsInteger(0, Value)) {
      Diags.Report(diag::err_drv_defsym_invalid_symval) << Text;
      return false;
    }
    Context.setSymbolValue(Streamer, Name, Value);
  }
  return true;
}

bool runAssembler(ArrayRef<const char *> CommandLine,
                  DiagnosticsEngine &Diags) {
  unsigned MissingIndex, MissingCount;
  InputArgList Arguments = getDriverOptTable().ParseArgs(
      CommandLine, MissingIndex, MissingCount, opt::Visibility(CC1AsOption));
  if (reportBadArguments(Arguments, MissingIndex, MissingCount, Diags))
    return false;
  setBackendOptions(Arguments.getAllArgValues(OPT_mllvm));

  StringRef TargetTriple = Arguments.getLastArgValue(OPT_triple, TPTriple);
  if (TargetTriple != TPTriple) {
    Diags.Report(diag::err_target_unknown_triple) << TargetTriple;
    return false;
  }

  std::string InputName = Arguments.getLastArgValue(OPT_INPUT, "-").str();
  ErrorOr<std::unique_ptr<MemoryBuffer>> Input =
      MemoryBuffer::getFileOrSTDIN(InputName, /*IsText=*/true);
  if (std::error_code Failure = Input.getError()) {
    Diags.Report(diag::err_fe_error_reading) << InputName << Failure.message();
    return false;
  }
  SourceMgr Sources;
  StringRef InputText = (*Input)->getBuffer();
  Sources.AddNewSourceBuffer(std::move(*Input), SMLoc());
  Sources.setIncludeDirs(Arguments.getAllArgValues(OPT_I));

  MCTargetOptions Options;
  Options.AsmVerbose = true;
  Options.MCNoWarn = Arguments.hasArg(OPT_massembler_no_warn);
  Options.MCFatalWarnings = Arguments.hasArg(OPT_massembler_fatal_warnings);
  Options.MCSaveTempLabels = Arguments.hasArg(OPT_msave_temp_labels);
  Options.CompressDebugSections = readCompression(Arguments);
  Options.MCUseDwarfDirectory = MCTargetOptions::EnableDwarfDirectory;

  MachineCode Code(
      &Sources, Options, Arguments.getLastArgValue(OPT_target_cpu),
      llvm::join(Arguments.getAllArgValues(OPT_target_feature), ","));
  setDebugOptions(Code, Arguments, InputName, InputText, Diags);

  std::string OutputName = Arguments.getLastArgValue(OPT_o, "-").str();
  std::error_code OpenFailure;
  ToolOutputFile Output(OutputName, OpenFailure, sys::fs::OF_None);
  if (OpenFailure) {
    Diags.Report(diag::err_fe_unable_to_open_output)
        << OutputName << OpenFailure.message();
    return false;
  }
  SmallString<0> ObjectText;
  raw_svector_ostream ObjectStream(ObjectText);

  std::unique_ptr<MCStreamer> Streamer =
      Code.createObjectStreamer(ObjectStream);
  Streamer->initSections(/*NoExecStack=*/false, *Code.Subtarget);
  if (!defineSymbols(Code.Context, *Streamer, Arguments, Diags) ||
      !Code.assemble(Sources, *Streamer))
    return false;
  Output.os() << ObjectText;
  Output.keep();
  return true;
}

} // namespace tp
