//===- AssemblyMessages.cpp - Messages about inline assembly --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// `!srcloc` has a number for each line of the text, which the code generator's
// messages bring along. Clang's numbers mean something to its source manager
// only. Those here are hashes of the place, and the module's named metadata
// has {number, file, line, column} for each.
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/link/AssemblyMessages.h"
#include "llvm/IR/Constants.h"
#include "llvm/IR/InstIterator.h"
#include "llvm/IR/InstrTypes.h"
#include "llvm/IR/Metadata.h"
#include "llvm/Support/xxhash.h"

using namespace llvm;

namespace tp {

static constexpr const char LinesName[] = "srcloc";
static constexpr const char PlacesName[] = "tp.assembly_places";

static Metadata *numberOf(LLVMContext &Context, uint64_t Value) {
  return ConstantAsMetadata::get(
      ConstantInt::get(Type::getInt64Ty(Context), Value));
}

static uint64_t readNumber(const MDNode &Node, unsigned Index) {
  return mdconst::extract<ConstantInt>(Node.getOperand(Index))->getZExtValue();
}

// Adds Place to the module's; returns its number there.
static Metadata *addPlace(llvm::Module &Unit, const SourcePlace &Place) {
  LLVMContext &Context = Unit.getContext();
  Metadata *Number =
      numberOf(Context, xxh3_64bits((Place.File + ":" + Twine(Place.Line) +
                                     ":" + Twine(Place.Column))
                                        .str()));
  Unit.getOrInsertNamedMetadata(PlacesName)
      ->addOperand(
          MDNode::get(Context, {Number, MDString::get(Context, Place.File),
                                numberOf(Context, Place.Line),
                                numberOf(Context, Place.Column)}));
  return Number;
}

void setAssemblyPlaces(llvm::Module &Unit,
                       function_ref<SourcePlace(uint64_t)> PlaceOf) {
  for (Function &F : Unit)
    for (Instruction &I : instructions(F)) {
      auto *Call = dyn_cast<CallBase>(&I);
      const MDNode *Lines = I.getMetadata(LinesName);
      if (!Call || !Call->isInlineAsm() || !Lines)
        continue;
      SmallVector<Metadata *, 4> Numbers;
      for (unsigned Line = 0; Line != Lines->getNumOperands(); ++Line)
        Numbers.push_back(addPlace(Unit, PlaceOf(readNumber(*Lines, Line))));
      I.setMetadata(LinesName, MDNode::get(Unit.getContext(), Numbers));
    }
}

static SourcePlace placeOf(uint64_t Number, const llvm::Module &Program) {
  if (const NamedMDNode *Places = Program.getNamedMetadata(PlacesName))
    for (const MDNode *Place : Places->operands())
      if (readNumber(*Place, 0) == Number)
        return {cast<MDString>(Place->getOperand(1))->getString().str(),
                static_cast<unsigned>(readNumber(*Place, 2)),
                static_cast<unsigned>(readNumber(*Place, 3))};
  return {};
}

static SourceMgr::DiagKind kindOf(DiagnosticSeverity Severity) {
  switch (Severity) {
  case DS_Error:
    return SourceMgr::DK_Error;
  case DS_Warning:
    return SourceMgr::DK_Warning;
  case DS_Remark:
    return SourceMgr::DK_Remark;
  case DS_Note:
    return SourceMgr::DK_Note;
  }
  llvm_unreachable("no severity");
}

// Shows the line of the assembly that the assembler read.
static void printLine(const SMDiagnostic &Message) {
  if (Message.getLineContents().empty())
    return;
  SMDiagnostic(*Message.getSourceMgr(), Message.getLoc(), Message.getFilename(),
               Message.getLineNo(), Message.getColumnNo(), SourceMgr::DK_Note,
               "instantiated into assembly here", Message.getLineContents(),
               Message.getRanges())
      .print(/*ProgName=*/nullptr, errs());
}

bool reportAssemblyMessage(const DiagnosticInfo &Info,
                           const llvm::Module &Program,
                           LinkDiagnostics &Diags) {
  if (const auto *Operand = dyn_cast<DiagnosticInfoInlineAsm>(&Info)) {
    SourcePlace Place = placeOf(Operand->getLocCookie(), Program);
    if (Place.File.empty())
      return false;
    Diags.report(kindOf(Info.getSeverity()), Place, Operand->getMsgStr());
    return true;
  }
  const auto *Text = dyn_cast<DiagnosticInfoSrcMgr>(&Info);
  if (!Text || !Text->isInlineAsmDiag())
    return false;
  SourcePlace Place = placeOf(Text->getLocCookie(), Program);
  if (Place.File.empty())
    return false;
  Diags.report(kindOf(Info.getSeverity()), Place,
               Text->getSMDiag().getMessage());
  printLine(Text->getSMDiag());
  return true;
}

} // namespace tp
