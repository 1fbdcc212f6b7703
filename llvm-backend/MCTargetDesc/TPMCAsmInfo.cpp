//===- TPMCAsmInfo.cpp - The TP's assembly syntax -------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/MCTargetDesc/TPMCAsmInfo.h"
#include "llvm-backend/MCTargetDesc/TPBaseInfo.h"
#include "llvm/MC/MCExpr.h"
#include "llvm/Support/raw_ostream.h"

using namespace llvm;

TPMCAsmInfo::TPMCAsmInfo() {
  CodePointerSize = 4;
  CalleeSaveStackSlotSize = 4;
  MinInstAlignment = 4;
  MaxInstLength = 4;
  CommentString = "#";
  Data64bitsDirective = "\t.8byte\t";
  UsesELFSectionDirectiveForBSS = true;
  SupportsDebugInformation = true;
  UsesCFIWithoutEH = true;
}

void TPMCAsmInfo::printSpecifierExpr(raw_ostream &OS,
                                     const MCSpecifierExpr &Expr) const {
  OS << (Expr.getSpecifier() == TPII::MO_HI ? "%hi(" : "%lo(");
  printExpr(OS, *Expr.getSubExpr());
  OS << ')';
}
