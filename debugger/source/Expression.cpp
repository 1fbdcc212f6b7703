//===- Expression.cpp - Expressions of C++ over a program's values -------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/source/Expression.h"

#include "debugger/source/DebugInformation.h"
#include "debugger/source/ExpressionEvaluator.h"
#include "debugger/source/ExpressionNode.h"
#include "debugger/source/ExpressionParser.h"

#include "llvm/ADT/STLExtras.h"

using namespace llvm;

namespace tp {

unsigned ValueHistory::add(Value Kept) {
  Values.push_back(std::move(Kept));
  return size();
}

const Value *ValueHistory::get(int Number) const {
  int Index = Number > 0 ? Number - 1 : int(Values.size()) - 1 + Number;
  if (Index < 0 || size_t(Index) >= Values.size())
    return nullptr;
  return &Values[size_t(Index)];
}

const Value *ValueHistory::variable(StringRef Name) const {
  auto Found = Named.find(Name);
  return Found == Named.end() ? nullptr : &Found->second;
}

void ValueHistory::setVariable(StringRef Name, Value Kept) {
  Named[Name] = std::move(Kept);
}

bool ExpressionNode::hasEffects() const {
  return Kind == NodeKind::Assign || Kind == NodeKind::PreStep ||
         Kind == NodeKind::PostStep ||
         any_of(Operands, [](const auto &Part) { return Part->hasEffects(); });
}

Expression::Expression() = default;
Expression::Expression(Expression &&) noexcept = default;
Expression &Expression::operator=(Expression &&) noexcept = default;
Expression::~Expression() = default;

Expected<Expression> Expression::parse(StringRef Text,
                                       DebugInformation &Information,
                                       const FrameContext *Scope) {
  Expression Result;
  Result.Text = Text.trim().str();
  Expected<std::vector<Token>> Tokens = tokenize(Result.Text);
  if (!Tokens)
    return Tokens.takeError();
  Expected<std::unique_ptr<ExpressionNode>> Root =
      ExpressionParser(*Tokens, Information, Scope).run();
  if (!Root)
    return Root.takeError();
  Result.Root = std::move(*Root);
  Result.Evaluator = std::make_unique<ExpressionEvaluator>(Information);
  return Result;
}

Expected<Value> Expression::evaluate(const FrameContext &Frame,
                                     ValueHistory *History) const {
  return Evaluator->evaluate(*Root, Frame, History);
}

Expected<bool> Expression::isTrue(const FrameContext &Frame,
                                  ValueHistory *History) const {
  Expected<Value> Result = evaluate(Frame, History);
  if (!Result)
    return Result.takeError();
  return Evaluator->arithmetic().isTrue(*Result, Frame);
}

bool Expression::hasEffects() const { return Root->hasEffects(); }

const Type *Expression::namedType() const {
  return Root->Kind == NodeKind::TypeName ? Root->Of : nullptr;
}

} // namespace tp
