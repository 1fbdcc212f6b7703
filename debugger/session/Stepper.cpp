//===- Stepper.cpp - Runs a thread to where a step ends -------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/session/Stepper.h"

#include "llvm/ADT/STLExtras.h"
#include "llvm/Support/Endian.h"

#include <cassert>

using namespace llvm;

namespace tp {

/// What cannot be found out is as if it were not there.
template <typename T> static T valueOr(Expected<T> Result, T Otherwise) {
  if (Result)
    return std::move(*Result);
  consumeError(Result.takeError());
  return Otherwise;
}

/// The first of two in which functions return. The integer one is also that of
/// the first argument: where to put a result that is returned in memory.
static constexpr unsigned ResultRegister = 4;
static constexpr unsigned FloatResultRegister = DwarfFirstFloat + 4;

static bool contains(ArrayRef<AddressRange> Ranges, uint32_t Pc) {
  return any_of(Ranges, [&](const AddressRange &R) {
    return Pc >= R.Begin && Pc < R.End;
  });
}

static bool isDone(const SessionStop &Stop) {
  return Stop.Kind == SessionStop::Step;
}

Stepper::Stepper(Session &Owner, uint32_t Thread)
    : Owner(Owner), Map(Owner.information().map()), Thread(Thread) {}

static bool isSameLine(const SourcePosition &A, const SourcePosition &B) {
  return A.File == B.File && A.Line == B.Line;
}

uint32_t Stepper::pc() const { return Owner.replay().thread(Thread).Pc; }

bool Stepper::hasLine(uint32_t Pc) const {
  const LineRange *Line = Map.lineAt(Pc);
  return Line && Line->Position.isKnown();
}

Stepper::Place Stepper::here() {
  Place Result;
  Result.Context = Owner.context(Thread);
  const Unwinder &Frames = Owner.information().unwinder();
  Result.Cfa = valueOr(Frames.cfa(Result.Context), 0u);
  if (auto Caller =
          valueOr(Frames.caller(Result.Context), std::optional<FrameContext>()))
    Result.ReturnPc = Caller->Pc;
  Result.Function = Map.functionAt(Result.Context.Pc);
  std::vector<InlinedCall> Calls = Map.callsAt(Result.Context.Pc);
  if (Calls.size() > 1)
    Result.Inlined = Calls.front().Function;
  if (const LineRange *Line = Map.lineAt(Result.Context.Pc))
    Result.Line = Line->Position;
  return Result;
}

Stepper::Relation Stepper::relationTo(const Place &Of) {
  FrameContext Now = Owner.context(Thread);
  const Unwinder &Frames = Owner.information().unwinder();
  if (Map.functionAt(Now.Pc) == Of.Function &&
      valueOr(Frames.cfa(Now), 0u) == Of.Cfa)
    return Relation::Same;
  auto Caller = valueOr(Frames.caller(Now), std::optional<FrameContext>());
  if (Caller && Map.functionAt(Caller->lookupPc()) == Of.Function &&
      valueOr(Frames.cfa(*Caller), 0u) == Of.Cfa)
    return Relation::Callee;
  return Relation::Other;
}

std::optional<SourcePosition> Stepper::lineIn(uint32_t Pc,
                                              uint32_t Function) const {
  for (const InlinedCall &Call : Map.callsAt(Pc))
    if (Call.Function == Function)
      return Call.Position;
  return std::nullopt;
}

std::vector<AddressRange>
Stepper::rangesOf(const Place &Of, std::optional<uint32_t> Level) const {
  std::vector<AddressRange> Ranges = rangesOf(Of);
  if (!Level || !Of.Function || !Of.Line.isKnown())
    return Ranges;
  const FunctionInfo &In = Map.function(*Of.Function);
  for (const AddressRange &Part : In.Ranges)
    for (uint32_t Pc = Part.Begin; Pc < Part.End; Pc += 4) {
      std::optional<SourcePosition> Line = lineIn(Pc, *Level);
      if (Pc == In.Entry || !Line || !isSameLine(*Line, Of.Line))
        continue;
      if (!Ranges.empty() && Ranges.back().End == Pc)
        Ranges.back().End += 4;
      else
        Ranges.push_back({Pc, Pc + 4});
    }
  return Ranges;
}

std::vector<AddressRange> Stepper::rangesOf(const Place &Of) const {
  if (!Of.Function)
    return {{Of.Context.Pc, Of.Context.Pc + 4}};
  const FunctionInfo &In = Map.function(*Of.Function);
  if (!Of.Line.isKnown())
    return In.Ranges;
  std::vector<AddressRange> Ranges =
      Map.rangesOfLine(Of.Line.File, Of.Line.Line);
  erase_if(Ranges,
           [&](const AddressRange &R) { return !In.contains(R.Begin); });
  // Whoever comes to the entry again has been called.
  if (Of.Context.Pc != In.Entry)
    for (AddressRange &R : Ranges)
      if (R.Begin == In.Entry)
        R.Begin += 4;
  return Ranges;
}

bool Stepper::isInlinedCallee(const Place &Of) const {
  std::optional<uint32_t> Innermost = Of.innermost();
  std::vector<InlinedCall> Calls = Map.callsAt(pc());
  return !Calls.empty() &&
         any_of(drop_begin(Calls), [&](const InlinedCall &Call) {
           return Innermost == Call.Function;
         });
}

SessionStop Stepper::run(Direction Towards, InstructionEvents Until) {
  Until.Thread = Thread;
  return Owner.run(Towards, {std::move(Until)});
}

SessionStop Stepper::oneInstruction(Direction Towards) {
  uint64_t Before = Owner.replay().thread(Thread).Instructions;
  for (;;) {
    SessionStop Stop = run(Towards, InstructionEvents());
    // The first event may be the instruction that the thread waits to issue.
    if (!isDone(Stop) || Owner.replay().thread(Thread).Instructions != Before)
      return Stop;
  }
}

SessionStop Stepper::leave(ArrayRef<AddressRange> Ranges, Direction Towards) {
  InstructionEvents Outside;
  Outside.Wanted = [Inside = Ranges.vec()](const Probe &At) {
    return !contains(Inside, At.Pc);
  };
  return run(Towards, std::move(Outside));
}

SessionStop Stepper::to(uint32_t Pc, std::optional<uint32_t> StackPointer,
                        Direction Towards) {
  InstructionEvents There;
  There.Pcs = {Pc};
  if (StackPointer)
    There.Wanted = [StackPointer = *StackPointer](const Probe &At) {
      return At.Registers[StackPointerRegister] == StackPointer;
    };
  return run(Towards, std::move(There));
}

SessionStop Stepper::returnFromCallee() {
  FrameContext Now = Owner.context(Thread);
  return to(Now.Registers.Values[LinkRegister],
            Now.Registers.Values[StackPointerRegister], Direction::Forward);
}

std::optional<FrameContext> Stepper::caller() const {
  return valueOr(Owner.information().unwinder().caller(Owner.context(Thread)),
                 std::optional<FrameContext>());
}

std::optional<uint32_t> Stepper::callSite() const {
  std::optional<FrameContext> Caller = caller();
  return Caller ? std::optional(Caller->lookupPc()) : std::nullopt;
}

SessionStop Stepper::backToCall() {
  std::optional<FrameContext> Caller = caller();
  if (!Caller)
    return oneInstruction(Direction::Backward);
  return to(Caller->lookupPc(), Caller->Registers.Values[StackPointerRegister],
            Direction::Backward);
}

bool Stepper::isInPrologue(const Place &At) const {
  if (!At.Function)
    return false;
  const FunctionInfo &In = Map.function(*At.Function);
  return At.Context.Pc >= In.Entry && At.Context.Pc <= In.Body;
}

SessionStop Stepper::skipPrologue(SessionStop Stop) {
  std::optional<uint32_t> In = Map.functionAt(pc());
  if (!In || Map.function(*In).Entry != pc() || Map.function(*In).Body == pc())
    return Stop;
  return to(Map.function(*In).Body, std::nullopt, Direction::Forward);
}

SessionStop Stepper::forward(bool OverCalls, bool NotBack) {
  Place Start = here();
  std::vector<AddressRange> Ranges = rangesOf(Start);
  if (NotBack && Start.Function)
    Ranges.push_back({Map.function(*Start.Function).Entry + 4, pc() + 4});
  std::vector<AddressRange> Inside = Ranges;
  for (;;) {
    SessionStop Stop = leave(Inside, Direction::Forward);
    if (!isDone(Stop))
      return Stop;
    Relation Where = relationTo(Start);
    if (Where == Relation::Callee) {
      std::optional<uint32_t> Callee = Map.functionAt(pc());
      if (!OverCalls && Callee && hasLine(Map.function(*Callee).Body))
        return skipPrologue(std::move(Stop));
      Stop = returnFromCallee();
      if (!isDone(Stop))
        return Stop;
      Where = Relation::Same;
      if (contains(Ranges, pc())) {
        Inside = Ranges;
        continue;
      }
    }
    const LineRange *Line = Map.lineAt(pc());
    bool IsKnown = Line && Line->Position.isKnown();
    if (Where == Relation::Same) {
      bool IsNew = IsKnown && !isSameLine(Line->Position, Start.Line);
      if (IsNew && Line->IsStatement && beginsLine(Map, pc()) &&
          !(OverCalls && isInlinedCallee(Start)))
        return Stop;
      Inside = Ranges;
      if (Line)
        Inside.push_back({Line->Begin, Line->End});
      continue;
    }
    bool IsTailCall = Start.ReturnPc != 0 &&
                      Owner.context(Thread).Registers.Values[LinkRegister] ==
                          Start.ReturnPc &&
                      pc() != Start.ReturnPc;
    if (OverCalls && IsTailCall) {
      Stop = returnFromCallee();
      if (!isDone(Stop))
        return Stop;
      IsKnown = hasLine(pc());
    }
    std::optional<uint32_t> Function = Map.functionAt(pc());
    bool IsEntry = Function && Map.function(*Function).Entry == pc();
    if (IsKnown && (IsEntry || beginsLine(Map, pc())))
      return skipPrologue(std::move(Stop));
    Start = here();
    Inside = Ranges = rangesOf(Start);
  }
}

SessionStop Stepper::toLineBefore(const Place &Start, bool OverCalls) {
  SessionStop Stop = oneInstruction(Direction::Backward);
  while (isDone(Stop)) {
    if (relationTo(Start) == Relation::Callee &&
        (OverCalls || !hasLine(pc()))) {
      Stop = backToCall();
      if (!isDone(Stop))
        return Stop;
    }
    const LineRange *Line = Map.lineAt(pc());
    if (!Line || Line->Position.isKnown() ||
        relationTo(Start) != Relation::Same)
      return Stop;
    Stop = leave({{Line->Begin, Line->End}}, Direction::Backward);
  }
  return Stop;
}

SessionStop Stepper::backward(bool OverCalls) {
  Place Start = here();
  SessionStop Stop = toLineBefore(Start, OverCalls);
  if (!isDone(Stop))
    return Stop;
  // From the beginning of a function it goes on to the call.
  bool IsPrologue = isInPrologue(Start) && relationTo(Start) == Relation::Same;
  Place Target = here();
  // What was inlined into this function is passed like a call.
  std::optional<uint32_t> Level;
  if (OverCalls)
    Level = isInlinedCallee(Start) ? Start.innermost() : Target.innermost();
  if (Level)
    Target.Line = lineIn(pc(), *Level).value_or(Target.Line);
  std::vector<AddressRange> Ranges = rangesOf(Target, Level);
  std::vector<AddressRange> Inside = Ranges;
  // An instruction of no line before the line's: of the line if what comes
  // before is.
  std::optional<Moment> BeforeLine;
  for (;;) {
    Stop = leave(Inside, Direction::Backward);
    if (!isDone(Stop))
      return Stop;
    const Relation Where = relationTo(Target);
    const bool IsOutside = Where == Relation::Other && IsPrologue;
    if (IsOutside && !hasLine(pc()))
      return Stop;
    if (IsOutside ||
        (Where == Relation::Callee && !OverCalls && hasLine(pc()))) {
      IsPrologue = false;
      Target = here();
      if (OverCalls)
        Level = Target.innermost();
      Inside = Ranges = rangesOf(Target, Level);
      BeforeLine.reset();
      continue;
    }
    std::optional<uint32_t> At;
    if (Where == Relation::Same)
      At = pc();
    else if (Where == Relation::Callee)
      At = callSite();
    const LineRange *Line = At ? Map.lineAt(*At) : nullptr;
    const bool IsOfTarget =
        At && (contains(Ranges, *At) ||
               (Line && isSameLine(Line->Position, Target.Line)));
    const bool IsOfNoLine = Line && !Line->Position.isKnown();
    // The beginning of the line is behind the last instruction of another.
    if (!IsOfTarget && !IsOfNoLine) {
      if (BeforeLine)
        Owner.replay().goTo(*BeforeLine);
      return skipPrologue(Owner.moveByOne(Thread));
    }
    if (IsOfTarget)
      BeforeLine.reset();
    else if (!BeforeLine)
      BeforeLine = Owner.replay().now();
    if (Where == Relation::Callee) {
      Stop = backToCall();
      if (!isDone(Stop))
        return Stop;
    }
    Inside = IsOfTarget ? Ranges : std::vector<AddressRange>();
    if (Line)
      Inside.push_back({Line->Begin, Line->End});
  }
}

SessionStop Stepper::step(const StepRequest &Request) {
  bool IsForward = Request.Towards == Direction::Forward;
  if (Request.Unit == StepRequest::Line && Map.hasLines())
    return IsForward ? forward(Request.OverCalls, false)
                     : backward(Request.OverCalls);
  Place Start = here();
  SessionStop Stop = oneInstruction(Request.Towards);
  if (!isDone(Stop) || !Request.OverCalls ||
      relationTo(Start) != Relation::Callee)
    return Stop;
  if (!IsForward)
    return backToCall();
  bool IsCall = Owner.context(Thread).Registers.Values[LinkRegister] ==
                Start.Context.Pc + 4;
  return IsCall ? returnFromCallee() : Stop;
}

SessionStop Stepper::until() { return forward(true, true); }

SessionStop Stepper::leaveInlined(const Frame &Of, Direction Towards) {
  assert(Of.Function && "what is inlined is a function");
  Place Start;
  Start.Function = Map.functionAt(Of.Context.lookupPc());
  Start.Cfa = Of.Cfa;
  std::vector<AddressRange> Ranges = Map.function(*Of.Function).Ranges;
  SessionStop Stop;
  if (!contains(Ranges, pc()) || relationTo(Start) != Relation::Same) {
    bool IsForward = Towards == Direction::Forward;
    Stop = to(IsForward ? Of.Context.Pc : Of.Context.lookupPc(),
              Of.Context.Registers.Values[StackPointerRegister], Towards);
    if (!isDone(Stop) || !contains(Ranges, pc()))
      return Stop;
  }
  for (;;) {
    Stop = leave(Ranges, Towards);
    if (!isDone(Stop) || relationTo(Start) != Relation::Callee)
      return Stop;
    Stop = Towards == Direction::Forward ? returnFromCallee() : backToCall();
    if (!isDone(Stop) || !contains(Ranges, pc()))
      return Stop;
  }
}

std::optional<uint32_t> Stepper::resultObject(uint32_t Function,
                                              uint32_t StackPointer) {
  InstructionEvents Call;
  Call.Pcs = {Map.function(Function).Entry};
  Call.Thread = Thread;
  Call.Wanted = [StackPointer](const Probe &At) {
    return At.Registers[StackPointerRegister] == StackPointer;
  };
  std::optional<uint32_t> Result;
  Replay &Machine = Owner.replay();
  Machine.visit(Machine.now(), [&] {
    if (Machine.backward({{std::move(Call)}, {}}).Kind ==
        ReplayStop::Instruction)
      Result = Machine.thread(Thread).Registers[ResultRegister];
  });
  return Result;
}

std::optional<Value> Stepper::returned(uint32_t Function,
                                       uint32_t StackPointer) {
  DWARFDie Die = Map.function(Function).Die;
  // The compiler says so if it has changed how the function is called.
  if (!Die || dwarf::toUnsigned(Die.find(dwarf::DW_AT_calling_convention), 0) ==
                  dwarf::DW_CC_nocall)
    return std::nullopt;
  const Type &Of = Owner.information().types().typeOf(Die);
  const Type &Plain = Of.stripped();
  const FrameContext Frame = Owner.context(Thread);
  if (Plain.isRecord()) {
    std::optional<uint32_t> Address = resultObject(Function, StackPointer);
    if (!Address)
      return std::nullopt;
    Expected<Value> Object = Value::inMemory(Of, *Address).snapshot(Frame);
    return valueOr(std::move(Object), Value::optimizedOut(Of));
  }
  unsigned First = Plain.Kind == TypeKind::Float && Plain.Size == 4
                       ? FloatResultRegister
                       : ResultRegister;
  bool IsScalar = Plain.isArithmetic() || Plain.isPointer() ||
                  Plain.isReference() || Plain.Kind == TypeKind::Enumeration;
  if (!IsScalar || Plain.Size > 8)
    return std::nullopt;
  uint8_t Bytes[8];
  for (unsigned I = 0; I != 2; ++I)
    support::endian::write32le(Bytes + size_t(4) * I,
                               Frame.Registers.Values[First + I]);
  uint32_t Size = Plain.isReference() ? 4 : Plain.Size;
  return Value::computed(Of, ArrayRef(Bytes, Size));
}

Expected<SessionStop> Stepper::finish(const Frame &Of, Direction Towards) {
  if (Of.Inlined && Of.Function)
    return leaveInlined(Of, Towards);
  Expected<std::optional<FrameContext>> Caller =
      Owner.information().unwinder().caller(Of.Context);
  if (!Caller)
    return Caller.takeError();
  const std::optional<FrameContext> &Outer = *Caller;
  if (!Outer)
    return createStringError(
        "\"finish\" not meaningful in the outermost frame.");
  uint32_t StackPointer = Outer->Registers.Values[StackPointerRegister];
  if (Towards == Direction::Backward)
    return to(Outer->lookupPc(), StackPointer, Towards);
  SessionStop Stop = to(Outer->Pc, StackPointer, Towards);
  if (isDone(Stop) && Of.Function)
    Stop.Returned = returned(*Of.Function, StackPointer);
  return Stop;
}

SessionStop Stepper::advance(const Frame &Of,
                             ArrayRef<CodeLocation> Locations) {
  std::vector<InstructionEvents> Ends(1);
  for (const CodeLocation &Location : Locations)
    Ends[0].Pcs.push_back(Location.Address);
  Ends[0].Thread = Thread;
  auto Caller = valueOr(Owner.information().unwinder().caller(Of.Context),
                        std::optional<FrameContext>());
  if (Caller) {
    InstructionEvents &Return = Ends.emplace_back();
    Return.Pcs = {Caller->Pc};
    Return.Thread = Thread;
    Return.Wanted = [Pointer = Caller->Registers.Values[StackPointerRegister]](
                        const Probe &At) {
      return At.Registers[StackPointerRegister] == Pointer;
    };
  }
  return Owner.run(Direction::Forward, std::move(Ends));
}

} // namespace tp
