//===- TPISelDAGToDAG.cpp - Instruction selection -------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/MCTargetDesc/TPMCTargetDesc.h"
#include "llvm-backend/TP.h"
#include "llvm-backend/TPSelectionDAGInfo.h"
#include "llvm-backend/TPSubtarget.h"
#include "llvm-backend/TPTargetMachine.h"
#include "llvm/CodeGen/SelectionDAGISel.h"
#include "llvm/InitializePasses.h"

using namespace llvm;

#define DEBUG_TYPE "tp-isel"
#define PASS_NAME "TP DAG->DAG Pattern Instruction Selection"

namespace {

class TPDAGToDAGISel : public SelectionDAGISel {
  const TPSubtarget *Subtarget = nullptr;

public:
  TPDAGToDAGISel(TPTargetMachine &TM, CodeGenOptLevel OptLevel)
      : SelectionDAGISel(TM, OptLevel) {}

  bool runOnMachineFunction(MachineFunction &MF) override {
    Subtarget = &MF.getSubtarget<TPSubtarget>();
    return SelectionDAGISel::runOnMachineFunction(MF);
  }

  void Select(SDNode *Node) override;
  bool SelectInlineAsmMemoryOperand(const SDValue &Op,
                                    InlineAsm::ConstraintCode Constraint,
                                    std::vector<SDValue> &OutOps) override;

private:
  bool selectAddrRI(SDValue Address, SDValue &Base, SDValue &Offset);
  bool selectAddrRR(SDValue Address, SDValue &Base, SDValue &Index);

  bool trySelectConstantFP(SDNode *Node);
  bool trySelectExtract(SDNode *Node);
  bool trySelectInsert(SDNode *Node);

  SDValue getImmediate(int64_t Value, const SDLoc &DL) {
    return CurDAG->getSignedTargetConstant(Value, DL, MVT::i32);
  }
  SDValue getZero(const SDLoc &) {
    return CurDAG->getRegister(TP::R0, MVT::i32);
  }

#include "TPGenDAGISel.inc"
};

class TPDAGToDAGISelLegacy : public SelectionDAGISelLegacy {
public:
  static char ID;

  TPDAGToDAGISelLegacy(TPTargetMachine &TM, CodeGenOptLevel OptLevel)
      : SelectionDAGISelLegacy(ID,
                               std::make_unique<TPDAGToDAGISel>(TM, OptLevel)) {
  }
};

} // namespace

char TPDAGToDAGISelLegacy::ID = 0;

INITIALIZE_PASS(TPDAGToDAGISelLegacy, DEBUG_TYPE, PASS_NAME, false, false)

FunctionPass *llvm::createTPISelDag(TPTargetMachine &TM,
                                    CodeGenOptLevel OptLevel) {
  return new TPDAGToDAGISelLegacy(TM, OptLevel);
}

//===----------------------------------------------------------------------===//
// Addresses
//===----------------------------------------------------------------------===//

bool TPDAGToDAGISel::selectAddrRI(SDValue Address, SDValue &Base,
                                  SDValue &Offset) {
  SDLoc DL(Address);
  auto ToBase = [&](SDValue Value) {
    if (auto *Frame = dyn_cast<FrameIndexSDNode>(Value))
      return CurDAG->getTargetFrameIndex(Frame->getIndex(), MVT::i32);
    return Value;
  };
  if (Address.getOpcode() == ISD::ADD &&
      Address.getOperand(1).getOpcode() == TPISD::LO) {
    Base = Address.getOperand(0);
    Offset = Address.getOperand(1).getOperand(0);
    return true;
  }
  if (CurDAG->isBaseWithConstantOffset(Address)) {
    int64_t Value = cast<ConstantSDNode>(Address.getOperand(1))->getSExtValue();
    if (isInt<16>(Value)) {
      Base = ToBase(Address.getOperand(0));
      Offset = getImmediate(Value, DL);
      return true;
    }
  }
  Base = ToBase(Address);
  Offset = getImmediate(0, DL);
  return true;
}

bool TPDAGToDAGISel::selectAddrRR(SDValue Address, SDValue &Base,
                                  SDValue &Index) {
  if (Address.getOpcode() != ISD::ADD)
    return false;
  SDValue Right = Address.getOperand(1);
  if (Right.getOpcode() == TPISD::LO)
    return false;
  if (auto *Constant = dyn_cast<ConstantSDNode>(Right))
    if (isInt<16>(Constant->getSExtValue()))
      return false;
  Base = Address.getOperand(0);
  Index = Right;
  return true;
}

bool TPDAGToDAGISel::SelectInlineAsmMemoryOperand(
    const SDValue &Op, InlineAsm::ConstraintCode,
    std::vector<SDValue> &OutOps) {
  SDValue Base, Offset;
  selectAddrRI(Op, Base, Offset);
  // A frame index too far away would need the scratch register, which there is
  // only one of.
  if (Base.getOpcode() == ISD::TargetFrameIndex) {
    SDLoc DL(Op);
    Base = SDValue(CurDAG->getMachineNode(TP::ADDI, DL, MVT::i32, Base,
                                          getImmediate(0, DL)),
                   0);
  }
  OutOps.push_back(Base);
  OutOps.push_back(Offset);
  return false;
}

//===----------------------------------------------------------------------===//
// Nodes that need more than a pattern
//===----------------------------------------------------------------------===//

bool TPDAGToDAGISel::trySelectConstantFP(SDNode *Node) {
  if (Node->getValueType(0) != MVT::f32)
    return false;
  SDLoc DL(Node);
  const uint32_t Bits = cast<ConstantFPSDNode>(Node)
                            ->getValueAPF()
                            .bitcastToAPInt()
                            .getZExtValue();
  SDValue Integer = CurDAG->getRegister(TP::R0, MVT::i32);
  if (Bits >> 16)
    Integer = SDValue(CurDAG->getMachineNode(TP::LUI, DL, MVT::i32,
                                             getImmediate(Bits >> 16, DL)),
                      0);
  if (Bits & 0xffff)
    Integer = SDValue(CurDAG->getMachineNode(TP::ORI, DL, MVT::i32, Integer,
                                             getImmediate(Bits & 0xffff, DL)),
                      0);
  CurDAG->SelectNodeTo(Node, TP::MTC1, MVT::f32, Integer);
  return true;
}

static std::optional<uint32_t> getConstant(SDValue Value) {
  if (auto *Constant = dyn_cast<ConstantSDNode>(Value))
    return static_cast<uint32_t>(Constant->getZExtValue());
  return std::nullopt;
}

/// and (srl x, lowest), mask -> ext. Masks that andi takes are left to it where
/// nothing is shifted.
bool TPDAGToDAGISel::trySelectExtract(SDNode *Node) {
  std::optional<uint32_t> Mask = getConstant(Node->getOperand(1));
  if (!Mask || !isMask_32(*Mask))
    return false;
  SDValue Source = Node->getOperand(0);
  unsigned Lowest = 0;
  if ((Source.getOpcode() == ISD::SRL || Source.getOpcode() == ISD::SRA) &&
      Source.hasOneUse()) {
    if (std::optional<uint32_t> Shift = getConstant(Source.getOperand(1))) {
      Lowest = *Shift;
      Source = Source.getOperand(0);
    }
  }
  const unsigned Highest = Lowest + llvm::popcount(*Mask) - 1;
  if (Highest > 31 || (Lowest == 0 && isUInt<16>(*Mask)))
    return false;
  SDLoc DL(Node);
  CurDAG->SelectNodeTo(
      Node, TP::EXT, MVT::i32,
      {Source, getImmediate(Lowest, DL), getImmediate(Highest, DL)});
  return true;
}

/// If \p Field is (z << Lowest) & Mask, the mask covering the bits from Lowest
/// to Highest, returns z.
static SDValue matchField(SDValue Field, unsigned Lowest, unsigned Highest) {
  const uint32_t FieldMask = maskTrailingOnes<uint32_t>(Highest - Lowest + 1)
                             << Lowest;
  auto Unshift = [&](SDValue Value) -> SDValue {
    if (Lowest == 0)
      return Value;
    if (Value.getOpcode() == ISD::SHL &&
        getConstant(Value.getOperand(1)) == Lowest)
      return Value.getOperand(0);
    return SDValue();
  };
  if (Field.getOpcode() == ISD::AND &&
      getConstant(Field.getOperand(1)) == FieldMask)
    return Unshift(Field.getOperand(0));
  SDValue Unshifted = Unshift(Field);
  if (!Unshifted || Lowest == 0)
    return SDValue();
  // The shift has moved out what lies above the field, or a mask did before.
  if (Highest == 31)
    return Unshifted;
  if (Unshifted.getOpcode() == ISD::AND &&
      getConstant(Unshifted.getOperand(1)) == FieldMask >> Lowest)
    return Unshifted.getOperand(0);
  return SDValue();
}

/// or (and x, ~mask), (field of z at mask) -> ins.
bool TPDAGToDAGISel::trySelectInsert(SDNode *Node) {
  for (unsigned Side : {0, 1}) {
    SDValue Rest = Node->getOperand(Side);
    if (Rest.getOpcode() != ISD::AND || !Rest.hasOneUse())
      continue;
    auto *RestMask = dyn_cast<ConstantSDNode>(Rest.getOperand(1));
    unsigned Lowest, Width;
    if (!RestMask ||
        !isShiftedMask_32(~static_cast<uint32_t>(RestMask->getZExtValue()),
                          Lowest, Width))
      continue;
    const unsigned Highest = Lowest + Width - 1;
    SDValue Value = matchField(Node->getOperand(1 - Side), Lowest, Highest);
    if (!Value)
      continue;
    SDLoc DL(Node);
    CurDAG->SelectNodeTo(Node, TP::INS, MVT::i32,
                         {Rest.getOperand(0), Value, getImmediate(Lowest, DL),
                          getImmediate(Highest, DL)});
    return true;
  }
  return false;
}

void TPDAGToDAGISel::Select(SDNode *Node) {
  if (Node->isMachineOpcode()) {
    Node->setNodeId(-1);
    return;
  }
  switch (Node->getOpcode()) {
  case ISD::FrameIndex: {
    SDLoc DL(Node);
    SDValue Frame = CurDAG->getTargetFrameIndex(
        cast<FrameIndexSDNode>(Node)->getIndex(), MVT::i32);
    CurDAG->SelectNodeTo(Node, TP::ADDI, MVT::i32, Frame, getImmediate(0, DL));
    return;
  }
  case ISD::Constant:
    if (cast<ConstantSDNode>(Node)->isZero()) {
      ReplaceNode(Node, CurDAG
                            ->getCopyFromReg(CurDAG->getEntryNode(),
                                             SDLoc(Node), TP::R0, MVT::i32)
                            .getNode());
      return;
    }
    break;
  case ISD::ConstantFP:
    if (trySelectConstantFP(Node))
      return;
    break;
  case ISD::AND:
    if (trySelectExtract(Node))
      return;
    break;
  case ISD::OR:
    if (trySelectInsert(Node))
      return;
    break;
  default:
    break;
  }
  SelectCode(Node);
}
