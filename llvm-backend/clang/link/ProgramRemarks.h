//===- ProgramRemarks.h - What LLVM says of the program ---------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_LINK_PROGRAMREMARKS_H
#define TP_LLVM_BACKEND_CLANG_LINK_PROGRAMREMARKS_H

#include "llvm-backend/clang/link/LinkDiagnostics.h"
#include "llvm-backend/clang/link/ProgramReports.h"
#include "llvm/IR/DiagnosticHandler.h"
#include "llvm/IR/DiagnosticInfo.h"
#include "llvm/IR/Function.h"
#include "llvm/IR/Module.h"
#include "llvm/Support/Regex.h"

#include <optional>

namespace tp {

/// Marks \p F as one whose remarks are of no interest: the runtime's.
void silenceRemarks(llvm::Function &F);

/// Prints what LLVM says of the program, in clang's words where clang has some,
/// as the linker's own messages.
class ProgramRemarks final : public llvm::DiagnosticHandler {
public:
  /// \p Program is what the messages are about.
  ProgramRemarks(const llvm::Module &Program, LinkDiagnostics &Diags,
                 const RemarkPatterns &Patterns);

  bool handleDiagnostics(const llvm::DiagnosticInfo &Info) override;
  bool isPassedOptRemarkEnabled(llvm::StringRef Pass) const override;
  bool isMissedOptRemarkEnabled(llvm::StringRef Pass) const override;
  bool isAnalysisRemarkEnabled(llvm::StringRef Pass) const override;
  bool isAnyRemarkEnabled() const override;

private:
  void reportRemark(const llvm::DiagnosticInfoOptimizationBase &Remark);
  void reportFrame(const llvm::DiagnosticInfoStackSize &Frame);

  const llvm::Module &Program;
  LinkDiagnostics &Diags;
  std::optional<llvm::Regex> Passed, Missed, Analysis;
};

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_LINK_PROGRAMREMARKS_H
