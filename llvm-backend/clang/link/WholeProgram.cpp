//===- WholeProgram.cpp - Bitcode to one optimized object -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/link/WholeProgram.h"
#include "llvm-backend/FloatingPoint/Check/CheckPass.h"
#include "llvm-backend/TPDataLayout.h"
#include "llvm-backend/clang/link/LibraryFunctions.h"
#include "llvm-backend/clang/link/ProgramRemarks.h"
#include "llvm/Analysis/CGSCCPassManager.h"
#include "llvm/Analysis/LoopAnalysisManager.h"
#include "llvm/Bitcode/BitcodeReader.h"
#include "llvm/Bitcode/BitcodeWriter.h"
#include "llvm/Demangle/Demangle.h"
#include "llvm/IR/DebugInfo.h"
#include "llvm/IR/LLVMRemarkStreamer.h"
#include "llvm/IR/LegacyPassManager.h"
#include "llvm/Linker/Linker.h"
#include "llvm/MC/TargetRegistry.h"
#include "llvm/Object/ModuleSymbolTable.h"
#include "llvm/Passes/PassBuilder.h"
#include "llvm/Passes/StandardInstrumentations.h"
#include "llvm/Support/FileSystem.h"
#include "llvm/Support/TimeProfiler.h"
#include "llvm/Target/TargetMachine.h"
#include "llvm/Target/TargetOptions.h"
#include "llvm/Transforms/IPO/GlobalDCE.h"
#include "llvm/Transforms/IPO/Internalize.h"

using namespace llvm;

namespace tp {

WholeProgram::WholeProgram(LLVMContext &Context, const ProgramReports &Reports,
                           LinkDiagnostics &Diags)
    : Reports(Reports), Diags(Diags),
      Program(std::make_unique<Module>("program", Context)) {
  Context.setDiagnosticHandler(
      std::make_unique<ProgramRemarks>(*Program, Diags, Reports.Remarks));
  Program->setTargetTriple(Triple(TPTriple));
  Program->setDataLayout(TPDataLayout);
}

//===----------------------------------------------------------------------===//
// Linking
//===----------------------------------------------------------------------===//

// The function or variable that uses \p Used; null if nothing does.
static const GlobalValue *firstUser(const Value &Used) {
  for (const User *User : Used.users()) {
    if (const auto *Instruction = dyn_cast<llvm::Instruction>(User))
      return Instruction->getFunction();
    if (const auto *Global = dyn_cast<GlobalValue>(User))
      return Global;
    if (const GlobalValue *Indirect = firstUser(*User))
      return Indirect;
  }
  return nullptr;
}

void WholeProgram::recordSymbols(const Module &Unit, StringRef Name) {
  for (const GlobalValue &Global : Unit.global_values()) {
    if (Global.hasLocalLinkage() || Global.getName().starts_with("llvm."))
      continue;
    if (Global.isDeclaration()) {
      if (const GlobalValue *User = firstUser(Global))
        References.try_emplace(Global.getName(),
                               (Name + ":" + demangle(User->getName())).str());
      continue;
    }
    if (!Global.hasExternalLinkage())
      continue;
    auto [Known, IsNew] = Definitions.try_emplace(Global.getName(), Name.str());
    if (!IsNew)
      Diags.error("duplicate symbol: " + demangle(Global.getName()) +
                  "\n  defined in " + Known->second + "\n  defined in " + Name);
  }
  ModuleSymbolTable::CollectAsmSymbols(
      Unit, [&](StringRef Symbol, object::BasicSymbolRef::Flags) {
        Exported.insert(Symbol);
      });
}

void WholeProgram::link(std::unique_ptr<Module> Unit, StringRef Name,
                        unsigned Flags) {
  Unit->setTargetTriple(Program->getTargetTriple());
  if (Unit->getDataLayout() != Program->getDataLayout()) {
    Diags.error(Name + ": was not compiled for the TP (data layout '" +
                Unit->getDataLayoutStr() + "'); compile it with tpcc");
    return;
  }
  ++Units;
  if (!Diags.hasErrors())
    Linker::linkModules(*Program, std::move(Unit), Flags);
}

void WholeProgram::add(std::unique_ptr<Module> Unit, StringRef Name) {
  recordSymbols(*Unit, Name);
  link(std::move(Unit), Name, Linker::None);
}

// Makes a definition a mere reference.
static void dropDefinition(GlobalValue &Global) {
  if (auto *Function = dyn_cast<llvm::Function>(&Global)) {
    Function->deleteBody();
    Function->setComdat(nullptr);
    return;
  }
  if (auto *Variable = dyn_cast<GlobalVariable>(&Global)) {
    Variable->setInitializer(nullptr);
    Variable->setLinkage(GlobalValue::ExternalLinkage);
    Variable->setComdat(nullptr);
    return;
  }
  // Aliases cannot be declared.
  Module &Unit = *Global.getParent();
  GlobalValue *Declaration;
  if (auto *Type = dyn_cast<FunctionType>(Global.getValueType()))
    Declaration =
        Function::Create(Type, GlobalValue::ExternalLinkage, "", Unit);
  else
    Declaration = new GlobalVariable(Unit, Global.getValueType(),
                                     /*isConstant=*/false,
                                     GlobalValue::ExternalLinkage, nullptr);
  Declaration->takeName(&Global);
  Global.replaceAllUsesWith(Declaration);
  Global.eraseFromParent();
}

// Makes \p Unit refer to what another module defines.
static void declare(const GlobalValue &Definition, Module &Unit) {
  if (Unit.getNamedValue(Definition.getName()))
    return;
  if (auto *Type = dyn_cast<FunctionType>(Definition.getValueType()))
    Function::Create(Type, GlobalValue::ExternalLinkage, Definition.getName(),
                     Unit);
  else
    new GlobalVariable(Unit, Definition.getValueType(), /*isConstant=*/false,
                       GlobalValue::ExternalLinkage, /*Initializer=*/nullptr,
                       Definition.getName(), /*InsertBefore=*/nullptr,
                       Definition.getThreadLocalMode());
}

void WholeProgram::exportSymbols(const StringSet<> &Symbols) {
  Exported.insert_range(Symbols.keys());
}

void WholeProgram::addRuntime(std::unique_ptr<Module> Runtime, StringRef Name,
                              bool FullDebugInfo,
                              const StringMap<std::string> &DefinedElsewhere) {
  SmallVector<GlobalValue *> Replaced;
  for (GlobalValue &Global : Runtime->global_values())
    if (!Global.isDeclaration() && !Global.hasLocalLinkage() &&
        (Definitions.contains(Global.getName()) ||
         DefinedElsewhere.contains(Global.getName())))
      Replaced.push_back(&Global);
  for (GlobalValue *Global : Replaced)
    dropDefinition(*Global);
  // The user's -gdwarf-<n> is for the whole program.
  if (unsigned Version = Program->getDwarfVersion())
    Runtime->setModuleFlag(Module::Max, "Dwarf Version", Version);
  // It uses infinities and NaNs on purpose.
  for (Function &F : *Runtime)
    if (!F.isDeclaration()) {
      F.addFnAttr(UncheckedFunctionAttribute);
      silenceRemarks(F);
    }

  HasRuntime = true;
  Exported.insert_range(
      libraryFunctionsToKeep(*Program, Runtime.get(), Exported).keys());
  for (const GlobalValue &Global : Runtime->global_values())
    if (!Global.isDeclaration() && Exported.contains(Global.getName()))
      declare(Global, *Program);
  if (!FullDebugInfo)
    stripNonLineTableDebugInfo(*Runtime);
  recordSymbols(*Runtime, Name);
  link(std::move(Runtime), Name, Linker::LinkOnlyNeeded);
}

std::string WholeProgram::referenceTo(StringRef Symbol,
                                      StringRef Function) const {
  if (auto Known = References.find(Symbol); Known != References.end())
    return Known->second;
  StringRef Unit = definitionOf(Function);
  return Unit.empty() ? "" : (Unit + ":" + demangle(Function)).str();
}

StringRef WholeProgram::definitionOf(StringRef Symbol) const {
  auto Known = Definitions.find(Symbol);
  return Known == Definitions.end() ? StringRef() : StringRef(Known->second);
}

//===----------------------------------------------------------------------===//
// Compilation
//===----------------------------------------------------------------------===//

void WholeProgram::internalize() {
  if (!HasRuntime)
    Exported.insert_range(
        libraryFunctionsToKeep(*Program, /*Runtime=*/nullptr, Exported).keys());
  internalizeModule(*Program, [&](const GlobalValue &Global) {
    return Exported.contains(Global.getName());
  });
}

void WholeProgram::optimize(OptimizationLevel Level, TargetMachine &Machine) {
  LoopAnalysisManager Loops;
  FunctionAnalysisManager Functions;
  CGSCCAnalysisManager CallGraphs;
  ModuleAnalysisManager Modules;
  // Options that print passes, or count and skip them, work as in clang.
  PassInstrumentationCallbacks Callbacks;
  StandardInstrumentations Instrumentations(Program->getContext(),
                                            /*DebugLogging=*/false);
  Instrumentations.registerCallbacks(Callbacks, &Modules);
  PassBuilder Builder(&Machine, PipelineTuningOptions(), std::nullopt,
                      &Callbacks);
  Builder.registerModuleAnalyses(Modules);
  Builder.registerCGSCCAnalyses(CallGraphs);
  Builder.registerFunctionAnalyses(Functions);
  Builder.registerLoopAnalyses(Loops);
  Builder.crossRegisterProxies(Loops, Functions, CallGraphs, Modules);

  ModulePassManager Passes;
  if (Level == OptimizationLevel::O0) {
    Passes.addPass(Builder.buildO0DefaultPipeline(Level));
    Passes.addPass(GlobalDCEPass());
  } else {
    Passes.addPass(
        Builder.buildLTODefaultPipeline(Level, /*ExportSummary=*/nullptr));
  }
  Passes.run(*Program, Modules);
}

static CodeGenOptLevel codeGenLevel(OptimizationLevel Level) {
  switch (Level.getSpeedupLevel()) {
  case 0:
    return CodeGenOptLevel::None;
  case 1:
    return CodeGenOptLevel::Less;
  case 2:
    return CodeGenOptLevel::Default;
  default:
    return CodeGenOptLevel::Aggressive;
  }
}

static std::unique_ptr<TargetMachine> createMachine(OptimizationLevel Level) {
  TargetOptions Options;
  // The linker keeps or drops each function and each object on its own.
  Options.FunctionSections = true;
  Options.DataSections = true;
  Options.UseInitArray = true;
  // Debuggers find there what a caller passed.
  Options.EmitCallSiteInfo = Level != OptimizationLevel::O0;
  std::string LookupError;
  Triple TargetTriple(TPTriple);
  const Target *TheTarget =
      TargetRegistry::lookupTarget(TargetTriple, LookupError);
  if (!TheTarget)
    report_fatal_error(Twine(LookupError));
  return std::unique_ptr<TargetMachine>(TheTarget->createTargetMachine(
      TargetTriple, /*CPU=*/"", /*Features=*/"", Options, Reloc::Static,
      CodeModel::Small, codeGenLevel(Level)));
}

static void emit(Module &Program, TargetMachine &Machine,
                 raw_pwrite_stream &Stream, CodeGenFileType Kind) {
  legacy::PassManager Passes;
  if (Machine.addPassesToEmitFile(Passes, Stream, /*DwoOut=*/nullptr, Kind))
    report_fatal_error("the code generator cannot write the program");
  Passes.run(Program);
}

// Writes what Print prints to a file of -save-temps.
static void saveTemporary(const Twine &Path, LinkDiagnostics &Diags,
                          function_ref<void(raw_fd_ostream &)> Print) {
  std::error_code Failure;
  raw_fd_ostream File(Path.str(), Failure, sys::fs::OF_None);
  if (Failure)
    Diags.error("cannot write '" + Path + "': " + Failure.message());
  else
    Print(File);
}

namespace {
/// Keeps to itself what LLVM says a second time.
class SilentHandler final : public DiagnosticHandler {
public:
  bool handleDiagnostics(const DiagnosticInfo &) override { return true; }
};
} // namespace

// Bitcode and assembly. The code generator changes its module and reports, so
// that the assembly is made from a copy of its own.
void WholeProgram::saveOptimized(OptimizationLevel Level) {
  SmallString<0> Bitcode;
  raw_svector_ostream Stream(Bitcode);
  WriteBitcodeToFile(*Program, Stream);
  saveTemporary(Reports.TemporariesPath + ".lto.bc", Diags,
                [&](raw_fd_ostream &File) { File << Bitcode; });

  LLVMContext Context;
  Context.setDiagnosticHandler(std::make_unique<SilentHandler>());
  Expected<std::unique_ptr<Module>> Copy =
      parseBitcodeFile({Bitcode, "program"}, Context);
  if (!Copy)
    report_fatal_error(Copy.takeError());
  saveTemporary(Reports.TemporariesPath + ".lto.s", Diags,
                [&](raw_fd_ostream &File) {
                  emit(**Copy, *createMachine(Level), File,
                       CodeGenFileType::AssemblyFile);
                });
}

void WholeProgram::optimizeAndEmit(OptimizationLevel Level,
                                   raw_pwrite_stream &Object) {
  std::unique_ptr<TargetMachine> Machine = createMachine(Level);
  Machine->Options.StackUsageOutput = Reports.StackUsagePath;
  {
    TimeTraceScope Scope("OptimizeProgram");
    optimize(Level, *Machine);
  }
  if (!Reports.TemporariesPath.empty())
    saveOptimized(Level);
  TimeTraceScope Scope("GenerateCode");
  emit(*Program, *Machine, Object, CodeGenFileType::ObjectFile);
}

SmallVector<char, 0> WholeProgram::compile(OptimizationLevel Level) {
  internalize();
  SmallVector<char, 0> Object;
  Expected<LLVMRemarkFileHandle> Record = setupLLVMOptimizationRemarks(
      Program->getContext(), Reports.RecordPath, Reports.RecordPasses,
      Reports.RecordFormat, /*RemarksWithHotness=*/false);
  if (!Record) {
    Diags.error("cannot write the optimization record '" + Reports.RecordPath +
                "': " + toString(Record.takeError()));
    return Object;
  }
  raw_svector_ostream Stream(Object);
  optimizeAndEmit(Level, Stream);
  if (*Record)
    (*Record)->keep();
  Record->finalize();
  if (Diags.hasErrors())
    Object.clear();
  if (!Reports.TemporariesPath.empty())
    saveTemporary(Reports.TemporariesPath + ".lto.o", Diags,
                  [&](raw_fd_ostream &File) { File << Stream.str(); });
  return Object;
}

} // namespace tp
