//===- VariableRequests.cpp - Requests about values -----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/dap/VariableRequests.h"

#include "llvm/ADT/StringExtras.h"

using namespace llvm;

namespace tp::dap {

void VariableRequests::addTo(Dispatcher &Requests) {
  using Self = VariableRequests;
  Requests.on("variables", Stage::Stopped, this, &Self::variables);
  Requests.on("setVariable", Stage::Stopped, this, &Self::setVariable);
  Requests.on("setExpression", Stage::Stopped, this, &Self::setExpression);
}

Response VariableRequests::variables(const VariablesArguments &Arguments) {
  Expected<KeptList> Kept = Target.Store.list(Arguments.VariablesReference);
  if (!Kept)
    return Kept.takeError();
  const VariableList &List = *Kept->List;
  json::Array Result;
  if (!Arguments.Filter.empty() &&
      List.isIndexed() != (Arguments.Filter == "indexed"))
    return json::Object{{"variables", std::move(Result)}};
  uint32_t First =
      uint32_t(std::clamp<int64_t>(Arguments.Start, 0, UINT32_MAX));
  uint32_t Count = UINT32_MAX;
  if (Arguments.Count > 0 && Arguments.Count < UINT32_MAX)
    Count = uint32_t(Arguments.Count);
  Expected<std::vector<VariableRow>> Rows =
      List.rows(First, Count, {Arguments.Hex});
  if (!Rows)
    return Rows.takeError();
  for (const VariableRow &Row : *Rows) {
    json::Object Variable = Target.describe(Row, Kept->Place, "value");
    Variable["name"] = json::fixUTF8(Row.Name);
    if (!Row.Expression.empty())
      Variable["evaluateName"] = Row.Expression;
    Result.push_back(std::move(Variable));
  }
  return json::Object{{"variables", std::move(Result)}};
}

Response VariableRequests::setVariable(const SetVariableArguments &Arguments) {
  Expected<KeptList> Kept = Target.Store.list(Arguments.VariablesReference);
  if (!Kept)
    return Kept.takeError();
  Expected<VariableRow> Row =
      Target.rowOf(Arguments.VariablesReference, Arguments.Name);
  if (!Row)
    return Row.takeError();
  if (Row->Expression.empty() || Row->IsReadOnly)
    return createStringError("'" + Arguments.Name + "' cannot be changed");
  return assign(Kept->Place, Row->Expression, Arguments.Value);
}

Response
VariableRequests::setExpression(const SetExpressionArguments &Arguments) {
  Expected<FramePlace> Place = Target.place(Arguments.FrameId);
  if (!Place)
    return Place.takeError();
  return assign(*Place, Arguments.Expression, Arguments.Value);
}

Response VariableRequests::assign(FramePlace Place, StringRef Name,
                                  StringRef NewValue) {
  Expected<std::shared_ptr<const SourceScope>> Scope = Target.scope(Place);
  if (!Scope)
    return Scope.takeError();
  std::string Text = (Name + " = (" + NewValue + ")").str();
  Expected<tp::Value> Assigned = evaluateIn(**Scope, Text, Effects::Allowed);
  if (!Assigned)
    return Assigned.takeError();
  Target.changed();
  Scope = Target.scope(Place);
  if (!Scope)
    return Scope.takeError();
  Expected<tp::Value> Now = evaluateIn(**Scope, Name, Effects::Forbidden);
  if (!Now)
    return Now.takeError();
  return Target.describe(sourceRow(*Scope, Name, *Now, Name.str(), {}), Place,
                         "value");
}

Response VariableRequests::evaluate(const EvaluateArguments &Arguments) {
  Expected<FramePlace> Place = Target.place(Arguments.FrameId);
  if (!Place)
    return Place.takeError();
  Expected<std::shared_ptr<const SourceScope>> Scope = Target.scope(*Place);
  if (!Scope)
    return Scope.takeError();
  Expected<tp::Value> Of =
      evaluateIn(**Scope, Arguments.Expression, Effects::Forbidden);
  if (!Of)
    return Of.takeError();
  std::string Expression = Arguments.Expression;
  if (!all_of(Expression, [](char C) { return isAlnum(C) || C == '_'; }))
    Expression = "(" + Expression + ")";
  VariableRow Row =
      sourceRow(*Scope, "", *Of, std::move(Expression), {Arguments.Hex});
  return Target.describe(Row, *Place, "result");
}

} // namespace tp::dap
