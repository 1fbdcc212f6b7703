//===- TPOperand.h - Parsed operand of an instruction -----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_ASMPARSER_TPOPERAND_H
#define TP_LLVM_BACKEND_ASMPARSER_TPOPERAND_H

#include "llvm-backend/MCTargetDesc/TPBaseInfo.h"
#include "llvm/MC/MCExpr.h"
#include "llvm/MC/MCInst.h"
#include "llvm/MC/MCParser/MCParsedAsmOperand.h"
#include "llvm/Support/Casting.h"
#include "llvm/Support/MathExtras.h"
#include "llvm/Support/SMLoc.h"
#include <memory>

namespace llvm {

/// A token (the mnemonic or a parenthesis), a register or an expression.
class TPOperand : public MCParsedAsmOperand {
public:
  static std::unique_ptr<TPOperand> createToken(StringRef Text, SMLoc Start) {
    auto Operand = std::make_unique<TPOperand>(Kind::Token, Start, Start);
    Operand->Text = Text;
    return Operand;
  }
  static std::unique_ptr<TPOperand> createRegister(MCRegister Register,
                                                   SMLoc Start, SMLoc End) {
    auto Operand = std::make_unique<TPOperand>(Kind::Register, Start, End);
    Operand->Register = Register;
    return Operand;
  }
  static std::unique_ptr<TPOperand> createExpression(const MCExpr *Expression,
                                                     SMLoc Start, SMLoc End) {
    auto Operand = std::make_unique<TPOperand>(Kind::Expression, Start, End);
    Operand->Expression = Expression;
    return Operand;
  }

  // Operand classes; the names are those of TPInstrFormats.td.
  bool isToken() const override { return OperandKind == Kind::Token; }
  bool isReg() const override { return OperandKind == Kind::Register; }
  bool isImm() const override { return OperandKind == Kind::Expression; }
  bool isMem() const override { return false; }
  bool isSImm16() const {
    return isConstantOr(TPII::MO_LO, [](int64_t V) { return isInt<16>(V); });
  }
  bool isUImm16() const {
    return isConstantOr(TPII::MO_HI, [](int64_t V) { return isUInt<16>(V); });
  }
  bool isUImm5() const {
    return isConstant([](int64_t V) { return isUInt<5>(V); });
  }
  bool isSpecialRegister() const {
    return isConstant([](int64_t V) {
      return isUInt<5>(V) && TPSpecialRegister::lookupByEncoding(V);
    });
  }
  bool isBranchTarget() const {
    return isConstantOr(TPII::MO_None,
                        [](int64_t V) { return isShiftedInt<16, 2>(V); });
  }
  bool isJumpTarget() const {
    return isConstantOr(TPII::MO_None,
                        [](int64_t V) { return isShiftedInt<26, 2>(V); });
  }
  bool isImm32() const {
    return isConstant([](int64_t V) { return isInt<32>(V) || isUInt<32>(V); });
  }
  bool isSymbol() const {
    return isConstantOr(TPII::MO_None, [](int64_t V) { return isUInt<32>(V); });
  }

  void addRegOperands(MCInst &Inst, unsigned N) const {
    Inst.addOperand(MCOperand::createReg(Register));
  }
  void addImmOperands(MCInst &Inst, unsigned N) const {
    if (const auto *Constant = dyn_cast<MCConstantExpr>(Expression))
      Inst.addOperand(MCOperand::createImm(Constant->getValue()));
    else
      Inst.addOperand(MCOperand::createExpr(Expression));
  }

  StringRef getToken() const { return Text; }
  MCRegister getReg() const override { return Register; }
  SMLoc getStartLoc() const override { return Start; }
  SMLoc getEndLoc() const override { return End; }
  void print(raw_ostream &OS, const MCAsmInfo &MAI) const override;

  enum class Kind { Token, Register, Expression };
  TPOperand(Kind OperandKind, SMLoc Start, SMLoc End)
      : OperandKind(OperandKind), Start(Start), End(End) {}

private:
  template <class PredicateT> bool isConstant(PredicateT Predicate) const {
    if (!isImm())
      return false;
    const auto *Constant = dyn_cast<MCConstantExpr>(Expression);
    return Constant && Predicate(Constant->getValue());
  }
  /// A constant that satisfies the predicate, an expression that is not known
  /// yet, or one with the given specifier.
  template <class PredicateT>
  bool isConstantOr(unsigned Specifier, PredicateT Predicate) const {
    if (!isImm() || isa<MCConstantExpr>(Expression))
      return isConstant(Predicate);
    const auto *Half = dyn_cast<MCSpecifierExpr>(Expression);
    return !Half || Half->getSpecifier() == Specifier;
  }

  Kind OperandKind;
  SMLoc Start, End;
  StringRef Text;
  MCRegister Register;
  const MCExpr *Expression = nullptr;
};

} // namespace llvm

#endif // TP_LLVM_BACKEND_ASMPARSER_TPOPERAND_H
