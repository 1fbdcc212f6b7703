//===- Session.cpp - A program being debugged -----------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "debugger/session/Session.h"

#include "debugger/session/Stepper.h"
#include "simulator/core/LocalStore.h"
#include "simulator/tools/ChipSelection.h"

#include <cassert>

using namespace llvm;

namespace tp {

Session::Session() = default;
Session::~Session() = default;

Expected<std::unique_ptr<Session>>
Session::create(const SessionOptions &Request, StringRef ChipFolder) {
  std::unique_ptr<Session> Result(new Session());
  Result->Request = Request;
  // Nobody asks for the rays.
  Result->Request.Run.Quiet = true;
  Expected<ChipConfig> Chip = selectChip(Request.Run, ChipFolder);
  if (!Chip)
    return Chip.takeError();
  Result->Chip = *Chip;
  Expected<ElfProgram> Elf = ElfProgram::load(Request.Run.Program);
  if (!Elf)
    return Elf.takeError();
  Result->Elf = std::make_unique<ElfProgram>(std::move(*Elf));
  Result->Information = std::make_unique<DebugInformation>(*Result->Elf);
  Result->Printer = std::make_unique<ValuePrinter>(Result->Information->map());
  if (llvm::Error E = Result->start())
    return std::move(E);
  Result->Access.resize(Chip->threadCount());
  return Result;
}

llvm::Error Session::start() {
  Expected<std::unique_ptr<RunSetup>> Setup = setUp(Request.Run, Chip);
  if (!Setup)
    return Setup.takeError();
  if ((*Setup)->Elf.object().getData() != Elf->object().getData())
    return createStringError(Elf->path() +
                             ": the file has changed; start tpdbg again");
  ReplayOptions Wanted;
  Wanted.CheckpointBytes = Request.CheckpointBytes;
  Wanted.MaxCycles = Request.Run.MaxCycles;
  Wanted.HostThreads = Request.Run.HostThreads;
  Wanted.Output = [this](int Fd, std::string_view Bytes) {
    if (Output)
      Output(Fd != 1, StringRef(Bytes.data(), Bytes.size()));
  };
  std::string Problem;
  auto Make = isFunctional() ? makeFunctionalReplay : makeCycleReplay;
  std::unique_ptr<Replay> New =
      Make(Chip, (*Setup)->Text, (*Setup)->Global, std::move(Wanted), Problem);
  if (!New)
    return createStringError(Problem);
  Machine = std::move(New);
  Loaded = std::move(*Setup);
  Machine->setStopFlag(&StopRequested);
  Machine->setProgress(Progress);
  return llvm::Error::success();
}

llvm::Error Session::restart() {
  if (llvm::Error E = start())
    return E;
  Table.forgetRun();
  return llvm::Error::success();
}

bool Session::isStarted() const { return Machine->now() != Moment(); }

bool Session::isLocal(uint32_t Address) const {
  return Address >= LocalStoreRange(Chip.LocalStoreBytes).Begin;
}

const MachineAccess &Session::machine(uint32_t Thread) {
  std::unique_ptr<MachineAccess> &Slot = Access[Thread];
  if (Slot)
    return *Slot;
  Slot = std::make_unique<MachineAccess>();
  Slot->Read = [this, Thread](uint32_t Address,
                              MutableArrayRef<uint8_t> Bytes) {
    return Machine->read(Thread, Address, {Bytes.data(), Bytes.size()});
  };
  Slot->Write = [this, Thread](uint32_t Address, ArrayRef<uint8_t> Bytes) {
    return Machine->write(Thread, Address, {Bytes.data(), Bytes.size()});
  };
  Slot->WriteRegister = [this, Thread](unsigned Register, uint32_t Value) {
    if (Register == 0)
      return false;
    Machine->setRegister(Thread, Register, Value);
    return true;
  };
  Slot->WritePc = [this, Thread](uint32_t Pc) {
    return Machine->setPc(Thread, Pc);
  };
  return *Slot;
}

FrameContext Session::context(uint32_t Thread) {
  ReplayThread State = Machine->thread(Thread);
  FrameContext Result;
  std::copy_n(State.Registers.begin(), DwarfRegisters,
              Result.Registers.Values.begin());
  // A thread that has halted is still in its last function.
  Result.Pc = State.State == ThreadState::Halted ? State.Pc - 4 : State.Pc;
  Result.Machine = &machine(Thread);
  return Result;
}

Backtrace Session::backtrace(uint32_t Thread, size_t Limit) {
  return Information->unwinder().backtrace(context(Thread), Limit);
}

Expected<Breakpoint *>
Session::addBreakpoint(StringRef Text, const LocationDefaults &Defaults) {
  Expected<std::vector<CodeLocation>> Found =
      findLocations(Text, *Information, Defaults);
  if (!Found)
    return Found.takeError();
  const Segment &Code = Elf->text();
  for (const CodeLocation &At : *Found)
    if (At.Address < Code.Address || At.Address >= Code.end())
      return createStringError("Not the address of an instruction: 0x" +
                               Twine::utohexstr(At.Address));
  Breakpoint New;
  New.Text = Text.str();
  New.Locations = std::move(*Found);
  return &Table.add(std::move(New));
}

/// The frame of the stack that \p Address is in, if it is in one.
static const Frame *frameHolding(uint32_t Address, const Backtrace &Stack) {
  const FrameContext &Innermost = Stack.Frames.front().Context;
  if (Address < Innermost.Registers.Values[StackPointerRegister])
    return nullptr;
  for (const Frame &F : Stack.Frames)
    if (!F.Inlined && Address < F.Cfa)
      return &F;
  return nullptr;
}

Expected<Breakpoint *> Session::addWatchpoint(StringRef Text, uint32_t Thread,
                                              const FrameContext &Frame,
                                              bool Reads, bool Writes,
                                              bool IsLocation) {
  Expected<Expression> Parsed = Expression::parse(Text, *Information, &Frame);
  if (!Parsed)
    return Parsed.takeError();
  Expected<Value> Watched = Parsed->evaluate(Frame, &Values);
  if (!Watched)
    return Watched.takeError();
  std::optional<uint32_t> Address = Watched->address();
  if (std::optional<unsigned> Register = Watched->registerNumber())
    return createStringError(
        "Cannot watch '" + Text + "': it is in register " +
        registerName(*Register) +
        " here, and only memory can be watched; compile with -O0, or use a "
        "conditional breakpoint");
  if (Watched->isOptimizedOut())
    return createStringError("Cannot watch '" + Text +
                             "': it is optimized out here");
  if (Watched->isBitField())
    return createStringError("Cannot watch '" + Text +
                             "': it is a bit-field; watch the object that it "
                             "is in");
  if (!Address || Watched->type().Size == 0)
    return createStringError("Cannot watch constant value '" + Text + "'.");
  Expected<Breakpoint *> New =
      addWatchpoint(*Address, Watched->type().Size, Thread, Reads, Writes);
  if (!New)
    return New;
  tp::Breakpoint &Added = **New;
  Added.Text = Text.str();
  assert(Added.Watched && "a watchpoint watches something");
  WatchTarget &Target = *Added.Watched;
  Target.Of = &Watched->type();
  if (IsLocation || !isLocal(*Address))
    return New;
  Backtrace Stack = backtrace(Thread);
  const tp::Frame *In = frameHolding(*Address, Stack);
  if (!In)
    return New;
  Expected<std::optional<FrameContext>> Caller =
      Information->unwinder().caller(In->Context);
  if (!Caller) {
    consumeError(Caller.takeError());
    return New;
  }
  if (const std::optional<FrameContext> &Outer = *Caller) {
    Target.ScopeCfa = In->Cfa;
    Target.ScopeReturn = Outer->Pc;
  }
  return New;
}

Expected<Breakpoint *> Session::addWatchpoint(uint32_t Address, uint32_t Bytes,
                                              uint32_t Thread, bool Reads,
                                              bool Writes) {
  std::vector<uint8_t> Probe(std::min<uint32_t>(Bytes, 1));
  if (Bytes == 0 || uint64_t(Address) + Bytes > (uint64_t(1) << 32) ||
      !machine(Thread).Read(Address, Probe) ||
      !machine(Thread).Read(Address + Bytes - 1, Probe))
    return createStringError("Cannot watch " + Twine(Bytes) + " bytes at 0x" +
                             Twine::utohexstr(Address) +
                             ": they are not in memory");
  Breakpoint New;
  New.Text = "0x" + utohexstr(Address, true) + ", " + utostr(Bytes) + " bytes";
  New.Reads = Reads;
  New.Writes = Writes;
  WatchTarget &Target = New.Watched.emplace();
  Target.Address = Address;
  Target.Bytes = Bytes;
  if (isLocal(Address))
    Target.Thread = Thread;
  return &Table.add(std::move(New));
}

llvm::Error Session::setCondition(Breakpoint &Of, StringRef Text) {
  if (Text.trim().empty()) {
    Of.Condition = nullptr;
    return llvm::Error::success();
  }
  FrameContext There;
  MachineAccess Nothing;
  Nothing.Read = [](uint32_t, MutableArrayRef<uint8_t>) { return false; };
  There.Machine = &Nothing;
  if (!Of.Locations.empty())
    There.Pc = Of.Locations.front().Address;
  Expected<Expression> Parsed = Expression::parse(
      Text.trim(), *Information, Of.Locations.empty() ? nullptr : &There);
  if (!Parsed)
    return Parsed.takeError();
  Of.Condition = std::make_shared<const Expression>(std::move(*Parsed));
  return llvm::Error::success();
}

SessionStop Session::resume(Direction Towards) {
  StopRequested = false;
  return run(Towards, {});
}

SessionStop Session::step(const StepRequest &Step) {
  StopRequested = false;
  return Stepper(*this, Step.Thread).step(Step);
}

Expected<SessionStop> Session::finish(uint32_t Thread, const Frame &Of,
                                      Direction Towards) {
  StopRequested = false;
  return Stepper(*this, Thread).finish(Of, Towards);
}

SessionStop Session::advance(uint32_t Thread, const Frame &Of,
                             ArrayRef<CodeLocation> Locations) {
  StopRequested = false;
  return Stepper(*this, Thread).advance(Of, Locations);
}

SessionStop Session::until(uint32_t Thread) {
  StopRequested = false;
  return Stepper(*this, Thread).until();
}

SessionStop Session::goTo(uint64_t Time) {
  StopRequested = false;
  ReplayStop At = Machine->goTo({Time, 0});
  if (Machine->now().Time != Time)
    if (std::optional<SessionStop> Stop = interpret(At, true))
      return *Stop;
  SessionStop Result;
  Result.Thread = At.Thread;
  return Result;
}

LastWrite Session::lastWrite(uint32_t Thread, uint32_t Address,
                             uint32_t Bytes) {
  StopRequested = false;
  return Machine->lastWrite(Thread, Address, Bytes);
}

} // namespace tp
