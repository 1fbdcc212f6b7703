//===- WholeProgram.cpp - Bitcode to one optimized object -----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/link/WholeProgram.h"
#include "llvm-backend/FloatingPoint/Check/CheckPass.h"
#include "llvm-backend/TPDataLayout.h"
#include "llvm-backend/clang/link/LibraryFunctions.h"
#include "llvm/Analysis/CGSCCPassManager.h"
#include "llvm/Analysis/LoopAnalysisManager.h"
#include "llvm/Demangle/Demangle.h"
#include "llvm/IR/DebugInfo.h"
#include "llvm/IR/DiagnosticInfo.h"
#include "llvm/IR/DiagnosticPrinter.h"
#include "llvm/IR/LegacyPassManager.h"
#include "llvm/Linker/Linker.h"
#include "llvm/MC/TargetRegistry.h"
#include "llvm/Object/ModuleSymbolTable.h"
#include "llvm/Passes/PassBuilder.h"
#include "llvm/Passes/StandardInstrumentations.h"
#include "llvm/Target/TargetMachine.h"
#include "llvm/Target/TargetOptions.h"
#include "llvm/Transforms/IPO/GlobalDCE.h"
#include "llvm/Transforms/IPO/Internalize.h"

using namespace llvm;

namespace tp {

namespace {
/// Prints what LLVM says of the program as the linker's own messages.
class LinkDiagnosticHandler final : public DiagnosticHandler {
public:
  explicit LinkDiagnosticHandler(LinkDiagnostics &Diags) : Diags(Diags) {}

  bool handleDiagnostics(const DiagnosticInfo &Info) override {
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

private:
  LinkDiagnostics &Diags;
};
} // namespace

WholeProgram::WholeProgram(LLVMContext &Context, LinkDiagnostics &Diags)
    : Diags(Diags), Program(std::make_unique<Module>("program", Context)) {
  Context.setDiagnosticHandler(std::make_unique<LinkDiagnosticHandler>(Diags));
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
  // It uses infinities and NaNs on purpose.
  for (Function &F : *Runtime)
    if (!F.isDeclaration())
      F.addFnAttr(UncheckedFunctionAttribute);

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

SmallVector<char, 0> WholeProgram::compile(OptimizationLevel Level) {
  std::unique_ptr<TargetMachine> Machine = createMachine(Level);
  internalize();
  optimize(Level, *Machine);

  SmallVector<char, 0> Object;
  raw_svector_ostream Stream(Object);
  legacy::PassManager Passes;
  if (Machine->addPassesToEmitFile(Passes, Stream, /*DwoOut=*/nullptr,
                                   CodeGenFileType::ObjectFile))
    report_fatal_error("the code generator cannot write objects");
  Passes.run(*Program);
  if (Diags.hasErrors())
    Object.clear();
  return Object;
}

} // namespace tp
