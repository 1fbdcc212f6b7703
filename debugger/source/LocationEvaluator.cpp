//===- LocationEvaluator.cpp - Where a variable is -----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/source/LocationEvaluator.h"

#include "debugger/source/Frames.h"
#include "debugger/source/LocationStack.h"
#include "debugger/source/NameIndex.h"
#include "debugger/source/SourceMap.h"

#include "llvm/DebugInfo/DWARF/DWARFContext.h"

using namespace llvm;
using namespace llvm::dwarf;

namespace tp {

static std::vector<ValuePiece> constantPieces(const DWARFFormValue &Constant,
                                              uint32_t Size) {
  ValuePiece Piece;
  Piece.Place = ValuePiece::Computed;
  Piece.Bytes = Size;
  if (std::optional<ArrayRef<uint8_t>> Block = Constant.getAsBlock()) {
    Piece.Contents.assign(Block->begin(), Block->end());
  } else {
    int64_t Number = constantOf(Constant).value_or(0);
    for (uint32_t I = 0; I != std::min(Size, 16u); ++I)
      Piece.Contents.push_back(uint8_t(Number >> std::min(8 * I, 63u)));
  }
  return {Piece};
}

Expected<std::vector<ValuePiece>>
LocationEvaluator::locate(DWARFDie Die, uint32_t Size,
                          const FrameContext &Frame) const {
  if (std::optional<DWARFFormValue> Constant =
          Die.findRecursively(DW_AT_const_value))
    return constantPieces(*Constant, Size);
  auto [Known, IsNew] = Locations.try_emplace(Die.getOffset());
  if (IsNew && Die.find(DW_AT_location)) {
    Expected<DWARFLocationExpressionsVector> Read =
        Die.getLocations(DW_AT_location);
    if (!Read) {
      Locations.erase(Known);
      return Read.takeError();
    }
    Known->second = std::move(*Read);
  }
  for (const DWARFLocationExpression &Location : Known->second) {
    uint32_t Pc = Frame.lookupPc();
    if (Location.Range &&
        (Pc < Location.Range->LowPC || Pc >= Location.Range->HighPC))
      continue;
    // A location ends with the call that overwrites its register.
    bool GoesOn = !Location.Range || Location.Range->HighPC > Frame.Pc;
    return LocationStack(*this, *Die.getDwarfUnit(), Frame,
                         !Frame.IsCaller || GoesOn)
        .places(Location.Expr, Size);
  }
  return std::vector<ValuePiece>();
}

Expected<std::optional<int64_t>>
LocationEvaluator::number(DWARFDie Die, Attribute Name,
                          const FrameContext &Frame) const {
  std::optional<DWARFFormValue> Form = Die.find(Name);
  if (!Form)
    return std::nullopt;
  if (std::optional<int64_t> Constant = constantOf(*Form))
    return *Constant;
  if (std::optional<ArrayRef<uint8_t>> Block = Form->getAsBlock()) {
    Expected<std::optional<uint64_t>> Result =
        LocationStack(*this, *Die.getDwarfUnit(), Frame).number(*Block);
    if (!Result)
      return Result.takeError();
    const std::optional<uint64_t> &Number = *Result;
    if (!Number)
      return std::nullopt;
    return int64_t(*Number);
  }
  DWARFDie Variable = Die.getAttributeValueAsReferencedDie(*Form);
  if (!Variable)
    return std::nullopt;
  DWARFDie Type = Variable.getAttributeValueAsReferencedDie(DW_AT_type);
  uint32_t Size =
      Type ? uint32_t(Type.getTypeSize(4).value_or(4)) : uint32_t(4);
  Expected<std::vector<ValuePiece>> Places = locate(Variable, Size, Frame);
  if (!Places)
    return Places.takeError();
  if (Places->size() != 1 || Places->front().Place == ValuePiece::Lost)
    return std::nullopt;
  SmallVector<uint8_t, 8> Bytes = Places->front().Contents;
  if (Places->front().Place == ValuePiece::InMemory) {
    Bytes.resize(Size);
    if (!Frame.read(Places->front().Address, Bytes))
      return std::nullopt;
  }
  int64_t Result = 0;
  for (size_t I = 0; I != std::min<size_t>(Bytes.size(), 8); ++I)
    Result |= int64_t(Bytes[I]) << (8 * I);
  return Result;
}

Expected<uint32_t>
LocationEvaluator::frameBase(const FrameContext &Frame) const {
  std::optional<uint32_t> Function = Map.functionAt(Frame.lookupPc());
  DWARFDie Die = Function ? Map.function(*Function).Die : DWARFDie();
  std::optional<ArrayRef<uint8_t>> Block;
  if (Die)
    Block = toBlock(Die.find(DW_AT_frame_base));
  if (!Block || Block->empty())
    return createStringError("the function has no frame base");
  uint8_t Code = Block->front();
  if (Block->size() == 1 && Code >= DW_OP_reg0 && Code <= DW_OP_reg31)
    return Frames.frameBase(Frame, Code - DW_OP_reg0);
  Expected<std::optional<uint64_t>> Base =
      LocationStack(*this, *Die.getDwarfUnit(), Frame).number(*Block);
  if (!Base)
    return Base.takeError();
  const std::optional<uint64_t> &Number = *Base;
  if (!Number)
    return createStringError("the frame base is not known");
  return uint32_t(*Number);
}

void LocationEvaluator::readCallSites(DWARFDie Die) const {
  for (DWARFDie Child : Die.children()) {
    Tag Kind = Child.getTag();
    if (Kind == DW_TAG_call_site || Kind == DW_TAG_GNU_call_site) {
      std::optional<uint64_t> ReturnPc =
          toAddress(Child.find(ArrayRef{DW_AT_call_return_pc, DW_AT_low_pc}));
      if (ReturnPc)
        CallSites[uint32_t(*ReturnPc)] = Child;
    } else if (Kind == DW_TAG_lexical_block ||
               Kind == DW_TAG_inlined_subroutine) {
      readCallSites(Child);
    }
  }
}

DWARFDie LocationEvaluator::callSite(uint32_t ReturnPc) const {
  std::optional<uint32_t> Index = Map.functionAt(ReturnPc - 4);
  if (!Index || !Map.function(*Index).Die)
    return {};
  DWARFDie Function = Map.function(*Index).Die;
  if (FunctionsRead.try_emplace(Function.getOffset(), true).second)
    readCallSites(Function);
  return CallSites.lookup(ReturnPc);
}

/// Whether a call leads to \p Function and not to one that jumps to it.
static bool calls(DWARFDie CallSite, DWARFDie Function) {
  DWARFDie Origin =
      CallSite.getAttributeValueAsReferencedDie(DW_AT_call_origin);
  if (!Origin)
    Origin = CallSite.getAttributeValueAsReferencedDie(DW_AT_abstract_origin);
  return !Origin || originOf(Origin) == originOf(Function);
}

Expected<std::optional<uint64_t>>
LocationEvaluator::entryValue(ArrayRef<uint8_t> Expression,
                              const FrameContext &Frame) const {
  Expected<std::optional<FrameContext>> Caller = Frames.caller(Frame);
  if (!Caller) {
    consumeError(Caller.takeError());
    return std::nullopt;
  }
  std::optional<uint32_t> Function = Map.functionAt(Frame.lookupPc());
  const std::optional<FrameContext> &Outer = *Caller;
  if (!Outer || !Function)
    return std::nullopt;
  DWARFDie Site = callSite(Outer->Pc);
  if (!Site || !calls(Site, Map.function(*Function).Die))
    return std::nullopt;
  for (DWARFDie Parameter : Site.children()) {
    std::optional<ArrayRef<uint8_t>> Place =
        toBlock(Parameter.find(DW_AT_location));
    if (!Place || *Place != Expression)
      continue;
    std::optional<ArrayRef<uint8_t>> Value = toBlock(
        Parameter.find(ArrayRef{DW_AT_call_value, DW_AT_GNU_call_site_value}));
    if (!Value)
      return std::nullopt;
    return LocationStack(*this, *Parameter.getDwarfUnit(), *Outer)
        .number(*Value);
  }
  return std::nullopt;
}

} // namespace tp
