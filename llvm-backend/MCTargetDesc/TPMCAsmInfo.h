//===- TPMCAsmInfo.h - The TP's assembly syntax -----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_MCTARGETDESC_TPMCASMINFO_H
#define TP_LLVM_BACKEND_MCTARGETDESC_TPMCASMINFO_H

#include "llvm/MC/MCAsmInfoELF.h"

namespace llvm {

class Triple;

class TPMCAsmInfo : public MCAsmInfoELF {
public:
  TPMCAsmInfo();

  /// Prints `%hi(...)` or `%lo(...)`; the specifier is a TPII::OperandFlags.
  void printSpecifierExpr(raw_ostream &OS,
                          const MCSpecifierExpr &Expr) const override;
};

} // namespace llvm

#endif // TP_LLVM_BACKEND_MCTARGETDESC_TPMCASMINFO_H
