//===- TPBuiltinLowering.cpp - Calls of the TP builtins -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/FloatingPoint/Check/CheckFailure.h"
#include "llvm-backend/MCTargetDesc/TPBaseInfo.h"
#include "llvm-backend/MCTargetDesc/TPMCTargetDesc.h"
#include "llvm-backend/TPBuiltins.h"
#include "llvm-backend/TPISelLowering.h"
#include "llvm-backend/TPSubtarget.h"
#include "llvm/CodeGen/SelectionDAG.h"
#include "llvm/IR/DiagnosticInfo.h"
#include "llvm/IR/Function.h"

using namespace llvm;

namespace {

/// One call of a builtin on its way to the node.
class BuiltinCall {
  SelectionDAG &DAG;
  const SDLoc &DL;
  ArrayRef<SDValue> Arguments;
  SmallVectorImpl<SDValue> &Results;
  SDValue Chain;
  bool NoMerge;

public:
  BuiltinCall(TargetLowering::CallLoweringInfo &CLI,
              SmallVectorImpl<SDValue> &Results)
      : DAG(CLI.DAG), DL(CLI.DL), Arguments(CLI.OutVals), Results(Results),
        Chain(CLI.Chain), NoMerge(CLI.NoMerge) {}

  /// Emits the node; returns the chain behind the call.
  SDValue lower(TPBuiltin::ID Builtin, const Function &Callee);

private:
  SDValue pure(unsigned Opcode, MVT Type);
  SDValue specialRegister(unsigned Opcode, unsigned Number);
  SDValue effect(unsigned Opcode, ArrayRef<SDValue> Operands);
  SDValue profile(unsigned Opcode, SDValue Marker);
  SDValue atomic(unsigned Opcode);
  /// Puts words into registers that a node with \p Glue as operand reads.
  void copyToRegisters(ArrayRef<MCPhysReg> Registers, ArrayRef<SDValue> Words,
                       SDValue &Glue);
  SDValue hostCall(SDValue Service);
  SDValue checkFailed(SDValue Code);
  SDValue immediate(const Function &Callee, uint32_t Limit = 0x10000);
};

} // namespace

/// A node that depends on the arguments only.
SDValue BuiltinCall::pure(unsigned Opcode, MVT Type) {
  Results.push_back(DAG.getNode(Opcode, DL, Type, Arguments));
  return Chain;
}

SDValue BuiltinCall::specialRegister(unsigned Opcode, unsigned Number) {
  SDValue Special = DAG.getTargetConstant(Number, DL, MVT::i32);
  if (Opcode == TPISD::READ_CONSTANT) {
    Results.push_back(DAG.getNode(Opcode, DL, MVT::i32, Special));
    return Chain;
  }
  SDValue Read = DAG.getNode(Opcode, DL, DAG.getVTList(MVT::i32, MVT::Other),
                             Chain, Special);
  Results.push_back(Read);
  return Read.getValue(1);
}

/// A node without result.
SDValue BuiltinCall::effect(unsigned Opcode, ArrayRef<SDValue> Operands) {
  SmallVector<SDValue, 4> Ops = {Chain};
  append_range(Ops, Operands);
  return DAG.getNode(Opcode, DL, MVT::Other, Ops);
}

/// A message to the observer: \p Marker, then the other arguments.
SDValue BuiltinCall::profile(unsigned Opcode, SDValue Marker) {
  SmallVector<SDValue, 3> Ops = {Chain, Marker};
  append_range(Ops, Arguments.drop_front());
  const auto &Lowering =
      static_cast<const TPTargetLowering &>(DAG.getTargetLoweringInfo());
  return DAG.getMemIntrinsicNode(
      Opcode, DL, DAG.getVTList(MVT::Other), Ops, MVT::i32,
      MachinePointerInfo(Lowering.getProfilePort()), Align(4),
      MachineMemOperand::MOStore, LocationSize::precise(4));
}

SDValue BuiltinCall::atomic(unsigned Opcode) {
  SmallVector<SDValue, 4> Ops = {Chain};
  append_range(Ops, Arguments);
  SDValue Result =
      DAG.getNode(Opcode, DL, DAG.getVTList(MVT::i32, MVT::Other), Ops);
  Results.push_back(Result);
  return Result.getValue(1);
}

void BuiltinCall::copyToRegisters(ArrayRef<MCPhysReg> Registers,
                                  ArrayRef<SDValue> Words, SDValue &Glue) {
  for (auto [Reg, Word] : zip_equal(Registers, Words)) {
    Chain = DAG.getCopyToReg(Chain, DL, Reg, Word, Glue);
    Glue = Chain.getValue(1);
  }
}

SDValue BuiltinCall::checkFailed(SDValue Code) {
  SDValue Glue;
  copyToRegisters({TP::R4, TP::R5, TP::R6, TP::R7, TP::R8, TP::R9},
                  Arguments.drop_front(), Glue);
  SDValue Break =
      DAG.getNode(TPISD::FP_CHECK_FAILED, DL, MVT::Other, {Chain, Code, Glue});
  DAG.addNoMergeSiteInfo(Break.getNode(), NoMerge);
  return Break;
}

SDValue BuiltinCall::hostCall(SDValue Service) {
  SDValue Glue;
  copyToRegisters({TP::R4, TP::R5, TP::R6}, Arguments.drop_front(), Glue);
  Chain = DAG.getNode(TPISD::HOSTCALL, DL, DAG.getVTList(MVT::Other, MVT::Glue),
                      {Chain, Service, Glue});
  SDValue Result =
      DAG.getCopyFromReg(Chain, DL, TP::R2, MVT::i32, Chain.getValue(1));
  Results.push_back(Result);
  return Result.getValue(1);
}

/// The first argument, which has to be a constant below \p Limit.
SDValue BuiltinCall::immediate(const Function &Callee, uint32_t Limit) {
  if (auto *Value = dyn_cast<ConstantSDNode>(Arguments[0]))
    if (Value->getZExtValue() < Limit)
      return DAG.getTargetConstant(Value->getZExtValue(), DL, MVT::i32);
  DAG.getContext()->diagnose(DiagnosticInfoUnsupported(
      DAG.getMachineFunction().getFunction(),
      "the first argument of '" + Callee.getName() +
          "' has to be a constant from 0 to " + Twine(Limit - 1),
      DL.getDebugLoc()));
  return DAG.getTargetConstant(0, DL, MVT::i32);
}

SDValue BuiltinCall::lower(TPBuiltin::ID Builtin, const Function &Callee) {
  using TPBuiltin::ID;
  switch (Builtin) {
  case ID::None:
    break;
  case ID::rcp:
    return pure(TPISD::RCP, MVT::f32);
  case ID::rsqrt:
    return pure(TPISD::RSQRT, MVT::f32);
  case ID::sin:
    return pure(TPISD::SIN, MVT::f32);
  case ID::cos:
    return pure(TPISD::COS, MVT::f32);
  case ID::trunc_w:
    return pure(TPISD::TRUNC_W, MVT::i32);
  case ID::round_w:
    return pure(TPISD::ROUND_W, MVT::i32);
  case ID::floor_w:
    return pure(TPISD::FLOOR_W, MVT::i32);
  case ID::ceil_w:
    return pure(TPISD::CEIL_W, MVT::i32);
  case ID::thread_id:
    return specialRegister(TPISD::READ_CONSTANT, TPSpecialRegister::thread);
  case ID::tp_id:
    return specialRegister(TPISD::READ_CONSTANT, TPSpecialRegister::tp);
  case ID::tm_id:
    return specialRegister(TPISD::READ_CONSTANT, TPSpecialRegister::tm);
  case ID::thread_count:
    return specialRegister(TPISD::READ_CONSTANT, TPSpecialRegister::nthread);
  case ID::tp_count:
    return specialRegister(TPISD::READ_CONSTANT, TPSpecialRegister::ntp);
  case ID::tm_count:
    return specialRegister(TPISD::READ_CONSTANT, TPSpecialRegister::ntm);
  case ID::local_store_bytes:
    return specialRegister(TPISD::READ_CONSTANT, TPSpecialRegister::lssize);
  case ID::cycle:
    return specialRegister(TPISD::READ_COUNTER, TPSpecialRegister::cycle);
  case ID::cycle_high:
    return specialRegister(TPISD::READ_COUNTER, TPSpecialRegister::cycleh);
  case ID::instret:
    return specialRegister(TPISD::READ_COUNTER, TPSpecialRegister::instret);
  case ID::instret_high:
    return specialRegister(TPISD::READ_COUNTER, TPSpecialRegister::instreth);
  case ID::prof:
    return profile(TPISD::PROF, immediate(Callee));
  case ID::profv:
    return profile(TPISD::PROFV, immediate(Callee));
  case ID::trap_break:
    return effect(TPISD::BREAK, immediate(Callee, tp::CheckFailure::FirstCode));
  case ID::fp_check_failed:
    return checkFailed(immediate(Callee));
  case ID::sleep:
    return effect(TPISD::SLEEP, Arguments);
  case ID::halt:
    return effect(TPISD::HALT, Arguments);
  case ID::barrier:
    return effect(TPISD::BARRIER, {});
  case ID::sync:
    return effect(TPISD::SYNC, {});
  case ID::hostcall:
    return hostCall(immediate(Callee));
  case ID::stream_push:
    return atomic(TPISD::STREAM_PUSH);
  case ID::stream_pop:
    return atomic(TPISD::STREAM_POP);
  }
  llvm_unreachable("not a builtin");
}

/// The types of a builtin's call as its clang type string promises them: `f` is
/// a float, `v` nothing, everything else one word.
static bool hasTypesOf(const char *ClangType,
                       const TargetLowering::CallLoweringInfo &CLI) {
  SmallVector<MVT, 6> Types;
  for (const char *C = ClangType; *C; ++C) {
    if (*C == 'f')
      Types.push_back(MVT::f32);
    else if (*C == 'v')
      Types.push_back(MVT::Other);
    else if (*C == 'i')
      Types.push_back(MVT::i32);
  }
  ArrayRef<MVT> Arguments = ArrayRef(Types).drop_front();
  bool ResultFits = Types[0] == MVT::Other
                        ? CLI.Ins.empty()
                        : CLI.Ins.size() == 1 && CLI.Ins[0].VT == Types[0];
  return ResultFits && CLI.Outs.size() == Arguments.size() &&
         all_of(zip(CLI.Outs, Arguments), [](const auto &Pair) {
           return std::get<0>(Pair).VT == std::get<1>(Pair);
         });
}

static bool hasTypesOf(TPBuiltin::ID Builtin,
                       const TargetLowering::CallLoweringInfo &CLI) {
  switch (Builtin) {
#define TP_BUILTIN(Name, ClangType, ClangAttributes, Effect)                   \
  case TPBuiltin::ID::Name:                                                    \
    return hasTypesOf(ClangType, CLI);
#include "llvm-backend/TPBuiltins.def"
  case TPBuiltin::ID::None:
    break;
  }
  return false;
}

SDValue
TPTargetLowering::lowerBuiltinCall(CallLoweringInfo &CLI,
                                   SmallVectorImpl<SDValue> &InVals) const {
  auto *Global = dyn_cast<GlobalAddressSDNode>(CLI.Callee);
  if (!Global)
    return SDValue();
  auto *Callee = dyn_cast<Function>(Global->getGlobal());
  if (!Callee)
    return SDValue();
  TPBuiltin::ID Builtin = TPBuiltin::getID(*Callee);
  if (Builtin == TPBuiltin::ID::None || !hasTypesOf(Builtin, CLI))
    return SDValue();
  if ((Builtin == TPBuiltin::ID::sin || Builtin == TPBuiltin::ID::cos) &&
      !STI.hasTrigonometry())
    return SDValue();
  CLI.IsTailCall = false;
  return BuiltinCall(CLI, InVals).lower(Builtin, *Callee);
}
