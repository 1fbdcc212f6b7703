//===- TPAsmParser.cpp - The TP's assembly language -----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/AsmParser/TPOperand.h"
#include "llvm-backend/MCTargetDesc/TPMCTargetDesc.h"
#include "llvm-backend/TargetInfo/TPTargetInfo.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/ADT/StringSwitch.h"
#include "llvm/MC/MCAsmInfo.h"
#include "llvm/MC/MCContext.h"
#include "llvm/MC/MCInstBuilder.h"
#include "llvm/MC/MCInstrInfo.h"
#include "llvm/MC/MCParser/AsmLexer.h"
#include "llvm/MC/MCParser/MCAsmParser.h"
#include "llvm/MC/MCParser/MCTargetAsmParser.h"
#include "llvm/MC/MCStreamer.h"
#include "llvm/MC/MCSubtargetInfo.h"
#include "llvm/MC/TargetRegistry.h"
#include "llvm/Support/Compiler.h"
#include "llvm/Support/raw_ostream.h"

using namespace llvm;

#define DEBUG_TYPE "tp-asm-parser"

void TPOperand::print(raw_ostream &OS, const MCAsmInfo &MAI) const {
  switch (OperandKind) {
  case Kind::Token:
    OS << "token '" << Text << '\'';
    break;
  case Kind::Register:
    OS << "register " << Register.id();
    break;
  case Kind::Expression:
    OS << "expression ";
    MAI.printExpr(OS, *Expression);
    break;
  }
}

namespace {

class TPAsmParser : public MCTargetAsmParser {
public:
  enum TPMatchResultTy {
    Match_ReversedBitField = FIRST_TARGET_MATCH_RESULT_TY,
#define GET_OPERAND_DIAGNOSTIC_TYPES
#include "TPGenAsmMatcher.inc"
  };

  TPAsmParser(const MCSubtargetInfo &STI, MCAsmParser &Parser,
              const MCInstrInfo &MII, const MCTargetOptions &Options)
      : MCTargetAsmParser(Options, STI, MII) {
    MCAsmParserExtension::Initialize(Parser);
    Parser.addAliasForDirective(".half", ".2byte");
    Parser.addAliasForDirective(".hword", ".2byte");
    Parser.addAliasForDirective(".word", ".4byte");
    Parser.addAliasForDirective(".dword", ".8byte");
    setAvailableFeatures(ComputeAvailableFeatures(STI.getFeatureBits()));
  }

  bool parseRegister(MCRegister &Register, SMLoc &Start, SMLoc &End) override;
  ParseStatus tryParseRegister(MCRegister &Register, SMLoc &Start,
                               SMLoc &End) override;
  bool parseInstruction(ParseInstructionInfo &Info, StringRef Name,
                        SMLoc NameLoc, OperandVector &Operands) override;
  bool matchAndEmitInstruction(SMLoc Loc, unsigned &Opcode,
                               OperandVector &Operands, MCStreamer &Out,
                               uint64_t &ErrorInfo,
                               bool MatchingInlineAsm) override;
  unsigned checkTargetMatchPredicate(MCInst &Inst) override;

private:
#define GET_ASSEMBLER_HEADER
#include "TPGenAsmMatcher.inc"

  bool parseOperand(OperandVector &Operands, StringRef Mnemonic);
  bool parseBaseRegister(OperandVector &Operands);
  bool parseHalfOfAddress(OperandVector &Operands);
  bool parseExpressionOperand(OperandVector &Operands);
  ParseStatus parseSymbol(OperandVector &Operands);
  ParseStatus parseSpecialRegister(OperandVector &Operands);
  bool isAtBaseRegister();
  bool reportMismatch(unsigned MatchResult, SMLoc Loc,
                      const OperandVector &Operands, uint64_t ErrorInfo);

  void emitLoadImmediate(MCInst &Inst, MCStreamer &Out);
  void emitLoadAddress(MCInst &Inst, MCStreamer &Out);
};

} // namespace

#define GET_REGISTER_MATCHER
#define GET_MATCHER_IMPLEMENTATION
#define GET_MNEMONIC_SPELL_CHECKER
#include "TPGenAsmMatcher.inc"

//===----------------------------------------------------------------------===//
// Parsing
//===----------------------------------------------------------------------===//

static MCRegister matchRegister(StringRef Name) {
  MCRegister Register = MatchRegisterName(Name);
  return Register ? Register : MatchRegisterAltName(Name);
}

ParseStatus TPAsmParser::tryParseRegister(MCRegister &Register, SMLoc &Start,
                                          SMLoc &End) {
  const AsmToken &Token = getTok();
  Start = Token.getLoc();
  End = Token.getEndLoc();
  if (Token.isNot(AsmToken::Identifier))
    return ParseStatus::NoMatch;
  Register = matchRegister(Token.getIdentifier());
  if (!Register)
    return ParseStatus::NoMatch;
  Lex();
  return ParseStatus::Success;
}

bool TPAsmParser::parseRegister(MCRegister &Register, SMLoc &Start,
                                SMLoc &End) {
  if (!tryParseRegister(Register, Start, End).isSuccess())
    return Error(Start, "expected a register");
  return false;
}

/// Whether `(` and a register come next; `(` may also begin an expression.
bool TPAsmParser::isAtBaseRegister() {
  if (getTok().isNot(AsmToken::LParen))
    return false;
  AsmToken Next = getLexer().peekTok();
  return Next.is(AsmToken::Identifier) && matchRegister(Next.getIdentifier());
}

bool TPAsmParser::parseBaseRegister(OperandVector &Operands) {
  Operands.push_back(TPOperand::createToken("(", getTok().getLoc()));
  Lex();
  MCRegister Register;
  SMLoc Start, End;
  if (parseRegister(Register, Start, End))
    return true;
  Operands.push_back(TPOperand::createRegister(Register, Start, End));
  Operands.push_back(TPOperand::createToken(")", getTok().getLoc()));
  return parseToken(AsmToken::RParen, "expected ')' after the base register");
}

/// Parses `%hi(expression)` or `%lo(expression)`.
bool TPAsmParser::parseHalfOfAddress(OperandVector &Operands) {
  SMLoc Start = getTok().getLoc();
  Lex();
  auto Specifier = TPII::MO_None;
  if (getTok().is(AsmToken::Identifier))
    Specifier = StringSwitch<TPII::OperandFlags>(getTok().getIdentifier())
                    .Case("hi", TPII::MO_HI)
                    .Case("lo", TPII::MO_LO)
                    .Default(TPII::MO_None);
  if (Specifier == TPII::MO_None)
    return Error(Start, "expected %hi or %lo");
  Lex();
  const MCExpr *Expression;
  SMLoc End;
  if (parseToken(AsmToken::LParen, "expected '(' after %hi or %lo") ||
      getParser().parseExpression(Expression, End))
    return true;
  End = getTok().getEndLoc();
  if (parseToken(AsmToken::RParen, "expected ')'"))
    return true;
  Operands.push_back(TPOperand::createExpression(
      MCSpecifierExpr::create(Expression, Specifier, getContext(), Start),
      Start, End));
  return false;
}

bool TPAsmParser::parseExpressionOperand(OperandVector &Operands) {
  SMLoc Start = getTok().getLoc(), End;
  const MCExpr *Expression;
  if (getParser().parseExpression(Expression, End))
    return true;
  Operands.push_back(TPOperand::createExpression(Expression, Start, End));
  return false;
}

ParseStatus TPAsmParser::parseSymbol(OperandVector &Operands) {
  if (getTok().is(AsmToken::Percent) || isAtBaseRegister())
    return ParseStatus::NoMatch;
  return parseExpressionOperand(Operands) ? ParseStatus::Failure
                                          : ParseStatus::Success;
}

ParseStatus TPAsmParser::parseSpecialRegister(OperandVector &Operands) {
  const AsmToken &Token = getTok();
  if (Token.isNot(AsmToken::Identifier))
    return ParseStatus::NoMatch;
  SMLoc Start = Token.getLoc(), End = Token.getEndLoc();
  const auto *Register = TPSpecialRegister::lookupByName(Token.getIdentifier());
  if (!Register)
    return Error(Start, "there is no special register '" +
                            Token.getIdentifier() + "'");
  Lex();
  Operands.push_back(TPOperand::createExpression(
      MCConstantExpr::create(Register->Encoding, getContext()), Start, End));
  return ParseStatus::Success;
}

/// Parses an operand with the base register that may follow it.
bool TPAsmParser::parseOperand(OperandVector &Operands, StringRef Mnemonic) {
  ParseStatus Custom = MatchOperandParserImpl(Operands, Mnemonic);
  if (Custom.isFailure())
    return true;
  if (Custom.isNoMatch() && !isAtBaseRegister()) {
    MCRegister Register;
    SMLoc Start, End;
    if (tryParseRegister(Register, Start, End).isSuccess())
      Operands.push_back(TPOperand::createRegister(Register, Start, End));
    else if (getTok().is(AsmToken::Percent) ? parseHalfOfAddress(Operands)
                                            : parseExpressionOperand(Operands))
      return true;
  }
  return getTok().is(AsmToken::LParen) && parseBaseRegister(Operands);
}

bool TPAsmParser::parseInstruction(ParseInstructionInfo &Info, StringRef Name,
                                   SMLoc NameLoc, OperandVector &Operands) {
  Operands.push_back(TPOperand::createToken(Name, NameLoc));
  if (getTok().isNot(AsmToken::EndOfStatement)) {
    do {
      if (parseOperand(Operands, Name))
        return true;
    } while (parseOptionalToken(AsmToken::Comma));
  }
  return parseEOL();
}

//===----------------------------------------------------------------------===//
// Matching
//===----------------------------------------------------------------------===//

unsigned TPAsmParser::checkTargetMatchPredicate(MCInst &Inst) {
  if (Inst.getOpcode() != TP::EXT && Inst.getOpcode() != TP::INS)
    return Match_Success;
  unsigned NumOperands = Inst.getNumOperands();
  if (Inst.getOperand(NumOperands - 2).getImm() >
      Inst.getOperand(NumOperands - 1).getImm())
    return Match_ReversedBitField;
  return Match_Success;
}

/// Whether an instruction of this name has a `(` as its operand `Index`.
static bool expectsParenthesis(StringRef Mnemonic, uint64_t Index) {
  auto Entries = std::equal_range(
      std::begin(MatchTable0), std::end(MatchTable0), Mnemonic, LessOpcode());
  return any_of(make_range(Entries), [&](const MatchEntry &Entry) {
    return Index <= std::size(Entry.Classes) &&
           Entry.Classes[Index - 1] == MCK__40_;
  });
}

bool TPAsmParser::reportMismatch(unsigned MatchResult, SMLoc Loc,
                                 const OperandVector &Operands,
                                 uint64_t ErrorInfo) {
  StringRef Mnemonic = static_cast<TPOperand &>(*Operands[0]).getToken();
  if (MatchResult == Match_MnemonicFail)
    return Error(Loc,
                 "unknown instruction '" + Mnemonic + "'" +
                     TPMnemonicSpellCheck(Mnemonic, getAvailableFeatures(), 0));
  if (MatchResult == Match_ReversedBitField) {
    const MCParsedAsmOperand &Lowest = *Operands[Operands.size() - 2];
    return Error(Lowest.getStartLoc(),
                 "lowest bit of the field is above its highest bit");
  }
  if (ErrorInfo >= Operands.size())
    return Error(Loc, "too few operands for instruction '" + Mnemonic + "'");
  SMLoc OperandLoc = Operands[ErrorInfo]->getStartLoc();
  if (const char *Diagnostic =
          getMatchKindDiag(static_cast<TPMatchResultTy>(MatchResult)))
    return Error(OperandLoc, Diagnostic);
  if (expectsParenthesis(Mnemonic, ErrorInfo))
    return Error(OperandLoc, "expected '(' and a base register");
  return Error(OperandLoc,
               "too many operands for instruction '" + Mnemonic + "'");
}

bool TPAsmParser::matchAndEmitInstruction(SMLoc Loc, unsigned &Opcode,
                                          OperandVector &Operands,
                                          MCStreamer &Out, uint64_t &ErrorInfo,
                                          bool MatchingInlineAsm) {
  MCInst Inst;
  unsigned Result =
      MatchInstructionImpl(Operands, Inst, ErrorInfo, MatchingInlineAsm);
  if (Result != Match_Success)
    return reportMismatch(Result, Loc, Operands, ErrorInfo);
  Inst.setLoc(Loc);
  Opcode = Inst.getOpcode();
  switch (Opcode) {
  case TP::LI:
    emitLoadImmediate(Inst, Out);
    break;
  case TP::LA:
    emitLoadAddress(Inst, Out);
    break;
  default:
    Out.emitInstruction(Inst, getSTI());
    break;
  }
  return false;
}

//===----------------------------------------------------------------------===//
// Macros
//===----------------------------------------------------------------------===//

void TPAsmParser::emitLoadImmediate(MCInst &Inst, MCStreamer &Out) {
  MCRegister Destination = Inst.getOperand(0).getReg();
  auto Value = static_cast<int32_t>(Inst.getOperand(1).getImm());
  int64_t High = uint32_t(Value) >> 16, Low = uint32_t(Value) & 0xffff;
  auto Emit = [&](MCInst Part) {
    Part.setLoc(Inst.getLoc());
    Out.emitInstruction(Part, getSTI());
  };
  if (isInt<16>(Value))
    return Emit(MCInstBuilder(TP::ADDI)
                    .addReg(Destination)
                    .addReg(TP::R0)
                    .addImm(Value));
  if (High != 0)
    Emit(MCInstBuilder(TP::LUI).addReg(Destination).addImm(High));
  if (Low != 0)
    Emit(MCInstBuilder(TP::ORI)
             .addReg(Destination)
             .addReg(High != 0 ? Destination : MCRegister(TP::R0))
             .addImm(Low));
}

void TPAsmParser::emitLoadAddress(MCInst &Inst, MCStreamer &Out) {
  const MCOperand &Symbol = Inst.getOperand(1);
  if (Symbol.isImm())
    return emitLoadImmediate(Inst, Out);
  MCRegister Destination = Inst.getOperand(0).getReg();
  auto Half = [&](TPII::OperandFlags Specifier) {
    return MCSpecifierExpr::create(Symbol.getExpr(), Specifier, getContext(),
                                   Inst.getLoc());
  };
  Out.emitInstruction(
      MCInstBuilder(TP::LUI).addReg(Destination).addExpr(Half(TPII::MO_HI)),
      getSTI());
  Out.emitInstruction(MCInstBuilder(TP::ADDI)
                          .addReg(Destination)
                          .addReg(Destination)
                          .addExpr(Half(TPII::MO_LO)),
                      getSTI());
}

extern "C" LLVM_EXTERNAL_VISIBILITY void LLVMInitializeTPAsmParser() {
  RegisterMCAsmParser<TPAsmParser> X(getTheTPTarget());
}
