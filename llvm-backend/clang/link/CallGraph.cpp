//===- CallGraph.cpp - Which code of a program calls which ----------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "llvm-backend/clang/link/CallGraph.h"
#include "llvm-backend/MCTargetDesc/TPELF.h"
#include "llvm-backend/MCTargetDesc/TPFrameRecord.h"
#include "llvm-backend/MCTargetDesc/TPMCTargetDesc.h"
#include "llvm-backend/MachineCode/MachineCode.h"
#include "llvm-backend/clang/link/FrameRecords.h"
#include "llvm/ADT/MapVector.h"
#include "llvm/ADT/STLExtras.h"
#include "llvm/Demangle/Demangle.h"
#include "llvm/MC/MCInst.h"

using namespace llvm;

namespace tp {

//===----------------------------------------------------------------------===//
// Functions
//===----------------------------------------------------------------------===//

// Of several names for one place, the first in this order is taken.
static auto nameRank(const Symbol &S) {
  return std::tuple(S.Type != ELF::STT_FUNC, S.Binding == ELF::STB_LOCAL,
                    S.isWeak(), S.Name);
}

using SectionSymbols =
    MapVector<const InputSection *, std::vector<const Symbol *>>;

// The names in each live section of code, by place and then by rank.
static SectionSymbols
symbolsOfCode(ArrayRef<std::unique_ptr<ElfObject>> Objects,
              const SymbolTable &Globals) {
  SectionSymbols BySection;
  for (const auto &Object : Objects)
    for (const auto &Section : Object->sections())
      if (Section && Section->Live && Section->isCode())
        BySection.insert({Section.get(), {}});
  auto Add = [&](const Symbol &S) {
    if (auto *Found = BySection.find(S.Section);
        Found != BySection.end() &&
        (S.Type == ELF::STT_FUNC || S.Type == ELF::STT_NOTYPE))
      Found->second.push_back(&S);
  };
  for (const auto &Object : Objects)
    for_each(Object->locals(), Add);
  for_each(Globals.symbols(), Add);
  for (auto &Entry : BySection)
    llvm::sort(Entry.second, [](const Symbol *A, const Symbol *B) {
      return std::pair(A->Value, nameRank(*A)) <
             std::pair(B->Value, nameRank(*B));
    });
  return BySection;
}

namespace {
/// Cuts a section's code into functions. What no function of type and size
/// covers begins at a plain label or at the section's begin.
class SectionCutter {
public:
  SectionCutter(const InputSection &Section, std::deque<CallGraphNode> &Nodes)
      : Section(Section), Nodes(Nodes) {}

  void cut(ArrayRef<const Symbol *> Symbols) {
    if (Section.Size != 0 && (Symbols.empty() || Symbols.front()->Value != 0))
      begin(0, Section.File->name() + ":(" + Section.Name.str() + ")");
    for (const Symbol *S : Symbols) {
      const bool IsLabel = S->Type != ELF::STT_FUNC && S->Value < CoveredEnd;
      if (IsLabel || S->Value >= Section.Size ||
          (Last && Last->Begin == S->Value))
        continue;
      begin(S->Value, demangle(S->Name));
      if (S->Type == ELF::STT_FUNC)
        // Without a size, up to the next function.
        CoveredEnd = S->Size ? S->Value + S->Size : Section.Size;
    }
    if (Last)
      Last->End = Section.Size;
  }

private:
  void begin(uint32_t Offset, std::string Name) {
    if (Last)
      Last->End = Offset;
    Last = &Nodes.emplace_back();
    Last->Section = &Section;
    Last->Begin = Offset;
    Last->Name = std::move(Name);
  }

  const InputSection &Section;
  std::deque<CallGraphNode> &Nodes;
  CallGraphNode *Last = nullptr;
  uint32_t CoveredEnd = 0;
};

/// What the builder knows of a function besides its node.
struct FunctionFacts {
  const FrameRecord *Record = nullptr;
  bool IsAddressTaken = false;

  uint32_t type() const {
    return Record ? Record->OwnType : TPFrameRecord::AnyType;
  }
};

class Builder {
public:
  Builder(ArrayRef<std::unique_ptr<ElfObject>> Objects, CallGraph &Graph)
      : Objects(Objects), Graph(Graph), Disassembler(Code.createDisassembler()),
        StackPointer(TP::R29), Link(TP::R31) {}

  void findFunctions(const SymbolTable &Globals);
  void apply(ArrayRef<FrameRecord> Records);
  void findTakenAddresses();
  void findCalls();
  const CallGraphNode *functionAt(const InputSection *Section,
                                  uint32_t Offset) const {
    return const_cast<Builder *>(this)->find(Section, Offset);
  }

private:
  using RelocationMap = DenseMap<uint32_t, const ElfType::Rela *>;

  CallGraphNode *find(const InputSection *Section, uint32_t Offset);
  void findCallsOf(CallGraphNode &Caller, const RelocationMap &RelocationAt);
  void addJump(CallGraphNode &Caller, uint32_t Offset, const MCInst &Inst,
               const ElfType::Rela *Relocation, bool IsTail);
  void addPointerCall(CallGraphNode &Caller, uint32_t Type, bool IsTail);
  bool writes(const MCInst &Inst, MCRegister Register) const;

  ArrayRef<std::unique_ptr<ElfObject>> Objects;
  CallGraph &Graph;
  DenseMap<const CallGraphNode *, FunctionFacts> Facts;
  /// By place.
  DenseMap<const InputSection *, std::vector<CallGraphNode *>> BySection;
  /// By type.
  DenseMap<uint32_t, CallGraphNode *> PointerNodes;
  /// Code at addresses that the program does not contain.
  CallGraphNode *Outside = nullptr;

  MachineCode Code;
  std::unique_ptr<MCDisassembler> Disassembler;
  MCRegister StackPointer, Link;
};
} // namespace

void Builder::findFunctions(const SymbolTable &Globals) {
  for (const auto &[Section, Symbols] : symbolsOfCode(Objects, Globals))
    SectionCutter(*Section, Graph.Nodes).cut(Symbols);
  for (CallGraphNode &Node : Graph.Nodes)
    BySection[Node.Section].push_back(&Node);
}

CallGraphNode *Builder::find(const InputSection *Section, uint32_t Offset) {
  auto Nodes = BySection.find(Section);
  if (Nodes == BySection.end() || Offset >= Section->Size)
    return nullptr;
  auto Next = llvm::upper_bound(Nodes->second, Offset,
                                [](uint32_t Wanted, const CallGraphNode *Node) {
                                  return Wanted < Node->Begin;
                                });
  return Next == Nodes->second.begin() ? nullptr : *std::prev(Next);
}

void Builder::apply(ArrayRef<FrameRecord> Records) {
  for (const FrameRecord &Record : Records) {
    CallGraphNode *Node = find(Record.Section, Record.Offset);
    if (!Node || Node->Begin != Record.Offset)
      continue;
    Facts[Node].Record = &Record;
    if (Record.FrameBytes == TPFrameRecord::DynamicSize)
      Node->Kind = CallGraphNode::Frame::Dynamic;
    else
      Node->FrameBytes = Record.FrameBytes;
  }
}

void Builder::findTakenAddresses() {
  for (const auto &Object : Objects)
    for (const auto &Section : Object->sections()) {
      if (!Section || !Section->Live || !Section->isAllocated() ||
          Section->Name == ".eh_frame")
        continue;
      for (const ElfType::Rela &Relocation : Section->Relocations) {
        const uint32_t Type = Relocation.getType(false);
        const Symbol *Target = Object->symbol(Relocation.getSymbol(false));
        if (Type == TPELF::R_TP_PC16 || Type == TPELF::R_TP_PC26 || !Target)
          continue;
        const uint32_t Offset = Target->Value + Relocation.r_addend;
        if (CallGraphNode *Node = find(Target->Section, Offset);
            Node && Node->Begin == Offset)
          Facts[Node].IsAddressTaken = true;
      }
    }
}

//===----------------------------------------------------------------------===//
// Calls
//===----------------------------------------------------------------------===//

void Builder::findCalls() {
  const InputSection *Section = nullptr;
  RelocationMap RelocationAt;
  // Calls through pointers add nodes at the end.
  for (size_t I = 0, Count = Graph.Nodes.size(); I != Count; ++I) {
    CallGraphNode &Caller = Graph.Nodes[I];
    if (Caller.Section != Section) {
      Section = Caller.Section;
      RelocationAt.clear();
      for (const ElfType::Rela &Relocation : Section->Relocations)
        RelocationAt[Relocation.r_offset] = &Relocation;
    }
    findCallsOf(Caller, RelocationAt);
  }
}

bool Builder::writes(const MCInst &Inst, MCRegister Register) const {
  const MCInstrDesc &Desc = Code.Instructions->get(Inst.getOpcode());
  return Desc.hasDefOfPhysReg(Inst, Register, *Code.Registers);
}

void Builder::findCallsOf(CallGraphNode &Caller,
                          const RelocationMap &RelocationAt) {
  const FrameRecord *Record = Facts.lookup(&Caller).Record;
  uint32_t RegisterCalls = 0;
  bool FallsThrough = true;
  for (uint32_t Offset = Caller.Begin; Offset + 4 <= Caller.End; Offset += 4) {
    MCInst Inst;
    uint64_t Size;
    if (Disassembler->getInstruction(Inst, Size,
                                     Caller.Section->Bytes.slice(Offset, 4), 0,
                                     nulls()) != MCDisassembler::Success)
      continue;
    const MCInstrDesc &Desc = Code.Instructions->get(Inst.getOpcode());
    FallsThrough = !Desc.isBarrier();
    const bool IsCall =
        writes(Inst, Link) && (Desc.isCall() || Desc.isBranch());
    const bool HasTarget = llvm::any_of(Desc.operands(), [](const auto &Info) {
      return Info.OperandType == MCOI::OPERAND_PCREL;
    });
    if (HasTarget)
      addJump(Caller, Offset, Inst, RelocationAt.lookup(Offset), !IsCall);
    else if (IsCall)
      ++RegisterCalls;
    else if (!Record && Desc.isIndirectBranch() &&
             Inst.getOperand(0).getReg() != Link)
      addPointerCall(Caller, TPFrameRecord::AnyType, /*IsTail=*/true);
    if (!Record && writes(Inst, StackPointer))
      Caller.Kind = CallGraphNode::Frame::Unstated;
  }
  if (Record)
    for (uint32_t Type : Record->CalleeTypes)
      addPointerCall(Caller, Type & ~TPFrameRecord::TailCallFlag,
                     Type & TPFrameRecord::TailCallFlag);
  else if (FallsThrough && Caller.End != Caller.Section->Size)
    Caller.Calls.push_back({find(Caller.Section, Caller.End), true});
  // Those that are in no record are of inline assembly, or of assembly.
  if (RegisterCalls > (Record ? Record->RegisterCallCount : 0))
    addPointerCall(Caller, TPFrameRecord::AnyType, /*IsTail=*/false);
}

void Builder::addJump(CallGraphNode &Caller, uint32_t Offset,
                      const MCInst &Inst, const ElfType::Rela *Relocation,
                      bool IsTail) {
  const InputSection *Section = Caller.Section;
  uint64_t Target = 0;
  if (Relocation) {
    const Symbol *Named = Section->File->symbol(Relocation->getSymbol(false));
    // A weak function that is not there is not called.
    if (!Named || !Named->Defined)
      return;
    Section = Named->Section;
    Target = static_cast<uint32_t>(Named->Value + Relocation->r_addend);
  } else {
    Code.Analysis->evaluateBranch(Inst, Offset, /*Size=*/4, Target);
  }
  const CallGraphNode *Callee = find(Section, static_cast<uint32_t>(Target));
  if (!Callee) {
    if (!Outside) {
      Outside = &Graph.Nodes.emplace_back();
      Outside->Name = "code at an absolute address";
      Outside->Kind = CallGraphNode::Frame::Unstated;
    }
    Callee = Outside;
  }
  if (!IsTail || Callee != &Caller)
    Caller.Calls.push_back({Callee, IsTail});
}

void Builder::addPointerCall(CallGraphNode &Caller, uint32_t Type,
                             bool IsTail) {
  CallGraphNode *&Node = PointerNodes[Type];
  if (!Node) {
    Node = &Graph.Nodes.emplace_back();
    Node->Name = "(pointer)";
    for (CallGraphNode &Candidate : Graph.Nodes) {
      const FunctionFacts Known = Facts.lookup(&Candidate);
      if (Known.IsAddressTaken &&
          (Type == TPFrameRecord::AnyType || Known.type() == Type ||
           Known.type() == TPFrameRecord::AnyType))
        Node->Calls.push_back({&Candidate, true});
    }
  }
  Caller.Calls.push_back({Node, IsTail});
}

CallGraph buildCallGraph(ArrayRef<std::unique_ptr<ElfObject>> Objects,
                         const SymbolTable &Globals, const Symbol &Entry,
                         LinkDiagnostics &Diags) {
  const std::vector<FrameRecord> Records = readFrameRecords(Objects, Diags);
  CallGraph Graph;
  Builder Functions(Objects, Graph);
  Functions.findFunctions(Globals);
  Functions.apply(Records);
  Functions.findTakenAddresses();
  Functions.findCalls();
  Graph.Entry = Functions.functionAt(Entry.Section, Entry.Value);
  return Graph;
}

} // namespace tp
