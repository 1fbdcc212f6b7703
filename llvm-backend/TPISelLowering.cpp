//===- TPISelLowering.cpp - How the TP sees the selection DAG -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/TPISelLowering.h"
#include "llvm-backend/MCTargetDesc/TPBaseInfo.h"
#include "llvm-backend/MCTargetDesc/TPMCTargetDesc.h"
#include "llvm-backend/TPAtomicLoops.h"
#include "llvm-backend/TPInstrInfo.h"
#include "llvm-backend/TPMachineFunctionInfo.h"
#include "llvm-backend/TPSubtarget.h"
#include "llvm/CodeGen/MachineFrameInfo.h"
#include "llvm/CodeGen/SelectionDAG.h"
#include "llvm/IR/Instructions.h"
#include "llvm/IR/Intrinsics.h"

using namespace llvm;

TPTargetLowering::TPTargetLowering(const TargetMachine &TM,
                                   const TPSubtarget &STI)
    : TargetLowering(TM, STI), STI(STI), ProfilePort(TM) {
  addRegisterClass(MVT::i32, &TP::GPRRegClass);
  addRegisterClass(MVT::f32, &TP::FPRRegClass);
  computeRegisterProperties(STI.getRegisterInfo());

  setStackPointerRegisterToSaveRestore(TP::R29);
  setBooleanContents(ZeroOrOneBooleanContent);
  setMinFunctionAlignment(Align(4));
  setMinStackArgumentAlignment(Align(4));

  configureIntegers();
  configureFloats();
  configureMemory();
  configureControl();
}

void TPTargetLowering::configureIntegers() {
  setOperationAction({ISD::SDIVREM, ISD::UDIVREM, ISD::SMUL_LOHI,
                      ISD::UMUL_LOHI, ISD::ROTL, ISD::CTPOP, ISD::CTTZ,
                      ISD::CTTZ_ZERO_UNDEF, ISD::CTLZ_ZERO_UNDEF, ISD::BSWAP,
                      ISD::BITREVERSE, ISD::SELECT_CC},
                     MVT::i32, Expand);
  setOperationAction(ISD::SIGN_EXTEND_INREG, MVT::i1, Expand);
  setOperationAction({ISD::SHL_PARTS, ISD::SRL_PARTS, ISD::SRA_PARTS}, MVT::i32,
                     Custom);
  // The runtime has the functions for 128 bits; more is expanded before.
  setMaxDivRemBitWidthSupported(128);
  setMaxLargeFPConvertBitWidthSupported(128);
}

void TPTargetLowering::configureFloats() {
  // The compares with exchanged operands do.
  for (ISD::CondCode Condition : {ISD::SETOGT, ISD::SETOGE, ISD::SETUGT,
                                  ISD::SETUGE, ISD::SETGT, ISD::SETGE})
    setCondCodeAction(Condition, MVT::f32, Expand);

  setOperationAction({ISD::FCEIL, ISD::FFLOOR, ISD::FTRUNC, ISD::FRINT,
                      ISD::FNEARBYINT, ISD::FROUNDEVEN, ISD::FMINNUM,
                      ISD::FMAXNUM, ISD::FMINIMUMNUM, ISD::FMAXIMUMNUM},
                     MVT::f32, Legal);
  setOperationAction(ISD::LRINT, MVT::f32, Legal);
  // Without the instruction fma is a function of the library.
  setOperationAction(ISD::FMA, MVT::f32, STI.hasFMA() ? Legal : Expand);
  setOperationAction(
      {ISD::FSIN, ISD::FCOS, ISD::FSINCOS, ISD::FPOW, ISD::SELECT_CC}, MVT::f32,
      Expand);
  setOperationAction({ISD::STRICT_FSETCC, ISD::STRICT_FSETCCS}, MVT::f32,
                     Legal);
  setOperationAction(ISD::FREM, {MVT::f32, MVT::f64}, LibCall);
  setOperationAction(ISD::FCOPYSIGN, MVT::f32, Custom);
  setOperationAction({ISD::FP_TO_SINT_SAT, ISD::FP_TO_UINT_SAT}, MVT::i32,
                     Custom);

  // Half floats live as integers; the library converts them.
  for (MVT Half : {MVT::f16, MVT::bf16}) {
    for (MVT Wide : {MVT::f32, MVT::f64}) {
      setLoadExtAction(ISD::EXTLOAD, Wide, Half, Expand);
      setTruncStoreAction(Wide, Half, Expand);
    }
  }
  setOperationAction({ISD::FP16_TO_FP, ISD::FP_TO_FP16, ISD::BF16_TO_FP},
                     MVT::f32, Expand);
  // The expansion would cut off instead of rounding.
  setOperationAction(ISD::FP_TO_BF16, MVT::f32, Custom);
  setLoadExtAction(ISD::EXTLOAD, MVT::f64, MVT::f32, Expand);
  setTruncStoreAction(MVT::f64, MVT::f32, Expand);
}

void TPTargetLowering::configureMemory() {
  for (auto Extension : {ISD::EXTLOAD, ISD::SEXTLOAD, ISD::ZEXTLOAD})
    setLoadExtAction(Extension, MVT::i32, MVT::i1, Promote);
  setOperationAction({ISD::GlobalAddress, ISD::GlobalTLSAddress,
                      ISD::ConstantPool, ISD::JumpTable, ISD::BlockAddress},
                     MVT::i32, Custom);
  setOperationAction(ISD::DYNAMIC_STACKALLOC, MVT::i32, Expand);
  setOperationAction(
      {ISD::STACKSAVE, ISD::STACKRESTORE, ISD::VAARG, ISD::VACOPY, ISD::VAEND},
      MVT::Other, Expand);
  setOperationAction({ISD::VASTART, ISD::ATOMIC_FENCE}, MVT::Other, Custom);

  setMaxAtomicSizeInBitsSupported(32);
  setMinCmpXchgSizeInBits(32);

  // More than the four byte stores that merge. The search takes time quadratic
  // in the stores of a block, which whole-program optimization makes long.
  GatherAllAliasesMaxDepth = 8;

  // A load takes a hundred cycles, a store one: all loads of a copy go first.
  MaxGluedStoresPerMemcpy = 16;
  MaxStoresPerMemcpy = MaxStoresPerMemmove = 16;
  MaxStoresPerMemset = 32;
  MaxStoresPerMemcpyOptSize = MaxStoresPerMemmoveOptSize = 4;
  MaxStoresPerMemsetOptSize = 4;
  MaxLoadsPerMemcmp = 8;
  MaxLoadsPerMemcmpOptSize = 4;
}

void TPTargetLowering::configureControl() {
  setOperationAction({ISD::BR_CC, ISD::BR_JT}, MVT::Other, Expand);
  setOperationAction(ISD::BR_CC, {MVT::i32, MVT::f32}, Expand);
  setOperationAction({ISD::FRAMEADDR, ISD::RETURNADDR}, MVT::i32, Custom);
  setOperationAction(ISD::INTRINSIC_WO_CHAIN, MVT::Other, Custom);
  setOperationAction({ISD::TRAP, ISD::DEBUGTRAP}, MVT::Other, Legal);
}

//===----------------------------------------------------------------------===//
// Properties
//===----------------------------------------------------------------------===//

EVT TPTargetLowering::getSetCCResultType(const DataLayout &,
                                         LLVMContext &Context, EVT VT) const {
  if (VT.isVector())
    return VT.changeVectorElementType(Context, MVT::i32);
  return MVT::i32;
}

bool TPTargetLowering::isFMAFasterThanFMulAndFAdd(const MachineFunction &,
                                                  EVT VT) const {
  return STI.hasFMA() && VT == MVT::f32;
}

bool TPTargetLowering::isFPImmLegal(const APFloat &, EVT VT, bool) const {
  return VT == MVT::f32;
}

bool TPTargetLowering::isLegalAddressingMode(const DataLayout &,
                                             const AddrMode &AM, Type *,
                                             unsigned, Instruction *) const {
  if (AM.BaseGV || AM.ScalableOffset)
    return false;
  if (AM.Scale == 0)
    return isInt<16>(AM.BaseOffs);
  // Register plus register, or one register written as an index.
  if (AM.Scale == 1)
    return AM.HasBaseReg ? AM.BaseOffs == 0 : isInt<16>(AM.BaseOffs);
  return false;
}

bool TPTargetLowering::isTruncateFree(Type *From, Type *To) const {
  return From->isIntegerTy() && To->isIntegerTy() &&
         To->getIntegerBitWidth() <= 32 &&
         From->getIntegerBitWidth() > To->getIntegerBitWidth();
}

bool TPTargetLowering::isTruncateFree(EVT From, EVT To) const {
  return From.isScalarInteger() && To.isScalarInteger() &&
         To.getSizeInBits() <= 32 && From.getSizeInBits() > To.getSizeInBits();
}

bool TPTargetLowering::isZExtFree(SDValue Val, EVT To) const {
  // Byte and half loads extend for nothing.
  if (auto *Load = dyn_cast<LoadSDNode>(Val)) {
    EVT Memory = Load->getMemoryVT();
    if ((Memory == MVT::i8 || Memory == MVT::i16) &&
        (Load->getExtensionType() == ISD::NON_EXTLOAD ||
         Load->getExtensionType() == ISD::ZEXTLOAD))
      return true;
  }
  return TargetLowering::isZExtFree(Val, To);
}

// Both kinds of half floats travel as the 16 bits that memory holds.

MVT TPTargetLowering::getRegisterTypeForCallingConv(LLVMContext &Context,
                                                    CallingConv::ID CallConv,
                                                    EVT VT) const {
  if (VT == MVT::bf16)
    return MVT::i32;
  return TargetLowering::getRegisterTypeForCallingConv(Context, CallConv, VT);
}

unsigned TPTargetLowering::getNumRegistersForCallingConv(
    LLVMContext &Context, CallingConv::ID CallConv, EVT VT) const {
  if (VT == MVT::bf16)
    return 1;
  return TargetLowering::getNumRegistersForCallingConv(Context, CallConv, VT);
}

bool TPTargetLowering::isSuitableForJumpTable(const SwitchInst *Switch,
                                              uint64_t NumCases, uint64_t Range,
                                              ProfileSummaryInfo *PSI,
                                              BlockFrequencyInfo *BFI) const {
  // A jump table costs a load, the time of some forty compares and branches.
  constexpr uint64_t LeastCases = 64;
  return (NumCases >= LeastCases || Switch->getFunction()->hasOptSize()) &&
         TargetLowering::isSuitableForJumpTable(Switch, NumCases, Range, PSI,
                                                BFI);
}

Register TPTargetLowering::getExceptionPointerRegister(const Constant *) const {
  return TP::R4;
}

Register
TPTargetLowering::getExceptionSelectorRegister(const Constant *) const {
  return TP::R5;
}

//===----------------------------------------------------------------------===//
// Custom lowering
//===----------------------------------------------------------------------===//

SDValue TPTargetLowering::LowerOperation(SDValue Op, SelectionDAG &DAG) const {
  switch (Op.getOpcode()) {
  case ISD::GlobalAddress:
  case ISD::GlobalTLSAddress:
  case ISD::ConstantPool:
  case ISD::JumpTable:
  case ISD::BlockAddress:
    return lowerAddress(Op, DAG);
  case ISD::ATOMIC_FENCE:
    return lowerAtomicFence(Op, DAG);
  case ISD::VASTART:
    return lowerVAStart(Op, DAG);
  case ISD::INTRINSIC_WO_CHAIN:
    return lowerIntrinsic(Op, DAG);
  case ISD::FRAMEADDR:
    return lowerFrameAddress(Op, DAG);
  case ISD::RETURNADDR:
    return lowerReturnAddress(Op, DAG);
  case ISD::SHL_PARTS:
  case ISD::SRL_PARTS:
  case ISD::SRA_PARTS: {
    SDValue Low, High;
    expandShiftParts(Op.getNode(), Low, High, DAG);
    return DAG.getMergeValues({Low, High}, SDLoc(Op));
  }
  case ISD::FCOPYSIGN:
    return lowerCopySign(Op, DAG);
  case ISD::FP_TO_BF16:
    return lowerRoundToBFloat(Op, DAG);
  case ISD::FP_TO_SINT_SAT:
  case ISD::FP_TO_UINT_SAT:
    return lowerSaturatingConversion(Op, DAG);
  default:
    llvm_unreachable("operation is not custom");
  }
}

static SDValue getSymbol(SDValue Op, SelectionDAG &DAG, unsigned Flags) {
  SDLoc DL(Op);
  if (auto *Global = dyn_cast<GlobalAddressSDNode>(Op))
    return DAG.getTargetGlobalAddress(Global->getGlobal(), DL, MVT::i32,
                                      Global->getOffset(), Flags);
  if (auto *Pool = dyn_cast<ConstantPoolSDNode>(Op)) {
    if (Pool->isMachineConstantPoolEntry())
      return DAG.getTargetConstantPool(Pool->getMachineCPVal(), MVT::i32,
                                       Pool->getAlign(), Pool->getOffset(),
                                       Flags);
    return DAG.getTargetConstantPool(Pool->getConstVal(), MVT::i32,
                                     Pool->getAlign(), Pool->getOffset(),
                                     Flags);
  }
  if (auto *Table = dyn_cast<JumpTableSDNode>(Op))
    return DAG.getTargetJumpTable(Table->getIndex(), MVT::i32, Flags);
  auto *Block = cast<BlockAddressSDNode>(Op);
  return DAG.getTargetBlockAddress(Block->getBlockAddress(), MVT::i32,
                                   Block->getOffset(), Flags);
}

SDValue TPTargetLowering::lowerAddress(SDValue Op, SelectionDAG &DAG) const {
  // Objects of the local store have absolute addresses like all others.
  SDLoc DL(Op);
  SDValue High =
      DAG.getNode(TPISD::HI, DL, MVT::i32, getSymbol(Op, DAG, TPII::MO_HI));
  SDValue Low =
      DAG.getNode(TPISD::LO, DL, MVT::i32, getSymbol(Op, DAG, TPII::MO_LO));
  return DAG.getNode(ISD::ADD, DL, MVT::i32, High, Low);
}

SDValue TPTargetLowering::lowerIntrinsic(SDValue Op, SelectionDAG &DAG) const {
  if (Op.getConstantOperandVal(0) != Intrinsic::thread_pointer)
    return SDValue();
  // The same address for each thread, in a local store of its own.
  SDLoc DL(Op);
  auto Symbol = [&](unsigned Flags) {
    return DAG.getTargetExternalSymbol("__tp_tls_begin", MVT::i32, Flags);
  };
  return DAG.getNode(ISD::ADD, DL, MVT::i32,
                     DAG.getNode(TPISD::HI, DL, MVT::i32, Symbol(TPII::MO_HI)),
                     DAG.getNode(TPISD::LO, DL, MVT::i32, Symbol(TPII::MO_LO)));
}

SDValue TPTargetLowering::lowerAtomicFence(SDValue Op,
                                           SelectionDAG &DAG) const {
  SDLoc DL(Op);
  auto Scope = static_cast<SyncScope::ID>(Op.getConstantOperandVal(2));
  unsigned Opcode = Scope == SyncScope::SingleThread ? unsigned(ISD::MEMBARRIER)
                                                     : unsigned(TPISD::SYNC);
  return DAG.getNode(Opcode, DL, MVT::Other, Op.getOperand(0));
}

SDValue TPTargetLowering::lowerVAStart(SDValue Op, SelectionDAG &DAG) const {
  MachineFunction &MF = DAG.getMachineFunction();
  auto *Info = MF.getInfo<TPMachineFunctionInfo>();
  SDLoc DL(Op);
  SDValue First = DAG.getFrameIndex(Info->getVarArgsFrameIndex(), MVT::i32);
  const Value *List = cast<SrcValueSDNode>(Op.getOperand(2))->getValue();
  return DAG.getStore(Op.getOperand(0), DL, First, Op.getOperand(1),
                      MachinePointerInfo(List));
}

// The frame record of a function with a frame pointer: the return address is
// in the word below it, the caller's frame pointer in the next.
static constexpr int ReturnAddressOffset = -4;
static constexpr int CallerFrameOffset = -8;

SDValue TPTargetLowering::lowerFrameAddress(SDValue Op,
                                            SelectionDAG &DAG) const {
  DAG.getMachineFunction().getFrameInfo().setFrameAddressIsTaken(true);
  SDLoc DL(Op);
  SDValue Frame = DAG.getCopyFromReg(DAG.getEntryNode(), DL, TP::R30, MVT::i32);
  for (uint64_t Depth = Op.getConstantOperandVal(0); Depth != 0; --Depth)
    Frame = DAG.getLoad(MVT::i32, DL, DAG.getEntryNode(),
                        DAG.getMemBasePlusOffset(
                            Frame, TypeSize::getFixed(CallerFrameOffset), DL),
                        MachinePointerInfo());
  return Frame;
}

SDValue TPTargetLowering::lowerReturnAddress(SDValue Op,
                                             SelectionDAG &DAG) const {
  MachineFunction &MF = DAG.getMachineFunction();
  MF.getFrameInfo().setReturnAddressIsTaken(true);
  SDLoc DL(Op);
  if (Op.getConstantOperandVal(0) == 0) {
    Register Reg = MF.addLiveIn(TP::R31, &TP::GPRRegClass);
    return DAG.getCopyFromReg(DAG.getEntryNode(), DL, Reg, MVT::i32);
  }
  SDValue Frame = lowerFrameAddress(Op, DAG);
  return DAG.getLoad(MVT::i32, DL, DAG.getEntryNode(),
                     DAG.getMemBasePlusOffset(
                         Frame, TypeSize::getFixed(ReturnAddressOffset), DL),
                     MachinePointerInfo());
}

SDValue TPTargetLowering::lowerCopySign(SDValue Op, SelectionDAG &DAG) const {
  // The insertion of 31 bits into the word that has the sign.
  SDLoc DL(Op);
  auto Masked = [&](SDValue Float, uint32_t Mask) {
    return DAG.getNode(ISD::AND, DL, MVT::i32, DAG.getBitcast(MVT::i32, Float),
                       DAG.getConstant(Mask, DL, MVT::i32));
  };
  SDValue Sign = Op.getOperand(1);
  if (Sign.getValueType() != MVT::f32)
    return SDValue();
  SDValue Bits = DAG.getNode(ISD::OR, DL, MVT::i32, Masked(Sign, 0x80000000),
                             Masked(Op.getOperand(0), 0x7fffffff));
  return DAG.getBitcast(MVT::f32, Bits);
}

SDValue TPTargetLowering::lowerRoundToBFloat(SDValue Op,
                                             SelectionDAG &DAG) const {
  SDLoc DL(Op);
  SDValue Float = Op.getOperand(0);
  SDValue Bits = DAG.getBitcast(MVT::i32, Float);
  auto Constant = [&](uint32_t Value) {
    return DAG.getConstant(Value, DL, MVT::i32);
  };
  auto Node = [&](unsigned Opcode, SDValue Left, SDValue Right) {
    return DAG.getNode(Opcode, DL, MVT::i32, Left, Right);
  };
  // To nearest, ties to even. The carry out of the significand is right too.
  SDValue High = Node(ISD::SRL, Bits, Constant(16));
  SDValue IsOdd = Node(ISD::AND, High, Constant(1));
  SDValue Rounded =
      Node(ISD::ADD, Node(ISD::ADD, Bits, Constant(0x7fff)), IsOdd);
  SDValue Result = Node(ISD::SRL, Rounded, Constant(16));
  if (!DAG.isKnownNeverNaN(Float))
    Result = DAG.getSelect(DL, MVT::i32,
                           DAG.getSetCC(DL, MVT::i32, Float, Float, ISD::SETUO),
                           Node(ISD::OR, High, Constant(0x40)), Result);
  return DAG.getZExtOrTrunc(Result, DL, Op.getValueType());
}

SDValue TPTargetLowering::lowerSaturatingConversion(SDValue Op,
                                                    SelectionDAG &) const {
  // The instructions saturate to 32 bits; narrower bounds are expanded.
  EVT Saturation = cast<VTSDNode>(Op.getOperand(1))->getVT();
  if (Saturation == MVT::i32 && Op.getOperand(0).getValueType() == MVT::f32)
    return Op;
  return SDValue();
}

//===----------------------------------------------------------------------===//
// Atomics. Stores and atomics take effect some time after their issue; a load
// reads at once. So `sync`, which waits for them, stands before a release and
// after an atomic or store that later loads must not overtake.
//===----------------------------------------------------------------------===//

bool TPTargetLowering::shouldInsertFencesForAtomic(const Instruction *I) const {
  return I->isAtomic();
}

Instruction *TPTargetLowering::emitTrailingFence(IRBuilderBase &Builder,
                                                 Instruction *Inst,
                                                 AtomicOrdering Ord) const {
  // The next load cannot read older memory than this one: it acquires as it is.
  if (auto *Load = dyn_cast<LoadInst>(Inst)) {
    Load->setOrdering(Ord);
    return nullptr;
  }
  return TargetLowering::emitTrailingFence(Builder, Inst, Ord);
}

/// Marks accesses to a word that are meant for bytes of it.
MachineMemOperand::Flags
TPTargetLowering::getTargetMMOFlags(const Instruction &I) const {
  return I.isAtomic() && isPartOfWord(I) ? TPII::MOPartOfWord
                                         : MachineMemOperand::MONone;
}

TargetLowering::AtomicExpansionKind
TPTargetLowering::shouldExpandAtomicRMWInIR(AtomicRMWInst *RMW) const {
  if (RMW->getType()->getPrimitiveSizeInBits() < 32)
    return AtomicExpansionKind::CmpXChg;
  switch (RMW->getOperation()) {
  case AtomicRMWInst::Xchg:
  case AtomicRMWInst::Add:
  case AtomicRMWInst::Sub:
  case AtomicRMWInst::And:
  case AtomicRMWInst::Or:
  case AtomicRMWInst::Xor:
  case AtomicRMWInst::Max:
  case AtomicRMWInst::Min:
  case AtomicRMWInst::UMax:
  case AtomicRMWInst::UMin:
    return AtomicExpansionKind::None;
  default:
    return AtomicExpansionKind::CmpXChg;
  }
}
