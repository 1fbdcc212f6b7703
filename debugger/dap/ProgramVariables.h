//===- ProgramVariables.h - Variables of the program's source ---*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_DAP_PROGRAMVARIABLES_H
#define TP_DEBUGGER_DAP_PROGRAMVARIABLES_H

#include "debugger/dap/VariableList.h"
#include "debugger/source/DebugInformation.h"
#include "debugger/source/ValuePrinter.h"

namespace tp::dap {

/// Where names and values are looked up.
struct SourceScope {
  DebugInformation *Information = nullptr;
  FrameContext Frame;
};

/// Whether an expression may change the program.
enum class Effects { Forbidden, Allowed };

/// The value of an expression.
llvm::Expected<tp::Value> evaluateIn(const SourceScope &Scope,
                                     llvm::StringRef Expression,
                                     Effects Allowed);

/// A value as a row with its parts. \p Expression gives it again.
VariableRow sourceRow(const std::shared_ptr<const SourceScope> &Scope,
                      llvm::StringRef Name, const tp::Value &Of,
                      std::string Expression, ValueFormat Format);

/// Some of the variables that a frame sees.
class ScopeVariables : public VariableList {
public:
  ScopeVariables(std::shared_ptr<const SourceScope> Scope,
                 std::vector<VariableInfo> Variables)
      : Scope(std::move(Scope)), Variables(std::move(Variables)) {}

  uint32_t count() const override { return uint32_t(Variables.size()); }
  llvm::Expected<std::vector<VariableRow>>
  rows(uint32_t First, uint32_t Count, ValueFormat Format) const override;

private:
  std::shared_ptr<const SourceScope> Scope;
  std::vector<VariableInfo> Variables;
};

} // namespace tp::dap

#endif // TP_DEBUGGER_DAP_PROGRAMVARIABLES_H
