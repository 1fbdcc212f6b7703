//===- SessionRun.cpp - Runs a session until something stops it -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/session/Session.h"

#include <cassert>

using namespace llvm;

namespace tp {

/// Whether the frame that \p At is in makes \p Condition true, or cannot say:
/// then the program stops, and the user sees why.
static bool isTrueAt(const Expression &Condition, const Probe &At,
                     ValueHistory &Values) {
  MachineAccess Access;
  Access.Read = [&](uint32_t Address, MutableArrayRef<uint8_t> Bytes) {
    return At.Read(Address, {Bytes.data(), Bytes.size()});
  };
  FrameContext Frame;
  std::copy_n(At.Registers.begin(), DwarfRegisters,
              Frame.Registers.Values.begin());
  Frame.Pc = At.Pc;
  Frame.Machine = &Access;
  Expected<bool> Result = Condition.isTrue(Frame, &Values);
  if (Result)
    return *Result;
  consumeError(Result.takeError());
  return true;
}

ProbeTest Session::testOf(const Breakpoint &Of) {
  if (!Of.Condition)
    return nullptr;
  return [this, Condition = Of.Condition](const Probe &At) {
    std::lock_guard<std::mutex> Lock(Evaluating);
    return isTrueAt(*Condition, At, Values);
  };
}

Events Session::wantedEvents(Direction Towards) {
  Events Result;
  Watching.clear();
  Ending.clear();
  for (const std::unique_ptr<Breakpoint> &B : Table.all()) {
    if (!B->Enabled)
      continue;
    if (!B->Watched) {
      InstructionEvents &At = Result.Instructions.emplace_back();
      for (const CodeLocation &Location : B->Locations)
        At.Pcs.push_back(Location.Address);
      At.Thread = B->Thread;
      At.Wanted = testOf(*B);
      continue;
    }
    const WatchTarget &Target = *B->Watched;
    AccessEvents &Access = Result.Accesses.emplace_back();
    Access.Address = Target.Address;
    Access.Bytes = Target.Bytes;
    Access.Reads = B->Reads;
    Access.Writes = B->Writes;
    Access.OnlyChanges = !B->Reads;
    Access.Thread = Target.Thread ? Target.Thread : B->Thread;
    Access.Wanted = testOf(*B);
    Watching.push_back(B->Number);
  }
  if (Towards == Direction::Backward)
    return Result;
  for (const std::unique_ptr<Breakpoint> &B : Table.all()) {
    const std::optional<WatchTarget> &Target = B->Watched;
    if (!B->Enabled || !Target || !Target->ScopeCfa)
      continue;
    InstructionEvents Return;
    Return.Pcs = {Target->ScopeReturn};
    Return.Thread = Target->Thread;
    Return.Wanted = [Cfa = *Target->ScopeCfa](const Probe &At) {
      return At.Registers[StackPointerRegister] >= Cfa;
    };
    Result.Instructions.push_back(Return);
    Ending.emplace_back(B->Number, std::move(Return));
  }
  return Result;
}

bool Session::countsHit(Breakpoint &At, uint32_t Thread, SessionStop &Result) {
  if (At.Condition) {
    Expected<bool> IsTrue = At.Condition->isTrue(context(Thread), &Values);
    if (!IsTrue) {
      Result.Kind = SessionStop::ConditionFailed;
      Result.Message = toString(IsTrue.takeError());
      Result.Numbers.push_back(At.Number);
      return false;
    }
    if (!*IsTrue && !At.isWatchpoint())
      return false;
  }
  ++At.Hits;
  if (At.Ignore > 0) {
    --At.Ignore;
    return false;
  }
  if (At.ShouldStop && !At.ShouldStop(Thread))
    return false;
  Result.Numbers.push_back(At.Number);
  if (At.Temporary)
    Result.Deleted.push_back(At.Number);
  llvm::append_range(Result.Commands, At.Commands);
  return true;
}

unsigned Session::frameOf(const CodeLocation &At) const {
  std::vector<InlinedCall> Calls = Information->map().callsAt(At.Address);
  auto Named = find_if(Calls, [&](const InlinedCall &Call) {
    return At.Function == Call.Function;
  });
  return Named == Calls.end() ? 0 : unsigned(Named - Calls.begin());
}

void Session::interpretInstruction(const ReplayStop &At, SessionStop &Result) {
  for (const auto &[Number, Return] : Ending)
    if (isWanted(Return, At)) {
      Result.Kind = SessionStop::ScopeEnded;
      Result.Numbers.push_back(Number);
      Result.Deleted.push_back(Number);
    }
  for (const std::unique_ptr<Breakpoint> &B : Table.all()) {
    if (!B->Enabled || B->isWatchpoint() ||
        (B->Thread && *B->Thread != At.Thread))
      continue;
    auto Here = find_if(B->Locations, [&](const CodeLocation &Location) {
      return Location.Address == At.Pc;
    });
    if (Here == B->Locations.end() || !countsHit(*B, At.Thread, Result) ||
        Result.Kind == SessionStop::ScopeEnded)
      continue;
    Result.Kind = SessionStop::Breakpoint;
    Result.Frame = frameOf(*Here);
  }
}

void Session::interpretAccess(const ReplayStop &At, SessionStop &Result) {
  tp::Breakpoint *Watch = Table.find(Watching[At.Event]);
  assert(Watch && Watch->Watched && "accesses are of watchpoints");
  Result.AccessPc = At.Pc;
  Result.IsWrite = At.IsWrite;
  Result.Old = At.Old;
  Result.New = At.New;
  Result.WatchedType = Watch->Watched->Of;
  if (countsHit(*Watch, At.Thread, Result))
    Result.Kind = SessionStop::Watchpoint;
}

std::optional<SessionStop> Session::interpret(const ReplayStop &At,
                                              bool IsOwn) {
  SessionStop Result;
  Result.Thread = At.Thread;
  Result.Pc = At.Pc;
  switch (At.Kind) {
  case ReplayStop::Instruction:
    interpretInstruction(At, Result);
    if (Result.Numbers.empty() && !IsOwn)
      return std::nullopt;
    break;
  case ReplayStop::Access:
    interpretAccess(At, Result);
    if (Result.Numbers.empty())
      return std::nullopt;
    Result.Pc = Machine->thread(At.Thread).Pc;
    break;
  case ReplayStop::Halted:
    Result.Kind = SessionStop::Exited;
    Result.ExitStatus = At.ExitStatus;
    break;
  case ReplayStop::Trapped:
    Result.Kind = SessionStop::Trapped;
    Result.TrapInfo = At.TrapInfo;
    if (At.TrapInfo)
      Result.Thread = At.TrapInfo->Thread;
    Result.ExitStatus = 1;
    break;
  case ReplayStop::Beginning:
    Result.Kind = SessionStop::Beginning;
    break;
  case ReplayStop::Interrupted:
    Result.Kind = SessionStop::Interrupted;
    break;
  case ReplayStop::CycleLimit:
    Result.Kind = SessionStop::CycleLimit;
    break;
  }
  for (unsigned Number : Result.Deleted)
    Table.remove(Number);
  return Result;
}

SessionStop Session::run(Direction Towards,
                         std::vector<InstructionEvents> Own) {
  for (;;) {
    Events Wanted = wantedEvents(Towards);
    size_t FirstOwn = Wanted.Instructions.size();
    llvm::append_range(Wanted.Instructions, Own);
    ReplayStop At = Towards == Direction::Forward ? Machine->forward(Wanted)
                                                  : Machine->backward(Wanted);
    // An own event may be at the place of a breakpoint that came first.
    bool IsOwn = At.Kind == ReplayStop::Instruction && At.Event >= FirstOwn;
    if (!IsOwn && At.Kind == ReplayStop::Instruction && !Own.empty())
      IsOwn = any_of(
          Own, [&](const InstructionEvents &E) { return isWanted(E, At); });
    if (std::optional<SessionStop> Stop = interpret(At, IsOwn))
      return *Stop;
  }
}

bool Session::isWanted(const InstructionEvents &Of, const ReplayStop &At) {
  if ((Of.Thread && *Of.Thread != At.Thread) ||
      (!Of.Pcs.empty() && !is_contained(Of.Pcs, At.Pc)))
    return false;
  std::array<uint32_t, NumRegisters> Registers =
      Machine->thread(At.Thread).Registers;
  std::function<bool(uint32_t, std::span<uint8_t>)> Read =
      [&](uint32_t Address, std::span<uint8_t> Bytes) {
        return Machine->read(At.Thread, Address, Bytes);
      };
  return !Of.Wanted || Of.Wanted({At.Thread, At.Pc, At.At, Registers, Read});
}

SessionStop Session::moveByOne(uint32_t Thread) {
  InstructionEvents Next;
  Next.Thread = Thread;
  Events Wanted;
  Wanted.Instructions.push_back(std::move(Next));
  ReplayStop At = Machine->forward(Wanted);
  SessionStop Result;
  Result.Thread = Thread;
  Result.Pc = At.Pc;
  return Result;
}

} // namespace tp
