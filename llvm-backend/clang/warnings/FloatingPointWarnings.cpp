//===- FloatingPointWarnings.cpp - The -Wtp-fp warnings in the front end --===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// A clang plug-in that is part of tpcc, where it is always there, and of the
// shared object for stock clang, where -fplugin= brings it.
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/FloatingPointOptions.h"
#include "llvm-backend/TPDataLayout.h"
#include "llvm-backend/clang/warnings/ComparatorCheck.h"
#include "llvm-backend/clang/warnings/ConversionCheck.h"
#include "llvm-backend/clang/warnings/DiagnosticPragmas.h"
#include "llvm-backend/clang/warnings/DoubleCheck.h"
#include "llvm-backend/clang/warnings/NonFiniteCheck.h"
#include "clang/AST/RecursiveASTVisitor.h"
#include "clang/Basic/DiagnosticFrontend.h"
#include "clang/Basic/TargetInfo.h"
#include "clang/Frontend/CompilerInstance.h"
#include "clang/Frontend/FrontendPluginRegistry.h"
#include "llvm/Support/Path.h"

using namespace clang;
using namespace llvm;

namespace tp {

static bool isForTP(const CompilerInstance &Instance) {
  return Instance.getTarget().getTriple().str() == llvm::TPTriple;
}

// Whether the shared object that this is part of for stock clang is in Files.
static bool hasPlugIn(ArrayRef<std::string> Files) {
  return any_of(Files, [](const std::string &File) {
    return sys::path::stem(File) == "TPFloatingPoint";
  });
}

// Whether the canonicalizer will treat this translation unit.
static bool isCanonicalized(const CompilerInstance &Instance) {
  return (isForTP(Instance) ||
          hasPlugIn(Instance.getCodeGenOpts().PassPlugins)) &&
         isFloatingPointCanonicalizationEnabled();
}

namespace {

/// Shows each check what it looks at, once per instance of a template.
class Visitor : public RecursiveASTVisitor<Visitor> {
public:
  Visitor(ASTContext &Context, const ContractionRules &Rules,
          WarningReporter &Reporter)
      : Sources(Context.getSourceManager()), NonFinite(Context, Reporter),
        Conversion(Context, Reporter), Comparator(Context, Rules, Reporter),
        Double(Context, Reporter) {}

  bool shouldVisitTemplateInstantiations() const { return true; }

  bool TraverseDecl(Decl *D) {
    bool IsSkipped =
        D && !isa<TranslationUnitDecl>(D) &&
        Sources.isInSystemHeader(Sources.getExpansionLoc(D->getLocation()));
    return IsSkipped || RecursiveASTVisitor::TraverseDecl(D);
  }
  // Not evaluated when the program runs.
  bool TraverseStaticAssertDecl(StaticAssertDecl *) { return true; }
  bool TraverseUnaryExprOrTypeTraitExpr(UnaryExprOrTypeTraitExpr *) {
    return true;
  }
  bool TraverseDecltypeTypeLoc(DecltypeTypeLoc, bool) { return true; }
  bool TraverseCXXNoexceptExpr(CXXNoexceptExpr *) { return true; }

  bool VisitFunctionDecl(FunctionDecl *Function) {
    if (Function->doesThisDeclarationHaveABody() &&
        !Function->isDependentContext())
      Conversion.checkFunction(*Function);
    return true;
  }
  bool VisitLambdaExpr(LambdaExpr *Lambda) {
    const CXXMethodDecl *Body = Lambda->getCallOperator();
    if (!Body->isDependentContext() && !Body->getParentFunctionOrMethod())
      Conversion.checkFunction(*Body);
    // The instances of a generic one are not part of the tree.
    if (const FunctionTemplateDecl *Generic =
            Lambda->getLambdaClass()->getDependentLambdaCallOperator())
      for (FunctionDecl *Instance : Generic->specializations())
        TraverseDecl(Instance);
    return true;
  }
  bool VisitCallExpr(CallExpr *Call) {
    NonFinite.checkCall(*Call);
    Comparator.checkCall(*Call);
    Double.checkCall(*Call);
    return true;
  }
  bool VisitCXXConstructExpr(CXXConstructExpr *Construction) {
    Comparator.checkConstruction(*Construction);
    return true;
  }
  bool VisitTemplateSpecializationTypeLoc(TemplateSpecializationTypeLoc Type) {
    Comparator.checkContainerType(Type);
    return true;
  }
  bool VisitBinaryOperator(BinaryOperator *Operator) {
    NonFinite.checkBinaryOperator(*Operator);
    Double.checkBinaryOperator(*Operator);
    return true;
  }
  bool VisitUnaryOperator(UnaryOperator *Operator) {
    Double.checkUnaryOperator(*Operator);
    return true;
  }
  bool VisitCastExpr(CastExpr *Cast) {
    NonFinite.checkCast(*Cast);
    Double.checkCast(*Cast);
    return true;
  }
  bool VisitFloatingLiteral(FloatingLiteral *Literal) {
    NonFinite.checkLiteral(*Literal);
    return true;
  }

private:
  const SourceManager &Sources;
  NonFiniteCheck NonFinite;
  ConversionCheck Conversion;
  ComparatorCheck Comparator;
  DoubleCheck Double;
};

class Consumer : public ASTConsumer {
public:
  Consumer(CompilerInstance &Instance, const WarningOptions &Options)
      : Diags(Instance.getDiagnostics()),
        Pragmas(Instance.getSourceManager(), Options),
        Rules{isCanonicalized(Instance)} {
    Instance.getPreprocessor().addPPCallbacks(
        std::make_unique<DiagnosticPragmaReader>(Instance.getPreprocessor(),
                                                 Pragmas));
  }

  void HandleTranslationUnit(ASTContext &Context) override {
    if (Diags.hasUncompilableErrorOccurred() ||
        none_of(ArrayRef<FloatingPointWarning>{FloatingPointWarning::NonFinite,
                                               FloatingPointWarning::Conversion,
                                               FloatingPointWarning::Comparator,
                                               FloatingPointWarning::Double},
                [&](FloatingPointWarning Warning) {
                  return Pragmas.isAnywhereEnabled(Warning);
                }))
      return;
    WarningReporter Reporter(Diags, Pragmas);
    Visitor(Context, Rules, Reporter).TraverseAST(Context);
  }

private:
  DiagnosticsEngine &Diags;
  DiagnosticPragmas Pragmas;
  const ContractionRules Rules;
};

/// Makes the consumer, with the options of the command line.
class Action : public PluginASTAction {
public:
  std::unique_ptr<ASTConsumer> CreateASTConsumer(CompilerInstance &Instance,
                                                 StringRef) override {
    Instance.getDiagnostics().setSeverityForGroup(diag::Flavor::WarningOrError,
                                                  ReplacedClangWarning,
                                                  diag::Severity::Ignored);
    return std::make_unique<Consumer>(Instance, Options);
  }

  bool ParseArgs(const CompilerInstance &Instance,
                 const std::vector<std::string> &Words) override;

  ActionType getActionType() override { return AddBeforeMainAction; }

private:
  void readGeneralOptions(const CompilerInstance &Instance);
  llvm::Error readOwnOptions(const CompilerInstance &Instance,
                             ArrayRef<std::string> Words);

  WarningOptions Options;
};

} // namespace

void Action::readGeneralOptions(const CompilerInstance &Instance) {
  DiagnosticsEngine &Diags = Instance.getDiagnostics();
  for (const std::string &Name : Instance.getDiagnosticOpts().Warnings)
    Options.readGeneralWord("-W" + Name);
  Options.setGeneral(Diags.getWarningsAsErrors(), Diags.getIgnoreAllWarnings());
}

llvm::Error Action::readOwnOptions(const CompilerInstance &Instance,
                                   ArrayRef<std::string> Words) {
  for (const std::string &Name : Instance.getDiagnosticOpts().Warnings)
    if (StringRef Word = Name; Word.consume_back(ReplacedClangWarning))
      if (llvm::Error Unknown =
              Options.readOwnWord(("-W" + Word + "tp-fp-nonfinite").str()))
        return Unknown;
  for (const std::string &Word : Words)
    if (llvm::Error Unknown = Options.readOwnWord(Word))
      return Unknown;
  // Clang's driver ends a plug-in's name at its first dash: it hands on
  // -fplugin-arg-tp-fp-<word> as an argument of "tp".
  auto Split = Instance.getFrontendOpts().PluginArgs.find("tp");
  if (Split == Instance.getFrontendOpts().PluginArgs.end())
    return llvm::Error::success();
  for (StringRef Word : Split->second)
    if (Word.consume_front("fp"))
      if (llvm::Error Unknown = Options.readOwnWord(Word))
        return Unknown;
  return llvm::Error::success();
}

bool Action::ParseArgs(const CompilerInstance &Instance,
                       const std::vector<std::string> &Words) {
  // Stock clang that only wants the passes, -fpass-plugin=, is left alone.
  if (!isForTP(Instance) && !hasPlugIn(Instance.getFrontendOpts().Plugins))
    return false;
  readGeneralOptions(Instance);
  llvm::Error Unknown = readOwnOptions(Instance, Words);
  if (!Unknown)
    return true;
  DiagnosticsEngine &Diags = Instance.getDiagnostics();
  Diags.Report(Diags.getCustomDiagID(DiagnosticsEngine::Error, "%0"))
      << toString(std::move(Unknown));
  return false;
}

// Unless this process has it already: tpcc may load the shared object too.
static bool registerOnce() {
  for (const auto &PlugIn : FrontendPluginRegistry::entries())
    if (PlugIn.getName() == WarningPlugInName)
      return false;
  static FrontendPluginRegistry::Add<Action> Registration(
      WarningPlugInName, "warns of floating-point hazards");
  return true;
}

[[maybe_unused]] static const bool IsRegisteredHere = registerOnce();

} // namespace tp
