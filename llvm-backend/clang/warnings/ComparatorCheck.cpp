//===- ComparatorCheck.cpp - Orders that rounding breaks ------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/warnings/ComparatorCheck.h"
#include "llvm-backend/clang/warnings/Expressions.h"
#include "clang/AST/DeclFriend.h"
#include "clang/AST/DeclTemplate.h"
#include "llvm/ADT/StringSwitch.h"

using namespace clang;
using namespace llvm;

namespace tp {

// Whether functions of this name take a comparator, or compare elements
// without one.
static bool isOrderingAlgorithm(StringRef Name) {
  if (Name.contains_insensitive("sort"))
    return true;
  return StringSwitch<bool>(Name)
      .Cases({"nth_element", "min_element", "max_element", "minmax_element",
              "lower_bound", "upper_bound", "equal_range", "binary_search",
              "bsearch", "merge", "inplace_merge", "includes"},
             true)
      .Cases({"set_union", "set_intersection", "set_difference",
              "set_symmetric_difference"},
             true)
      .Cases({"make_heap", "push_heap", "pop_heap", "is_heap", "is_heap_until"},
             true)
      .Default(false);
}

// Whether D is declared in std or a namespace in it.
static bool isFromStd(const Decl &D) {
  for (const DeclContext *Context = D.getDeclContext(); Context;
       Context = Context->getParent())
    if (Context->isStdNamespace())
      return true;
  return false;
}

static bool isOrderedContainer(const NamedDecl &Template) {
  return Template.getIdentifier() && isFromStd(Template) &&
         StringSwitch<bool>(Template.getName())
             .Cases({"set", "multiset", "map", "multimap", "priority_queue"},
                    true)
             .Default(false);
}

// The name of the algorithm that Call runs, also of an object such as
// std::ranges::sort.
static StringRef algorithmName(const CallExpr &Call) {
  if (const auto *Operator = dyn_cast<CXXOperatorCallExpr>(&Call)) {
    const VarDecl *Object = Operator->getOperator() == OO_Call
                                ? namedVariable(Operator->getArg(0))
                                : nullptr;
    return Object && isFromStd(*Object) ? Object->getName() : "";
  }
  return calleeName(Call);
}

static const FunctionDecl *definitionOf(const FunctionDecl *Function) {
  const FunctionDecl *Definition = nullptr;
  return Function && Function->getBody(Definition) ? Definition : nullptr;
}

void ComparatorCheck::report(const MixedRounding &Found, StringRef User,
                             SourceLocation Place) {
  static constexpr StringRef Causes[] = {
      "an operand may be fused into it unrounded",
      "its operands may be regrouped",
      "a quotient in it may become a product with the reciprocal"};
  // What the canonicalizer regroups, it regroups alike everywhere.
  bool IsConsistent =
      Rules.IsCanonical && Found.Why != MixedRounding::Cause::Contraction;
  StringRef Consequence = IsConsistent
                              ? "elements that are nearly equal may change "
                                "places"
                              : "an element may come before itself";
  const BinaryOperator &Operator = *Found.Operator;
  if (!Reporter.warn(
          FloatingPointWarning::Comparator, Operator.getOperatorLoc(),
          ("'" + User +
           "' orders by the sign of this rounded result of two elements: " +
           Causes[static_cast<size_t>(Found.Why)] + ", so that " + Consequence)
              .str(),
          {Operator.getLHS()->getSourceRange(),
           Operator.getRHS()->getSourceRange()}))
    return;
  Reporter.note(Place, ("the order of '" + User + "' is chosen here").str());

  // All options that apply, so that one pragma is enough.
  FPOptions InEffect = Operator.getFPFeaturesInEffect(Context.getLangOpts());
  std::string Pragma = "#pragma clang fp";
  if (InEffect.getFPContractMode() != LangOptions::FPM_Off)
    Pragma += " contract(off)";
  if (InEffect.getAllowFPReassociate())
    Pragma += " reassociate(off)";
  if (InEffect.getAllowReciprocal())
    Pragma += " reciprocal(off)";
  const auto *Body = dyn_cast<CompoundStmt>(Found.Function->getBody());
  SmallVector<FixItHint, 1> FixIts;
  if (Body && !Body->getLBracLoc().isMacroID())
    FixIts.push_back(FixItHint::CreateInsertion(
        Body->getLBracLoc().getLocWithOffset(1), "\n" + Pragma + "\n"));
  Reporter.note(Body ? Body->getLBracLoc() : Found.Function->getLocation(),
                ("compare a key computed from each element alone, or write '" +
                 Pragma + "' first in this function"),
                {}, FixIts);
}

void ComparatorCheck::checkComparator(const FunctionDecl *Comparator,
                                      StringRef User, SourceLocation Place) {
  Comparator = definitionOf(Comparator);
  if (!Comparator || Comparator->isDependentContext())
    return;
  const SourceManager &Sources = Context.getSourceManager();
  if (Sources.isInSystemHeader(
          Sources.getExpansionLoc(Comparator->getLocation())))
    return;
  unsigned Elements = Comparator->getNumParams();
  if (const auto *Method = dyn_cast<CXXMethodDecl>(Comparator);
      Method && Comparator->getOverloadedOperator() != OO_Call &&
      Method->isImplicitObjectMemberFunction())
    ++Elements;
  if (Elements != 2)
    return;
  if (auto Found = findMixedRounding(*Comparator, Context, Rules))
    report(*Found, User, Place);
}

void ComparatorCheck::checkFunctor(const CXXRecordDecl &Class, StringRef User,
                                   SourceLocation Place) {
  if (!Class.hasDefinition())
    return;
  for (const Decl *Member : Class.getDefinition()->decls()) {
    if (const auto *Template = dyn_cast<FunctionTemplateDecl>(Member)) {
      if (Template->getTemplatedDecl()->getOverloadedOperator() == OO_Call)
        for (const FunctionDecl *Instance : Template->specializations())
          checkComparator(Instance, User, Place);
    } else if (const auto *Method = dyn_cast<CXXMethodDecl>(Member);
               Method && Method->getOverloadedOperator() == OO_Call) {
      checkComparator(Method, User, Place);
    }
  }
}

// What a copy is made of.
static const Expr *unwrapCopies(const Expr *E) {
  for (;;) {
    E = unwrap(E);
    const auto *Construction = dyn_cast<CXXConstructExpr>(E);
    if (!Construction || Construction->getNumArgs() != 1)
      return E;
    E = Construction->getArg(0);
  }
}

void ComparatorCheck::checkArgument(const Expr &Argument, StringRef User,
                                    SourceLocation Place) {
  const Expr *E = unwrapCopies(&Argument);
  // A pointer to a function, or a std::function.
  if (const VarDecl *Variable = namedVariable(E)) {
    const auto *Class = Variable->getType()->getAsCXXRecordDecl();
    if (Variable->getInit() && (Variable->getType()->isFunctionPointerType() ||
                                (Class && isFromStd(*Class))))
      E = unwrapCopies(Variable->getInit());
  }
  if (const auto *Address = dyn_cast<UnaryOperator>(E);
      Address && Address->getOpcode() == UO_AddrOf)
    E = unwrap(Address->getSubExpr());
  if (const auto *Cast = dyn_cast<ExplicitCastExpr>(E))
    E = unwrapCopies(Cast->getSubExpr());
  if (const auto *Reference = dyn_cast<DeclRefExpr>(E))
    if (const auto *Function = dyn_cast<FunctionDecl>(Reference->getDecl()))
      return checkComparator(Function, User, Place);
  if (const auto *Class = E->getType()->getAsCXXRecordDecl())
    if (!isFromStd(*Class))
      checkFunctor(*Class, User, Place);
}

// The order of elements for which no comparator is given: their operator< or
// operator<=>.
void ComparatorCheck::checkElementOrder(QualType Element, StringRef User,
                                        SourceLocation Place) {
  const auto *Class = Element->getAsCXXRecordDecl();
  if (!Class || !Class->hasDefinition())
    return;
  Class = Class->getDefinition();
  auto CheckOperator = [&](const NamedDecl *D) {
    const auto *Function = dyn_cast_or_null<FunctionDecl>(D);
    if (!Function)
      return;
    OverloadedOperatorKind Operator = Function->getOverloadedOperator();
    if ((Operator == OO_Less || Operator == OO_Spaceship) &&
        all_of(Function->parameters(), [&](const ParmVarDecl *Parameter) {
          QualType Type = Parameter->getType().getNonReferenceType();
          return declaresSameEntity(Type->getAsCXXRecordDecl(), Class);
        }))
      checkComparator(Function, User, Place);
  };
  const DeclContext *Namespace = Class->getEnclosingNamespaceContext();
  for (OverloadedOperatorKind Operator : {OO_Less, OO_Spaceship}) {
    DeclarationName Name =
        Context.DeclarationNames.getCXXOperatorName(Operator);
    for (const NamedDecl *Member : Class->lookup(Name))
      CheckOperator(Member);
    for (const NamedDecl *Free : Namespace->lookup(Name))
      CheckOperator(Free);
  }
  for (const FriendDecl *Friend : Class->friends())
    CheckOperator(Friend->getFriendDecl());
}

// What a pointer or a class's operator* gives.
static QualType pointedTo(QualType Iterator, ASTContext &Context) {
  if (Iterator->isPointerType())
    return Iterator->getPointeeType();
  const auto *Class = Iterator->getAsCXXRecordDecl();
  if (!Class || !Class->hasDefinition())
    return QualType();
  DeclarationName Star = Context.DeclarationNames.getCXXOperatorName(OO_Star);
  for (const NamedDecl *Member : Class->getDefinition()->lookup(Star))
    if (const auto *Method = dyn_cast<CXXMethodDecl>(Member);
        Method && Method->getNumParams() == 0)
      return Method->getReturnType().getNonReferenceType();
  return QualType();
}

void ComparatorCheck::checkCall(const CallExpr &Call) {
  StringRef Name = algorithmName(Call);
  if (Name.empty() || Call.isTypeDependent() || !isOrderingAlgorithm(Name))
    return;
  bool IsObject = isa<CXXOperatorCallExpr>(Call);
  for (const Expr *Argument : drop_begin(Call.arguments(), IsObject))
    checkArgument(*Argument, Name, Argument->getExprLoc());
  // Elements of which nothing says how to compare them.
  const FunctionDecl *Callee = Call.getDirectCallee();
  if (!Callee || !isFromStd(*Callee) || IsObject || Call.getNumArgs() == 0)
    return;
  QualType First = Call.getArg(0)->getType();
  bool HasComparator = any_of(Callee->parameters(), [](const ParmVarDecl *P) {
    return P->getName().contains_insensitive("comp");
  });
  if (!HasComparator)
    if (QualType Element = pointedTo(First, Context); !Element.isNull())
      checkElementOrder(Element, Name, Call.getExprLoc());
}

void ComparatorCheck::checkConstruction(const CXXConstructExpr &Construction) {
  const CXXRecordDecl *Class = Construction.getConstructor()->getParent();
  if (!isOrderedContainer(*Class))
    return;
  for (const Expr *Argument : Construction.arguments())
    if (unwrap(Argument)->getType()->isFunctionType() ||
        unwrap(Argument)->getType()->isFunctionPointerType())
      checkArgument(*Argument, Class->getName(), Argument->getExprLoc());
}

void ComparatorCheck::checkContainerType(TemplateSpecializationTypeLoc Type) {
  const TemplateSpecializationType *Specialization = Type.getTypePtr();
  const TemplateDecl *Template =
      Specialization->getTemplateName().getAsTemplateDecl();
  if (!Template || Specialization->isDependentType() ||
      !isOrderedContainer(*Template))
    return;
  const auto *Class = Specialization->getAsCXXRecordDecl();
  const auto *Instance =
      dyn_cast_or_null<ClassTemplateSpecializationDecl>(Class);
  if (!Instance)
    return;
  // The comparator follows the key, the element of a map, or the container
  // of a priority queue.
  StringRef Name = Template->getName();
  bool IsSet = Name == "set" || Name == "multiset";
  const TemplateArgumentList &Arguments = Instance->getTemplateArgs();
  QualType Comparator = Arguments[IsSet ? 1 : 2].getAsType();
  const auto *Functor = Comparator->getAsCXXRecordDecl();
  if (!Functor)
    return;
  if (isFromStd(*Functor))
    checkElementOrder(Arguments[0].getAsType(), Name, Type.getBeginLoc());
  else
    checkFunctor(*Functor, Name, Type.getBeginLoc());
}

} // namespace tp
