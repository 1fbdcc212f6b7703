//===- TPCallLowering.cpp - Calls, arguments and returns ------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/MCTargetDesc/TPMCTargetDesc.h"
#include "llvm-backend/TPISelLowering.h"
#include "llvm-backend/TPMachineFunctionInfo.h"
#include "llvm-backend/TPSubtarget.h"
#include "llvm/CodeGen/CallingConvLower.h"
#include "llvm/CodeGen/MachineFrameInfo.h"
#include "llvm/CodeGen/SelectionDAG.h"
#include "llvm/IR/DiagnosticInfo.h"
#include "llvm/IR/InstrTypes.h"
#include "llvm/IR/Instructions.h"
#include "llvm/Target/TargetMachine.h"

using namespace llvm;

#include "TPGenCallingConv.inc"

static SDValue extendToLocation(SDValue Value, const CCValAssign &Location,
                                const SDLoc &DL, SelectionDAG &DAG) {
  switch (Location.getLocInfo()) {
  case CCValAssign::SExt:
    return DAG.getNode(ISD::SIGN_EXTEND, DL, Location.getLocVT(), Value);
  case CCValAssign::ZExt:
    return DAG.getNode(ISD::ZERO_EXTEND, DL, Location.getLocVT(), Value);
  case CCValAssign::AExt:
    return DAG.getNode(ISD::ANY_EXTEND, DL, Location.getLocVT(), Value);
  default:
    return Value;
  }
}

static SDValue truncateFromLocation(SDValue Value, const CCValAssign &Location,
                                    const SDLoc &DL, SelectionDAG &DAG) {
  if (Location.getLocVT() == Location.getValVT())
    return Value;
  EVT Narrow = Location.getValVT();
  if (Location.getLocInfo() == CCValAssign::SExt)
    Value = DAG.getNode(ISD::AssertSext, DL, Location.getLocVT(), Value,
                        DAG.getValueType(Narrow));
  else if (Location.getLocInfo() == CCValAssign::ZExt)
    Value = DAG.getNode(ISD::AssertZext, DL, Location.getLocVT(), Value,
                        DAG.getValueType(Narrow));
  return DAG.getNode(ISD::TRUNCATE, DL, Narrow, Value);
}

//===----------------------------------------------------------------------===//
// Arguments
//===----------------------------------------------------------------------===//

SDValue TPTargetLowering::LowerFormalArguments(
    SDValue Chain, CallingConv::ID CallConv, bool IsVarArg,
    const SmallVectorImpl<ISD::InputArg> &Ins, const SDLoc &DL,
    SelectionDAG &DAG, SmallVectorImpl<SDValue> &InVals) const {
  MachineFunction &MF = DAG.getMachineFunction();
  MachineFrameInfo &MFI = MF.getFrameInfo();
  SmallVector<CCValAssign, 16> Locations;
  CCState State(CallConv, IsVarArg, MF, Locations, *DAG.getContext());
  State.AnalyzeFormalArguments(Ins, CC_TP);

  const bool ReplacesArguments =
      any_of(MF.getFunction(), [](const BasicBlock &Block) {
        return Block.getTerminatingMustTailCall();
      });
  for (const CCValAssign &Location : Locations) {
    MVT VT = Location.getLocVT();
    SDValue Value;
    if (Location.isRegLoc()) {
      Register Reg = MF.addLiveIn(Location.getLocReg(), getRegClassFor(VT));
      Value = DAG.getCopyFromReg(Chain, DL, Reg, VT);
    } else {
      int Index = MFI.CreateFixedObject(4, Location.getLocMemOffset(),
                                        /*IsImmutable=*/!ReplacesArguments);
      Value = DAG.getLoad(VT, DL, Chain, DAG.getFrameIndex(Index, MVT::i32),
                          MachinePointerInfo::getFixedStack(MF, Index));
    }
    InVals.push_back(truncateFromLocation(Value, Location, DL, DAG));
  }

  if (IsVarArg)
    MF.getInfo<TPMachineFunctionInfo>()->setVarArgsFrameIndex(
        MFI.CreateFixedObject(4, State.getStackSize(), true));
  return Chain;
}

//===----------------------------------------------------------------------===//
// Calls
//===----------------------------------------------------------------------===//

bool TPTargetLowering::mayBeEmittedAsTailCall(const CallInst *CI) const {
  return CI->isTailCall();
}

/// A musttail call has its caller's prototype, so that its arguments are where
/// the caller's own came in.
static bool isMustTail(const TargetLowering::CallLoweringInfo &CLI) {
  return CLI.CB && CLI.CB->isMustTailCall();
}

bool TPTargetLowering::isEligibleForTailCall(const CallLoweringInfo &CLI,
                                             unsigned StackBytes) const {
  if (isMustTail(CLI))
    return true;
  // Stack arguments and copies of structs would have to outlive this frame.
  if (CLI.IsVarArg || StackBytes != 0)
    return false;
  for (const ISD::OutputArg &Out : CLI.Outs)
    if (Out.Flags.isByVal())
      return false;
  const Function &Caller = CLI.DAG.getMachineFunction().getFunction();
  // A naked function's frame is its own affair.
  return !Caller.hasFnAttribute(Attribute::Naked);
}

/// Whether the struct that a musttail call passes is the one that its caller
/// got in the same place.
static bool isOwnArgument(const TargetLowering::CallLoweringInfo &CLI,
                          const ISD::OutputArg &Out) {
  const Function &Caller = CLI.DAG.getMachineFunction().getFunction();
  return CLI.CB->getArgOperand(Out.OrigArgIndex) ==
         Caller.getArg(Out.OrigArgIndex);
}

/// Moves the structs that a musttail call passes from the copies that \p Values
/// point to into the memory of the caller's own arguments, which outlives its
/// frame. Returns the new chain.
static SDValue
replaceByValArguments(const TargetLowering::CallLoweringInfo &CLI,
                      ArrayRef<CCValAssign> Locations,
                      MutableArrayRef<SDValue> Values, SDValue Chain) {
  SelectionDAG &DAG = CLI.DAG;
  MachineFunction &MF = DAG.getMachineFunction();
  for (auto [Out, Location, Value] : zip_equal(CLI.Outs, Locations, Values)) {
    if (!Out.Flags.isByVal() || isOwnArgument(CLI, Out))
      continue;
    SDValue Memory;
    if (Location.isRegLoc()) {
      Register Reg = MF.addLiveIn(Location.getLocReg(), &TP::GPRRegClass);
      Memory = DAG.getCopyFromReg(Chain, CLI.DL, Reg, MVT::i32);
    } else {
      int Index = MF.getFrameInfo().CreateFixedObject(
          4, Location.getLocMemOffset(), /*IsImmutable=*/false);
      Memory = DAG.getLoad(MVT::i32, CLI.DL, Chain,
                           DAG.getFrameIndex(Index, MVT::i32),
                           MachinePointerInfo::getFixedStack(MF, Index));
      Chain = Memory.getValue(1);
    }
    if (const uint64_t Size = Out.Flags.getByValSize())
      Chain = DAG.getMemcpy(
          Chain, CLI.DL, Memory, Value, DAG.getConstant(Size, CLI.DL, MVT::i32),
          Out.Flags.getNonZeroByValAlign(), /*isVol=*/false,
          /*AlwaysInline=*/false, /*CI=*/nullptr, /*OverrideTailCall=*/false,
          MachinePointerInfo(), MachinePointerInfo());
    Value = Memory;
  }
  return Chain;
}

SDValue TPTargetLowering::LowerCall(CallLoweringInfo &CLI,
                                    SmallVectorImpl<SDValue> &InVals) const {
  if (SDValue Chain = lowerBuiltinCall(CLI, InVals))
    return Chain;

  SelectionDAG &DAG = CLI.DAG;
  const SDLoc &DL = CLI.DL;
  MachineFunction &MF = DAG.getMachineFunction();
  SDValue Chain = CLI.Chain;
  SDValue Callee = CLI.Callee;

  SmallVector<CCValAssign, 16> Locations;
  CCState State(CLI.CallConv, CLI.IsVarArg, MF, Locations, *DAG.getContext());
  for (auto [Number, Out] : enumerate(CLI.Outs)) {
    CCAssignFn *Assign = Out.Flags.isVarArg() ? CC_TP_Variadic : CC_TP;
    Assign(Number, Out.VT, Out.VT, CCValAssign::Full, Out.Flags, Out.OrigTy,
           State);
  }
  const unsigned StackBytes = State.getStackSize();

  CLI.IsTailCall = CLI.IsTailCall && isEligibleForTailCall(CLI, StackBytes);
  const bool MustTail = isMustTail(CLI);
  if (MustTail && !CLI.IsTailCall)
    DAG.getContext()->diagnose(DiagnosticInfoUnsupported(
        MF.getFunction(),
        "musttail call of a function that returns more than two words",
        DL.getDebugLoc()));

  // The copies come first: copying a large one is itself a call.
  SmallVector<SDValue, 16> Values(CLI.OutVals.begin(), CLI.OutVals.end());
  unsigned NumCopies = 0;
  for (auto [Number, Out] : enumerate(CLI.Outs)) {
    if (!Out.Flags.isByVal() || (MustTail && isOwnArgument(CLI, Out)))
      continue;
    const uint64_t Size = Out.Flags.getByValSize();
    const Align Alignment =
        std::max(Out.Flags.getNonZeroByValAlign(), Align(4));
    int Index = MF.getInfo<TPMachineFunctionInfo>()->getByValCopy(
        MF, NumCopies++, std::max<uint64_t>(Size, 1), Alignment);
    SDValue Copy = DAG.getFrameIndex(Index, MVT::i32);
    if (Size != 0)
      Chain = DAG.getMemcpy(
          Chain, DL, Copy, Values[Number], DAG.getConstant(Size, DL, MVT::i32),
          Out.Flags.getNonZeroByValAlign(),
          /*isVol=*/false, /*AlwaysInline=*/false,
          /*CI=*/nullptr, /*OverrideTailCall=*/false,
          MachinePointerInfo::getFixedStack(MF, Index), MachinePointerInfo());
    Values[Number] = Copy;
  }

  if (MustTail) {
    // What comes in is read before what goes out takes its place.
    Chain = DAG.getStackArgumentTokenFactor(Chain);
    Chain = replaceByValArguments(CLI, Locations, Values, Chain);
  }

  if (!CLI.IsTailCall)
    Chain = DAG.getCALLSEQ_START(Chain, StackBytes, 0, DL);

  SmallVector<std::pair<Register, SDValue>, 16> Registers;
  SmallVector<SDValue, 8> Stores;
  for (auto [Location, Original] : zip_equal(Locations, Values)) {
    SDValue Value = extendToLocation(Original, Location, DL, DAG);
    if (Location.isRegLoc()) {
      Registers.emplace_back(Location.getLocReg(), Value);
      continue;
    }
    const int64_t Offset = Location.getLocMemOffset();
    if (CLI.IsTailCall) {
      int Index = MF.getFrameInfo().CreateFixedObject(4, Offset,
                                                      /*IsImmutable=*/false);
      Stores.push_back(
          DAG.getStore(Chain, DL, Value, DAG.getFrameIndex(Index, MVT::i32),
                       MachinePointerInfo::getFixedStack(MF, Index)));
      continue;
    }
    SDValue Address = DAG.getMemBasePlusOffset(
        DAG.getCopyFromReg(Chain, DL, TP::R29, MVT::i32),
        TypeSize::getFixed(Offset), DL);
    Stores.push_back(DAG.getStore(Chain, DL, Value, Address,
                                  MachinePointerInfo::getStack(MF, Offset)));
  }
  if (!Stores.empty())
    Chain = DAG.getNode(ISD::TokenFactor, DL, MVT::Other, Stores);

  MachineFunction::CallSiteInfo CallSite;
  if (MF.getTarget().Options.EmitCallSiteInfo)
    for (auto [Location, Out] : zip_equal(Locations, CLI.Outs))
      if (Location.isRegLoc())
        CallSite.ArgRegPairs.emplace_back(Location.getLocReg(),
                                          Out.OrigArgIndex);

  SDValue Glue;
  for (auto &[Reg, Value] : Registers) {
    Chain = DAG.getCopyToReg(Chain, DL, Reg, Value, Glue);
    Glue = Chain.getValue(1);
  }

  if (auto *Global = dyn_cast<GlobalAddressSDNode>(Callee))
    Callee = DAG.getTargetGlobalAddress(Global->getGlobal(), DL, MVT::i32,
                                        Global->getOffset());
  else if (auto *Symbol = dyn_cast<ExternalSymbolSDNode>(Callee))
    Callee = DAG.getTargetExternalSymbol(Symbol->getSymbol(), MVT::i32);

  SmallVector<SDValue, 20> Ops = {Chain, Callee};
  for (auto &[Reg, Value] : Registers)
    Ops.push_back(DAG.getRegister(Reg, Value.getValueType()));
  Ops.push_back(DAG.getRegisterMask(
      STI.getRegisterInfo()->getCallPreservedMask(MF, CLI.CallConv)));
  if (Glue)
    Ops.push_back(Glue);

  if (CLI.IsTailCall) {
    MF.getFrameInfo().setHasTailCall();
    SDValue TailCall = DAG.getNode(TPISD::TAIL_CALL, DL, MVT::Other, Ops);
    DAG.addCallSiteInfo(TailCall.getNode(), std::move(CallSite));
    return TailCall;
  }

  Chain =
      DAG.getNode(TPISD::CALL, DL, DAG.getVTList(MVT::Other, MVT::Glue), Ops);
  DAG.addNoMergeSiteInfo(Chain.getNode(), CLI.NoMerge);
  DAG.addCallSiteInfo(Chain.getNode(), std::move(CallSite));
  Glue = Chain.getValue(1);
  Chain = DAG.getCALLSEQ_END(Chain, StackBytes, 0, Glue, DL);
  Glue = Chain.getValue(1);

  SmallVector<CCValAssign, 4> Results;
  CCState ResultState(CLI.CallConv, CLI.IsVarArg, MF, Results,
                      *DAG.getContext());
  ResultState.AnalyzeCallResult(CLI.Ins, RetCC_TP);
  for (const CCValAssign &Location : Results) {
    SDValue Value = DAG.getCopyFromReg(Chain, DL, Location.getLocReg(),
                                       Location.getLocVT(), Glue);
    Chain = Value.getValue(1);
    Glue = Value.getValue(2);
    InVals.push_back(truncateFromLocation(Value, Location, DL, DAG));
  }
  return Chain;
}

//===----------------------------------------------------------------------===//
// Returns
//===----------------------------------------------------------------------===//

bool TPTargetLowering::CanLowerReturn(
    CallingConv::ID CallConv, MachineFunction &MF, bool IsVarArg,
    const SmallVectorImpl<ISD::OutputArg> &Outs, LLVMContext &Context,
    const Type *) const {
  SmallVector<CCValAssign, 4> Locations;
  CCState State(CallConv, IsVarArg, MF, Locations, Context);
  return State.CheckReturn(Outs, RetCC_TP);
}

SDValue
TPTargetLowering::LowerReturn(SDValue Chain, CallingConv::ID CallConv,
                              bool IsVarArg,
                              const SmallVectorImpl<ISD::OutputArg> &Outs,
                              const SmallVectorImpl<SDValue> &OutVals,
                              const SDLoc &DL, SelectionDAG &DAG) const {
  SmallVector<CCValAssign, 4> Locations;
  CCState State(CallConv, IsVarArg, DAG.getMachineFunction(), Locations,
                *DAG.getContext());
  State.AnalyzeReturn(Outs, RetCC_TP);

  SDValue Glue;
  SmallVector<SDValue, 6> Ops = {Chain};
  for (auto [Location, Original] : zip_equal(Locations, OutVals)) {
    SDValue Value = extendToLocation(Original, Location, DL, DAG);
    Chain = DAG.getCopyToReg(Chain, DL, Location.getLocReg(), Value, Glue);
    Glue = Chain.getValue(1);
    Ops.push_back(DAG.getRegister(Location.getLocReg(), Location.getLocVT()));
  }
  Ops[0] = Chain;
  if (Glue)
    Ops.push_back(Glue);
  return DAG.getNode(TPISD::RET, DL, MVT::Other, Ops);
}
