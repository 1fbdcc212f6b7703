//===- FrontendJob.cpp - One clang front end run --------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/FrontendJob.h"
#include "llvm-backend/TPDataLayout.h"
#include "llvm-backend/clang/ClangTargetInfo.h"
#include "llvm-backend/clang/TimeReports.h"
#include "llvm-backend/clang/link/AssemblyMessages.h"
#include "llvm-backend/clang/link/FunctionPlaces.h"
#include "clang/AST/Decl.h"
#include "clang/Basic/DiagnosticFrontend.h"
#include "clang/CodeGen/CodeGenAction.h"
#include "clang/CodeGen/ModuleBuilder.h"
#include "clang/Frontend/CompilerInstance.h"
#include "clang/Frontend/CompilerInvocation.h"
#include "clang/Frontend/TextDiagnosticBuffer.h"
#include "clang/FrontendTool/Utils.h"
#include "llvm/ADT/Statistic.h"
#include "llvm/Support/CommandLine.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/TimeProfiler.h"
#include "llvm/Support/Timer.h"

using namespace clang;
using namespace llvm;

namespace tp {

void setBackendOptions(ArrayRef<std::string> Options) {
  cl::ResetAllOptionOccurrences();
  if (Options.empty())
    return;
  std::vector<const char *> Arguments{"tpcc (LLVM option parsing)"};
  for (const std::string &Option : Options)
    Arguments.push_back(Option.c_str());
  cl::ParseCommandLineOptions(Arguments.size(), Arguments.data());
}

// Clang does that for the targets that it knows.
static void describeCallSites(CodeGenOptions &Options) {
  if (Options.OptimizationLevel > 0 && Options.hasReducedDebugInfo())
    Options.EmitCallSiteInfo = true;
}

// Prints to \p Client, or as the arguments say if it is null.
static std::unique_ptr<CompilerInstance>
createInstance(ArrayRef<const char *> Arguments, const char *ToolPath,
               DiagnosticConsumer *Client = nullptr) {
  auto Invocation = std::make_shared<CompilerInvocation>();
  DiagnosticOptions ArgumentDiagnosticOptions;
  TextDiagnosticBuffer ArgumentDiagnostics;
  DiagnosticsEngine ArgumentEngine(
      DiagnosticIDs::create(), ArgumentDiagnosticOptions, &ArgumentDiagnostics,
      /*ShouldOwnClient=*/false);
  bool ArgumentsAreValid = CompilerInvocation::CreateFromArgs(
      *Invocation, Arguments, ArgumentEngine, ToolPath);

  // Clang writes the triple with all its parts; the code generator's tests and
  // the user's IR do not.
  Invocation->getTargetOpts().Triple = llvm::TPTriple;
  // Several jobs share this process: each has to give back what it takes.
  Invocation->getFrontendOpts().DisableFree = false;
  Invocation->getCodeGenOpts().DisableFree = false;

  describeCallSites(Invocation->getCodeGenOpts());

  auto Instance = std::make_unique<CompilerInstance>(std::move(Invocation));
  Instance->createVirtualFileSystem();
  Instance->createDiagnostics(Client);
  if (!Instance->hasDiagnostics())
    return nullptr;
  ArgumentDiagnostics.FlushDiagnostics(Instance->getDiagnostics());
  if (!ArgumentsAreValid) {
    Instance->getDiagnosticClient().finish();
    return nullptr;
  }
  for (const FrontendInputFile &Input : Instance->getFrontendOpts().Inputs)
    if (Input.getKind().getFormat() == InputKind::Precompiled) {
      DiagnosticsEngine &Diags = Instance->getDiagnostics();
      Diags.Report(
          Diags.getCustomDiagID(DiagnosticsEngine::Error,
                                "'%0' is a syntax tree, which tpcc does not "
                                "compile; give it the source"))
          << Input.getFile();
      Instance->getDiagnosticClient().finish();
      return nullptr;
    }
  Instance->createFileManager();
  return Instance;
}

// CompilerInstance::createTarget with the TP in the place of clang's own
// targets.
static bool createTarget(CompilerInstance &Instance) {
  auto Target = createClangTargetInfo(Instance.getDiagnostics(),
                                      Instance.getTargetOpts());
  if (!Target)
    return false;
  Instance.setTarget(Target.get());
  if (!Target->hasStrictFP() && !Instance.getLangOpts().ExpStrictFP) {
    if (Instance.getLangOpts().RoundingMath) {
      Instance.getDiagnostics().Report(
          diag::warn_fe_backend_unsupported_fp_rounding);
      Instance.getLangOpts().RoundingMath = false;
    }
    auto Exceptions = Instance.getLangOpts().getFPExceptionMode();
    if (Exceptions != LangOptions::FPE_Ignore &&
        Exceptions != LangOptions::FPE_Default) {
      Instance.getDiagnostics().Report(
          diag::warn_fe_backend_unsupported_fp_exceptions);
      Instance.getLangOpts().setFPExceptionMode(LangOptions::FPE_Ignore);
    }
  }
  Target->adjust(Instance.getDiagnostics(), Instance.getLangOpts(),
                 /*Aux=*/nullptr);
  return true;
}

// CompilerInstance::ExecuteAction with createTarget from above.
static bool execute(CompilerInstance &Instance, FrontendAction &Action) {
  bool Prepared = Action.PrepareToExecute(Instance) && createTarget(Instance);
  if (Prepared) {
    for (const FrontendInputFile &Input : Instance.getFrontendOpts().Inputs) {
      if (Instance.hasSourceManager() && !Action.isModelParsingAction())
        Instance.getSourceManager().clearIDTables();
      if (!Action.BeginSourceFile(Instance, Input))
        continue;
      // Execute has reported every error that it returns.
      if (llvm::Error Failure = Action.Execute())
        consumeError(std::move(Failure));
      Action.EndSourceFile();
    }
    Instance.printDiagnosticStats();
  }
  Instance.getDiagnosticClient().finish();
  return Prepared && !Instance.getDiagnostics().getClient()->getNumErrors();
}

// -print-stats and -save-stats.
static void writeStatistics(CompilerInstance &Instance) {
  const FrontendOptions &Options = Instance.getFrontendOpts();
  if (Options.ShowStats)
    PrintStatistics(errs());
  if (Options.StatsFile.empty())
    return;
  std::error_code Failure;
  raw_fd_ostream File(Options.StatsFile, Failure,
                      Options.AppendStats
                          ? sys::fs::OF_TextWithCRLF | sys::fs::OF_Append
                          : sys::fs::OF_TextWithCRLF);
  if (Failure)
    Instance.getDiagnostics().Report(diag::warn_fe_unable_to_open_stats_file)
        << Options.StatsFile << Failure.message();
  else
    PrintStatisticsJSON(File);
}

// Executes Action and writes what the options want to know about the run.
static bool executeAndReport(CompilerInstance &Instance,
                             FrontendAction &Action) {
  const FrontendOptions &Options = Instance.getFrontendOpts();
  TimeTrace Trace({Options.TimeTracePath, Options.TimeTraceGranularity,
                   Options.TimeTraceVerbose != 0});
  if (Options.ShowStats || !Options.StatsFile.empty())
    EnableStatistics(/*DoPrintOnExit=*/false);
  const bool IsTimed = Instance.getCodeGenOpts().TimePasses;
  bool Succeeded;
  {
    TimeTraceScope Scope("ExecuteCompiler");
    if (IsTimed)
      Instance.createFrontendTimer();
    TimeRegion Region(IsTimed ? &Instance.getFrontendTimer() : nullptr);
    Succeeded = execute(Instance, Action);
  }
  writeStatistics(Instance);
  if (IsTimed)
    printTimeReport();
  return Succeeded;
}

std::unique_ptr<CompilerInstance>
interpretArguments(ArrayRef<const char *> Arguments, const char *ToolPath) {
  auto Instance = createInstance(Arguments, ToolPath, new IgnoringDiagConsumer);
  if (!Instance || !createTarget(*Instance))
    return nullptr;
  return Instance;
}

bool runFrontend(ArrayRef<const char *> Arguments, const char *ToolPath) {
  auto Instance = createInstance(Arguments, ToolPath);
  if (!Instance)
    return false;
  setBackendOptions(Instance->getFrontendOpts().LLVMArgs);
  Instance->LoadRequestedPlugins();
  if (Instance->getDiagnostics().hasErrorOccurred())
    return false;
  std::unique_ptr<FrontendAction> Action = CreateFrontendAction(*Instance);
  return Action && executeAndReport(*Instance, *Action);
}

namespace {

/// Compiles to a module for the link and tells it what only the front end knows
/// of the functions.
class UnitAction final : public EmitLLVMOnlyAction {
public:
  using EmitLLVMOnlyAction::EmitLLVMOnlyAction;

private:
  void EndSourceFileAction() override;
  void describe(Function &F, SourceLocation Location);
};

} // namespace

static SourcePlace presumedPlace(const CompilerInstance &Instance,
                                 SourceLocation Location) {
  const PresumedLoc Place =
      Instance.getSourceManager().getPresumedLoc(Location);
  if (!Place.isValid())
    return {};
  return {Place.getFilename(), Place.getLine(), Place.getColumn()};
}

void UnitAction::describe(Function &F, SourceLocation Location) {
  const CompilerInstance &Instance = getCompilerInstance();
  const DiagnosticsEngine &Diags = Instance.getDiagnostics();
  const DiagnosticsEngine::Level Level =
      Diags.getDiagnosticLevel(diag::warn_fe_frame_larger_than, Location);
  if (Level == DiagnosticsEngine::Ignored)
    F.removeFnAttr("warn-stack-size");
  const SourcePlace Place = presumedPlace(Instance, Location);
  if (!Place.File.empty())
    setFunctionPlace(F, {Place, Level == DiagnosticsEngine::Error});
}

void UnitAction::EndSourceFileAction() {
  // IR comes without declarations.
  if (getCurrentFileKind().getLanguage() != Language::LLVM_IR)
    if (CodeGenerator *Generator = getCodeGenerator())
      if (llvm::Module *Unit = Generator->GetModule()) {
        setAssemblyPlaces(*Unit, [&](uint64_t Location) {
          return presumedPlace(
              getCompilerInstance(),
              SourceLocation::getFromRawEncoding(
                  static_cast<SourceLocation::UIntTy>(Location)));
        });
        for (Function &F : *Unit)
          if (!F.isDeclaration())
            if (const Decl *Source =
                    Generator->GetDeclForMangledName(F.getName()))
              describe(F, Source->getLocation());
      }
  EmitLLVMOnlyAction::EndSourceFileAction();
}

std::unique_ptr<llvm::Module> compileToModule(ArrayRef<const char *> Arguments,
                                              const char *ToolPath,
                                              LLVMContext &Context) {
  auto Instance = createInstance(Arguments, ToolPath);
  if (!Instance)
    return nullptr;
  setBackendOptions(Instance->getFrontendOpts().LLVMArgs);
  // Textual IR cannot be read without its names.
  bool IsIr = any_of(
      Instance->getFrontendOpts().Inputs, [](const FrontendInputFile &Input) {
        return Input.getKind().getLanguage() == Language::LLVM_IR;
      });
  Context.setDiscardValueNames(Instance->getCodeGenOpts().DiscardValueNames &&
                               !IsIr);
  // Places of declarations are wanted after the module is made.
  Instance->getCodeGenOpts().ClearASTBeforeBackend = false;
  UnitAction Action(&Context);
  if (!executeAndReport(*Instance, Action))
    return nullptr;
  return Action.takeModule();
}

} // namespace tp
