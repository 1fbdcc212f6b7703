//===- Frames.cpp - A thread's stack -------------------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/source/Frames.h"

#include "debugger/source/SourceMap.h"
#include "simulator/isa/Instructions.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/DebugInfo/DWARF/DWARFContext.h"
#include "llvm/DebugInfo/DWARF/DWARFDebugFrame.h"
#include "llvm/Support/Endian.h"

using namespace llvm;
using namespace llvm::dwarf;

namespace tp {

/// What every function keeps for its caller: TPCallingConv.td's CSR_TP.
static bool isCalleeSaved(unsigned Register) {
  return Register == 0 || (Register >= 16 && Register <= 23) ||
         Register == 30 || Register >= DwarfFirstFloat + 20;
}

/// The unwinding rules of the functions, tabulated when first asked for.
struct Unwinder::Rules {
  std::vector<const FDE *> Functions;
  DenseMap<const FDE *, std::unique_ptr<UnwindTable>> Tables;
  std::string Problem;

  explicit Rules(DWARFContext &Dwarf) {
    Expected<const DWARFDebugFrame *> Section = Dwarf.getDebugFrame();
    if (!Section) {
      Problem = toString(Section.takeError());
      return;
    }
    for (const FrameEntry &Entry : **Section)
      if (const auto *Function = dyn_cast<FDE>(&Entry))
        if (Function->getInitialLocation() != 0)
          Functions.push_back(Function);
    llvm::sort(Functions, [](const FDE *A, const FDE *B) {
      return A->getInitialLocation() < B->getInitialLocation();
    });
  }

  const FDE *functionAt(uint32_t Pc) const {
    auto Behind = partition_point(Functions, [&](const FDE *Function) {
      return Function->getInitialLocation() <= Pc;
    });
    if (Behind == Functions.begin())
      return nullptr;
    const FDE *Function = *std::prev(Behind);
    uint64_t Offset = Pc - Function->getInitialLocation();
    return Offset < Function->getAddressRange() ? Function : nullptr;
  }

  Expected<const UnwindTable *> tableOf(const FDE *Function) {
    std::unique_ptr<UnwindTable> &Table = Tables[Function];
    if (!Table) {
      Expected<UnwindTable> Made = createUnwindTable(Function);
      if (!Made)
        return Made.takeError();
      Table = std::make_unique<UnwindTable>(std::move(*Made));
    }
    return Table.get();
  }

  Expected<const UnwindTable *> tableAt(uint32_t Pc) {
    if (const FDE *Function = functionAt(Pc))
      return tableOf(Function);
    return createStringError(
        Problem.empty() ? "no frame information for this code" : Problem);
  }

  Expected<const UnwindRow *> rowAt(uint32_t Pc) {
    Expected<const UnwindTable *> Table = tableAt(Pc);
    if (!Table)
      return Table.takeError();
    const UnwindRow *Found = nullptr;
    for (const UnwindRow &Row : **Table)
      if (!Row.hasAddress() || Row.getAddress() <= Pc)
        Found = &Row;
    if (!Found)
      return createStringError("no frame information for this code");
    return Found;
  }
};

Unwinder::Unwinder(DWARFContext &Dwarf, const SourceMap &Map)
    : Map(Map), Table(std::make_unique<Rules>(Dwarf)) {}

Unwinder::~Unwinder() = default;

Expected<uint32_t> Unwinder::cfaOf(const UnwindRow &Row,
                                   const FrameContext &Context) const {
  const UnwindLocation &Rule = Row.getCFAValue();
  if (Rule.getLocation() != UnwindLocation::RegPlusOffset)
    return createStringError("the frame's address has a rule that is not "
                             "understood");
  unsigned Register = Rule.getRegister();
  if (Register >= DwarfRegisters || !Context.Registers.isKnown(Register))
    return createStringError("the frame's address is relative to register " +
                             Twine(Register) + ", which is not known");
  return Context.Registers.Values[Register] + uint32_t(Rule.getOffset());
}

Expected<uint32_t> Unwinder::cfa(const FrameContext &Context) const {
  Expected<const UnwindRow *> Row = Table->rowAt(Context.lookupPc());
  if (!Row)
    return Row.takeError();
  return cfaOf(**Row, Context);
}

Expected<uint32_t> Unwinder::frameBase(const FrameContext &Context,
                                       unsigned Register) const {
  auto Plain = [&]() -> Expected<uint32_t> {
    if (!Context.Registers.isKnown(Register))
      return createStringError("the frame's base, register " + Twine(Register) +
                               ", is not known");
    return Context.Registers.Values[Register];
  };
  Expected<const UnwindTable *> Rows = Table->tableAt(Context.lookupPc());
  if (!Rows) {
    consumeError(Rows.takeError());
    return Plain();
  }
  std::optional<int32_t> Distance;
  for (const UnwindRow &Row : **Rows) {
    const UnwindLocation &Rule = Row.getCFAValue();
    if (Rule.getLocation() == UnwindLocation::RegPlusOffset &&
        Rule.getRegister() == Register)
      Distance = std::max(Distance.value_or(INT32_MIN), Rule.getOffset());
  }
  if (!Distance)
    return Plain();
  Expected<uint32_t> Cfa = cfa(Context);
  if (!Cfa) {
    consumeError(Cfa.takeError());
    return Plain();
  }
  return *Cfa - uint32_t(*Distance);
}

Error Unwinder::restore(unsigned Register, const UnwindLocation &Rule,
                        uint32_t Cfa, const FrameContext &Callee,
                        FrameContext &Caller) const {
  switch (Rule.getLocation()) {
  case UnwindLocation::Undefined:
    Caller.Registers.forget(Register);
    return Error::success();
  case UnwindLocation::Same:
  case UnwindLocation::Unspecified:
    return Error::success();
  case UnwindLocation::Constant:
    Caller.Registers.set(Register, uint32_t(Rule.getConstant()));
    return Error::success();
  case UnwindLocation::RegPlusOffset:
  case UnwindLocation::CFAPlusOffset: {
    uint32_t Base = Cfa;
    if (Rule.getLocation() == UnwindLocation::RegPlusOffset) {
      if (Rule.getRegister() >= DwarfRegisters ||
          !Callee.Registers.isKnown(Rule.getRegister())) {
        Caller.Registers.forget(Register);
        return Error::success();
      }
      Base = Callee.Registers.Values[Rule.getRegister()];
    }
    uint32_t Where = Base + uint32_t(Rule.getOffset());
    if (!Rule.getDereference()) {
      Caller.Registers.set(Register, Where);
      return Error::success();
    }
    uint8_t Bytes[4];
    if (!Callee.read(Where, Bytes))
      return createStringError("cannot read the saved register " +
                               Twine(Register) + " at 0x" +
                               utohexstr(Where, true, 8));
    Caller.Registers.set(Register, support::endian::read32le(Bytes));
    Caller.SavedAt[Register] = Where;
    return Error::success();
  }
  case UnwindLocation::DWARFExpr:
    break;
  }
  return createStringError("the rule for register " + Twine(Register) +
                           " is not understood");
}

Expected<std::optional<FrameContext>>
Unwinder::caller(const FrameContext &Context) const {
  Expected<const UnwindRow *> Found = Table->rowAt(Context.lookupPc());
  if (!Found)
    return Found.takeError();
  const UnwindRow &Row = **Found;
  Expected<uint32_t> Cfa = cfaOf(Row, Context);
  if (!Cfa)
    return Cfa.takeError();
  FrameContext Caller = Context;
  for (unsigned Register = 0; Register != DwarfRegisters; ++Register) {
    std::optional<UnwindLocation> Rule =
        Row.getRegisterLocations().getRegisterLocation(Register);
    if (Rule && Register == LinkRegister &&
        Rule->getLocation() == UnwindLocation::Undefined)
      return std::nullopt;
    if (Rule) {
      if (Error Problem = restore(Register, *Rule, *Cfa, Context, Caller))
        return std::move(Problem);
    } else if (Register != LinkRegister && !isCalleeSaved(Register)) {
      Caller.Registers.doubt(Register);
    }
  }
  if (!Caller.Registers.isKnown(LinkRegister))
    return createStringError("the return address is not known");
  // A thread begins with 0 there.
  if (Caller.Registers.Values[LinkRegister] == 0)
    return std::nullopt;
  Caller.Registers.set(StackPointerRegister, *Cfa);
  Caller.SavedAt[StackPointerRegister] = 0;
  Caller.Pc = Caller.Registers.Values[LinkRegister];
  Caller.IsCaller = true;
  Caller.InlineDepth = 0;
  return Caller;
}

void Unwinder::addFrames(const FrameContext &Context, uint32_t Cfa,
                         size_t Limit, std::vector<Frame> &Frames) const {
  std::vector<InlinedCall> Calls = Map.callsAt(Context.lookupPc());
  if (Calls.empty()) {
    Frame Unknown;
    Unknown.Context = Context;
    Unknown.Cfa = Cfa;
    Frames.push_back(Unknown);
    return;
  }
  for (unsigned Depth = 0; Depth != Calls.size() && Frames.size() < Limit;
       ++Depth) {
    Frame Next;
    Next.Context = Context;
    Next.Context.InlineDepth = Depth;
    Next.Cfa = Cfa;
    Next.Function = Calls[Depth].Function;
    Next.Position = Calls[Depth].Position;
    Next.Inlined = Depth + 1 != Calls.size();
    Frames.push_back(Next);
  }
}

Backtrace Unwinder::backtrace(const FrameContext &Innermost,
                              size_t Limit) const {
  Backtrace Result;
  FrameContext At = Innermost;
  At.InlineDepth = 0;
  uint32_t Previous = 0;
  unsigned Standing = 0;
  Limit = std::max<size_t>(Limit, 1);
  while (true) {
    Expected<uint32_t> Cfa = cfa(At);
    addFrames(At, Cfa ? *Cfa : 0, Limit, Result.Frames);
    if (!Cfa) {
      Result.Problem = toString(Cfa.takeError());
      return Result;
    }
    if (Result.Frames.size() >= Limit)
      return Result;
    if (*Cfa < Previous) {
      Result.Problem = "the stack is corrupt: the caller's frame is below";
      return Result;
    }
    Expected<std::optional<FrameContext>> Caller = caller(At);
    if (!Caller) {
      Result.Problem = toString(Caller.takeError());
      return Result;
    }
    const std::optional<FrameContext> &Outer = *Caller;
    if (!Outer)
      return Result;
    // Only the innermost function and the outermost may have no frame.
    Standing = *Cfa == Previous ? Standing + 1 : 0;
    if (Standing == 3 || (Standing != 0 && Outer->Pc == At.Pc)) {
      Result.Problem = "the stack is corrupt: a frame is its own caller";
      return Result;
    }
    Previous = *Cfa;
    At = *Outer;
  }
}

} // namespace tp
