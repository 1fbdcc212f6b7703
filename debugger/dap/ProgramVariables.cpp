//===- ProgramVariables.cpp - Variables of the program's source -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/ProgramVariables.h"

#include "debugger/source/Children.h"
#include "debugger/source/Expression.h"

#include "llvm/ADT/ArrayRef.h"
#include "llvm/ADT/StringExtras.h"

#include <algorithm>

using namespace llvm;

namespace tp::dap {
namespace {

using ScopePointer = std::shared_ptr<const SourceScope>;

/// Members, elements, or what a pointer points to.
class ValueParts : public VariableList {
public:
  /// \p Expression gives \p Of or, if \p ByPointer, a pointer to it.
  ValueParts(ScopePointer Scope, tp::Value Of, std::string Expression,
             bool ByPointer)
      : Scope(std::move(Scope)), Of(std::move(Of)),
        Expression(std::move(Expression)), ByPointer(ByPointer) {
    Expected<std::optional<Sequence>> Elements =
        elementsOf(this->Of, this->Scope->Frame);
    HasElements = Elements && Elements->has_value();
    consumeError(Elements.takeError());
  }

  uint32_t count() const override { return childCount(Of, Scope->Frame); }

  bool isIndexed() const override { return HasElements; }

  Expected<std::vector<VariableRow>> rows(uint32_t First, uint32_t Count,
                                          ValueFormat Format) const override {
    Expected<std::vector<NamedValue>> Parts =
        children(Of, Scope->Frame, First, Count);
    if (!Parts)
      return Parts.takeError();
    std::vector<VariableRow> Rows;
    for (const NamedValue &Part : *Parts)
      Rows.push_back(
          sourceRow(Scope, Part.Name, Part.Of, expressionOf(Part), Format));
    return Rows;
  }

private:
  ScopePointer Scope;
  tp::Value Of;
  std::string Expression;
  bool ByPointer;
  bool HasElements;

  std::string expressionOf(const NamedValue &Part) const {
    if (isIndexed())
      return Expression + Part.Name;
    if (Of.type().stripped().isPointer())
      return "(*" + Expression + ")";
    if (Part.IsBase)
      return "(*(" + Part.Of.type().Name + " *)" + (ByPointer ? "" : "&") +
             Expression + ")";
    return Expression + (ByPointer ? "->" : ".") + Part.Name;
  }
};

} // namespace

/// What can be unfolded of a value; nothing if it has no parts.
static std::shared_ptr<VariableList>
partsOf(const ScopePointer &Scope, const tp::Value &Of, StringRef Expression) {
  if (Of.isOptimizedOut())
    return nullptr;
  const Type &Stripped = Of.type().stripped();
  bool ByPointer = false;
  tp::Value Whole = Of;
  if (Stripped.isReference() || Stripped.isPointer()) {
    Expected<uint64_t> Address = Of.asInteger(Scope->Frame);
    if (!Address || *Address == 0) {
      consumeError(Address.takeError());
      return nullptr;
    }
    if (Stripped.isReference() || Stripped.Target->stripped().isRecord()) {
      Expected<tp::Value> Object = pointee(Of, Scope->Frame);
      if (!Object) {
        consumeError(Object.takeError());
        return nullptr;
      }
      if (Stripped.isReference())
        return partsOf(Scope, *Object, Expression);
      Whole = *Object;
      ByPointer = true;
    }
  }
  if (childCount(Whole, Scope->Frame) == 0)
    return nullptr;
  return std::make_shared<ValueParts>(Scope, Whole, Expression.str(),
                                      ByPointer);
}

Expected<tp::Value> evaluateIn(const SourceScope &Scope, StringRef Expression,
                               Effects Allowed) {
  Expected<tp::Expression> Parsed =
      tp::Expression::parse(Expression, *Scope.Information, &Scope.Frame);
  if (!Parsed)
    return Parsed.takeError();
  if (Allowed == Effects::Forbidden && Parsed->hasEffects())
    return createStringError("'" + Expression +
                             "' would change the program; use the console");
  return Parsed->evaluate(Scope.Frame);
}

VariableRow sourceRow(const ScopePointer &Scope, StringRef Name,
                      const tp::Value &Of, std::string Expression,
                      ValueFormat Format) {
  VariableRow Row;
  Row.Name = Name.str();
  PrintOptions Options;
  Options.Format = Format.Hex ? 'x' : 0;
  Options.MaxDepth = 2;
  Options.MaxElements = 32;
  Row.Value =
      ValuePrinter(Scope->Information->map()).print(Of, Scope->Frame, Options);
  Row.Type = Of.type().Name;
  Row.Address = Of.address();
  Row.Parts = partsOf(Scope, Of, Expression);
  Row.Expression = std::move(Expression);
  return Row;
}

/// The row of a variable, also if it cannot be read.
static VariableRow variableRow(const ScopePointer &Scope,
                               const VariableInfo &Variable,
                               ValueFormat Format) {
  Expected<tp::Value> Of =
      Scope->Information->variables().value(Variable, Scope->Frame);
  if (Of) {
    std::string Expression = Variable.IsShadowed ? "" : Variable.Name;
    return sourceRow(Scope, Variable.Name, *Of, std::move(Expression), Format);
  }
  VariableRow Row;
  Row.Name = Variable.Name;
  Row.Value = "<error: " + toString(Of.takeError()) + ">";
  Row.IsReadOnly = true;
  return Row;
}

Expected<std::vector<VariableRow>>
ScopeVariables::rows(uint32_t First, uint32_t Count, ValueFormat Format) const {
  std::vector<VariableRow> Rows;
  uint32_t End = First + std::min(Count, count() - std::min(First, count()));
  for (uint32_t I = First; I < End; ++I)
    Rows.push_back(variableRow(Scope, Variables[I], Format));
  return Rows;
}

} // namespace tp::dap
