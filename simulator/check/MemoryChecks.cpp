//===- MemoryChecks.cpp - Bad accesses and undefined values ---------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/check/MemoryChecks.h"

#include "runtime/include/tp/check.h"
#include "simulator/check/ObjectPlace.h"

#include <algorithm>

namespace tp {

static constexpr const char DoubleFree[] = "double-free";

MemoryChecks::MemoryChecks(const MemoryCheckOptions &Wanted,
                           CheckedProgram &Program)
    : Wanted(Wanted), Program(Program) {
  for (const AtomicAccess &Known : Program.Elf.atomicAccesses())
    if (Known.IsPartOfWord)
      AccessesToParts.insert(Known.Address);
}

void MemoryChecks::start(const AddressSpace &RunSpace, const ChipConfig &Chip,
                         std::span<const FunctionalThread> Threads) {
  Space = RunSpace;
  Global =
      std::make_unique<ShadowMemory>(kGlobalMemoryBegin, Space.GlobalBytes);
  bool IsMapped = Global->isMapped();
  Shadows.resize(Threads.size());
  for (ThreadShadow &Shadow : Shadows) {
    Shadow.Local =
        std::make_unique<ShadowMemory>(Space.LocalBegin, Chip.LocalStoreBytes);
    IsMapped = IsMapped && Shadow.Local->isMapped();
  }
  if (!IsMapped) {
    Error = "the host has no room for what --check knows of each byte; give "
            "the chip less memory (--set memory.bytes=)";
    return;
  }
  padGlobals();
  padLaunch();
  StackBegin = Program.Elf.stackLimit().value_or(Space.LocalBegin);
  if (Program.HeapEnd != 0)
    HeapFrontier = Program.HeapBegin;
}

void MemoryChecks::padGlobals() {
  auto Pad = [](ShadowMemory &Memory, const CheckedGlobal &Known) {
    Memory.setAccess(Known.Address, Known.Bytes, Access::All);
    Memory.setAccess(toGranules(Known.Address + Known.Bytes),
                     CheckedObject::PaddingBytes, Access::GlobalPadding);
  };
  for (const CheckedGlobal &Known : Program.Globals) {
    if (isLocalObject(Known.Address, Known.Bytes)) {
      for (ThreadShadow &Shadow : Shadows)
        Pad(*Shadow.Local, Known);
    } else if (isBlock(Known.Address, Known.Bytes)) {
      Pad(*Global, Known);
    }
  }
}

void MemoryChecks::padLaunch() {
  if (Program.Launch.empty())
    return;
  const uint32_t Begin = toGranules(Program.Launch.front().Address);
  const LaunchPart &Last = Program.Launch.back();
  Global->setAccess(Begin, uint32_t(Last.Address + Last.Bytes - Begin),
                    Access::LaunchPadding);
  for (const LaunchPart &Part : Program.Launch) {
    const uint32_t First = Part.Address & ~(AccessGranule - 1);
    Global->setAccess(First, uint32_t(Part.Address + Part.Bytes - First),
                      Access::All);
  }
}

//===----------------------------------------------------------------------===//
// Accesses
//===----------------------------------------------------------------------===//

ReportSide MemoryChecks::side(const char *What, const CodePlace &Place) const {
  return {What, Place.Thread, Program.Contexts.stackAt(Place.Pc, Place.Calls)};
}

void MemoryChecks::checkCode(const CheckedAccess &A, bool IsStore) {
  uint8_t Code = memoryOf(A).accessOf(A.Address);
  if (Code < AccessGranule && A.Address % AccessGranule + A.Bytes <= Code)
    return;
  if (!A.IsLocal && shadowOf(A.T).isInAllocator())
    return;
  if (Code < AccessGranule)
    Code = memoryOf(A).accessOf(A.Address + AccessGranule);
  // Others' memory has no padding.
  reportAccess(A, IsStore,
               Code < uint8_t(Access::HeapPadding) ? Access::HeapPadding
                                                   : Access(Code));
}

void MemoryChecks::checkBound(const CheckedAccess &A, bool IsStore) {
  if (!A.IsLocal) {
    if (!shadowOf(A.T).isInAllocator())
      reportAccess(A, IsStore, Access::HeapUnused);
    return;
  }
  if (!Wanted.Stack || A.Address < StackBegin ||
      A.T.Registers[StackPointerRegister] > Space.LocalBegin + Space.LocalBytes)
    return;
  if (!Program.Found.isNew("stack-use-after-return", placeOf(A.T, A.Pc)))
    return;
  Program.Found.add({"stack",
                     "stack-use-after-return",
                     std::string(IsStore ? "store" : "load") + " of " +
                         inBytes(A.Bytes) + " below the stack pointer",
                     "the function whose memory that was has returned",
                     A.Address,
                     A.Bytes,
                     {side(IsStore ? "stored" : "loaded", placeOf(A.T, A.Pc))},
                     ""});
}

/// The name of the fault of an access to what \p Code says.
static const char *kindOf(Access Code) {
  switch (Code) {
  case Access::All:
  case Access::HeapPadding:
    return "heap-out-of-bounds";
  case Access::HeapFreed:
    return "heap-use-after-free";
  case Access::HeapUnused:
    return "heap-not-allocated";
  case Access::StackPadding:
    return "stack-out-of-bounds";
  case Access::StackDead:
    return "stack-use-after-scope";
  case Access::GlobalPadding:
    return "global-out-of-bounds";
  case Access::LaunchPadding:
    return "launch-out-of-bounds";
  }
  __builtin_unreachable();
}

static bool isOfStack(Access Code) {
  return Code == Access::StackPadding || Code == Access::StackDead;
}

static bool isOfHeap(Access Code) { return Code <= Access::HeapUnused; }

bool MemoryChecks::isOfStart(uint32_t Pc) {
  const std::vector<SourceFrame> &Frames = Program.Found.frames(Pc);
  return !Frames.empty() && Frames.front().Function == "__tp_start_thread";
}

void MemoryChecks::reportAccess(const CheckedAccess &A, bool IsStore,
                                Access Code) {
  if (!Wanted.Memory ||
      (A.IsLocal && Code == Access::GlobalPadding && isOfStart(A.Pc)))
    return;
  const HeapBlock *Block = isOfHeap(Code) ? Blocks.nearest(A.Address) : nullptr;
  const char *Kind = kindOf(Code);
  const CodePlace Here = placeOf(A.T, A.Pc);
  if (!Program.Found.isNew(Kind, Here, Block ? Block->AllocatedAt : Here))
    return;
  Report R{"memory",
           Kind,
           std::string(IsStore ? "store" : "load") + " of " + inBytes(A.Bytes),
           "",
           A.Address,
           A.Bytes,
           {side(IsStore ? "stored" : "loaded", Here)},
           ""};
  if (isOfStack(Code))
    nameStackObject(A.T, A.Address, R);
  else if (Block)
    nameBlock(*Block, A.Address, R);
  else
    R.Object = Program.Names.describe(A.Address).value_or("");
  Program.Found.add(R);
}

void MemoryChecks::nameStackObject(const FunctionalThread &T, uint32_t Address,
                                   Report &R) {
  const StackObject *Object = shadowOf(T).nearestObject(Address);
  if (!Object)
    return;
  R.Object = Object->describe(Address);
  R.Sides.push_back(side("the object began to live", Object->BeganAt));
}

void MemoryChecks::nameBlock(const HeapBlock &Block, uint32_t Address,
                             Report &R) const {
  R.Object = Block.describe(Address);
  if (Block.FreedAt)
    R.Sides.push_back(
        side(R.Kind == DoubleFree ? "given back before" : "given back",
             *Block.FreedAt));
  R.Sides.push_back(side("allocated", Block.AllocatedAt));
}

void MemoryChecks::trapped(const Trap &Why) {
  bool IsBelow = Why.Kind == TrapKind::AddressOutOfRange &&
                 Shadows[Why.Thread].StackPointer < Space.LocalBegin;
  if (!Wanted.Stack || (Why.Kind != TrapKind::StackOverflow && !IsBelow))
    return;
  const ThreadShadow &Shadow = Shadows[Why.Thread];
  Program.Found.add(
      {"stack",
       "stack-overflow",
       "the stack takes " + inBytes(Shadow.StackTop - Shadow.StackPointer) +
           " and may take " + inBytes(Shadow.StackTop - StackBegin),
       "",
       std::nullopt,
       0,
       {side("overflow", {Why.Thread, Why.Pc, Shadow.Calls.context()})},
       ""});
}

//===----------------------------------------------------------------------===//
// Undefined values
//===----------------------------------------------------------------------===//

void MemoryChecks::stackMoved(FunctionalThread &T, uint32_t) {
  ThreadShadow &Shadow = shadowOf(T);
  const uint32_t Now = T.Registers[StackPointerRegister];
  const uint32_t Before = std::exchange(Shadow.StackPointer, Now);
  auto IsInStore = [this](uint32_t At) {
    return At - Space.LocalBegin <= Space.LocalBytes;
  };
  if (Before == 0)
    Shadow.StackTop = Now;
  if (Before == 0 || !IsInStore(Now) || !IsInStore(Before))
    return;
  if (Now < Before)
    Shadow.Local->setUndefined(Now, Before - Now);
  else
    Shadow.forgetObjects(Before, Now);
}

void MemoryChecks::loadUndefined(Step &S, const CheckedAccess &A) {
  if (AccessesToParts.contains(A.Pc)) {
    S.Loaded = 0;
    return;
  }
  if (OriginId Known = memoryOf(A).origin(A.Address)) {
    S.LoadedOrigin = Known;
    return;
  }
  UndefinedOrigin Origin;
  const HeapBlock *Block = A.IsLocal ? nullptr : Blocks.nearest(A.Address);
  if (Block) {
    Origin = {"memory that nobody has written, " + Block->describe(A.Address),
              "allocated", Block->AllocatedAt};
  } else {
    const StackObject *Object =
        A.IsLocal ? shadowOf(A.T).nearestObject(A.Address) : nullptr;
    Origin = {"stack memory that the function has not written" +
                  (Object ? ", " + Object->describe(A.Address) : std::string()),
              "loaded from there", placeOf(A.T, A.Pc)};
  }
  S.LoadedOrigin = Origins.add(std::move(Origin));
}

void MemoryChecks::reportUndefined(const char *Kind, const std::string &Title,
                                   std::vector<ReportSide> Sides,
                                   OriginId Origin,
                                   std::optional<uint32_t> Address) {
  const UndefinedOrigin &From = Origins[Origin];
  if (From.PlaceIs)
    Sides.push_back(side(From.PlaceIs, From.Place));
  Program.Found.add({"init", Kind, Title,
                     From.What.empty() ? "" : "it is that of " + From.What,
                     Address, 0, std::move(Sides), ""});
}

void MemoryChecks::reportUndefined(FunctionalThread &T, uint32_t Pc,
                                   const char *Kind, const char *Title,
                                   uint8_t Register) {
  ThreadShadow &Shadow = shadowOf(T);
  OriginId Origin = Shadow.Origin[Register];
  // The consequences are no news.
  Shadow.Undefined[Register] = 0;
  const CodePlace Here = placeOf(T, Pc);
  if (!Wanted.Init || !Program.Found.isNew(Kind, Here, Origins[Origin].Place))
    return;
  reportUndefined(Kind, Title, {side("used", Here)}, Origin);
}

void MemoryChecks::atomic(Step &S, const CheckedAccess &A) {
  checkAccess(memoryOf(A), A, /*IsStore=*/true);
  uint8_t *Bits = memoryOf(A).undefined(A.Address);
  std::memcpy(&S.Loaded, Bits, sizeof(S.Loaded));
  if (S.Loaded == 0)
    return;
  // Becomes what the operation leaves, if that is undefined.
  std::memset(Bits, 0, sizeof(S.Loaded));
  loadUndefined(S, A);
}

void MemoryChecks::streamLoad(Step &S, const CheckedAccess &A) {
  checkAccess(memoryOf(A), A, /*IsStore=*/false);
  UndefinedBits Bits;
  std::memcpy(&Bits, Global->undefined(A.Address), 4);
  S.Loaded |= Bits;
  if (Bits != 0)
    loadUndefined(S, A);
}

void MemoryChecks::streamStore(Step &S, const CheckedAccess &A) {
  checkAccess(memoryOf(A), A, /*IsStore=*/true);
  const UndefinedBits Bits = A.Address >= S.StreamWords ? S.Stored : 0;
  std::memcpy(Global->undefined(A.Address), &Bits, sizeof(Bits));
  if (Bits != 0)
    Global->setOrigin(A.Address, S.StoredOrigin);
}

void MemoryChecks::output(FunctionalThread &T, uint32_t Pc, uint32_t Address,
                          uint32_t Bytes) {
  bool IsLocal = Space.isLocal(Address);
  for (uint32_t I = 0; I != Bytes; ++I) {
    CheckedAccess A{T, Pc, Address + I, 1, nullptr, IsLocal};
    checkAccess(memoryOf(A), A, /*IsStore=*/false);
    if (*memoryOf(A).undefined(A.Address) == 0)
      continue;
    Step S;
    loadUndefined(S, A);
    const CodePlace Here = placeOf(T, Pc);
    if (Wanted.Init && Program.Found.isNew("undefined-output", Here,
                                           Origins[S.LoadedOrigin].Place))
      reportUndefined("undefined-output",
                      "byte " + std::to_string(I) +
                          " of the output is undefined",
                      {side("written", Here)}, S.LoadedOrigin, A.Address);
    return;
  }
}

void MemoryChecks::checkResult(uint32_t Address, uint64_t Bytes,
                               const char *Name) {
  if (!Wanted.Init)
    return;
  for (uint64_t I = 0; I != Bytes; ++I) {
    uint32_t At = uint32_t(Address + I);
    OriginId Origin = Global->origin(At);
    if (*Global->undefined(At) != 0 &&
        Program.Found.isNew("undefined-output", {}, Origins[Origin].Place))
      reportUndefined("undefined-output",
                      "byte " + std::to_string(I) + " of " + Name +
                          " is undefined",
                      {}, Origin, At);
  }
}

//===----------------------------------------------------------------------===//
// Messages of the program
//===----------------------------------------------------------------------===//

void MemoryChecks::message(FunctionalThread &T, uint32_t Pc, uint32_t Marker,
                           uint32_t Value) {
  switch (CheckMessage(Marker)) {
  case CheckMessage::AllocatorEntered:
    shadowOf(T).Requests.push_back(Value);
    return;
  case CheckMessage::Allocated:
    return allocated(T, Pc, Value);
  case CheckMessage::Freeing:
    return freeing(T, Pc, Value);
  case CheckMessage::Resized:
    return resized(T, Pc, Value);
  case CheckMessage::AllocatorLeft:
    leaveAllocator(T);
    return;
  case CheckMessage::StackObject:
    shadowOf(T).ObjectDescriptor = Value;
    return;
  case CheckMessage::ObjectBytes:
    shadowOf(T).ObjectBytes = Value;
    return;
  case CheckMessage::ObjectBegins:
    return objectBegins(T, Pc, Value);
  case CheckMessage::ObjectEnds:
    return objectEnds(T, Pc, Value);
  }
}

uint32_t MemoryChecks::leaveAllocator(FunctionalThread &T) {
  std::vector<uint32_t> &Requests = shadowOf(T).Requests;
  if (Requests.empty())
    return 0;
  uint32_t Bytes = Requests.back();
  Requests.pop_back();
  return Bytes;
}

void MemoryChecks::markBlock(uint32_t Address, uint32_t Bytes) {
  Global->setAccess(Address, Bytes, Access::All);
  // Others' memory has no padding.
  if (Address < Program.HeapBegin || Address >= Program.HeapEnd)
    return;
  if (HeapFrontier < Address)
    Global->setAccess(HeapFrontier, Address - HeapFrontier,
                      Access::HeapPadding);
  const uint32_t Padding = toGranules(Address + Bytes);
  Global->setAccess(Padding, HeapPaddingBytes, Access::HeapPadding);
  HeapFrontier = std::max(HeapFrontier, Padding + HeapPaddingBytes);
}

bool MemoryChecks::isBlock(uint32_t Address, uint32_t Bytes) const {
  static_assert(HeapPaddingBytes >= CheckedObject::PaddingBytes);
  constexpr uint32_t Behind = AccessGranule + HeapPaddingBytes;
  return Address % AccessGranule == 0 && Bytes <= UINT32_MAX - Behind &&
         hasGlobal(Address, Bytes + Behind);
}

void MemoryChecks::allocated(FunctionalThread &T, uint32_t Pc,
                             uint32_t Address) {
  uint32_t Bytes = leaveAllocator(T);
  if (Address == 0 || !isBlock(Address, Bytes))
    return;
  markBlock(Address, Bytes);
  Global->setUndefined(Address, Bytes);
  Blocks.add({Address, Bytes, placeOf(T, Pc), std::nullopt});
}

void MemoryChecks::resized(FunctionalThread &T, uint32_t Pc, uint32_t Address) {
  uint32_t Bytes = leaveAllocator(T);
  HeapBlock *Block = Blocks.at(Address);
  if (!Block || !isBlock(Address, Bytes))
    return;
  uint32_t OldBytes = Block->Bytes;
  markBlock(Address, Bytes);
  if (Bytes > OldBytes)
    Global->setUndefined(Address + OldBytes, Bytes - OldBytes);
  else
    Global->setAccess(toGranules(Address + Bytes),
                      (OldBytes - Bytes) & ~(AccessGranule - 1),
                      Access::HeapPadding);
  Blocks.add({Address, Bytes, placeOf(T, Pc), std::nullopt});
}

void MemoryChecks::freeing(FunctionalThread &T, uint32_t Pc, uint32_t Address) {
  HeapBlock *Block = Blocks.at(Address);
  const CodePlace Here = placeOf(T, Pc);
  if (Block && !Block->FreedAt) {
    Block->FreedAt = Here;
    Global->setAccess(Address, toGranules(Block->Bytes), Access::HeapFreed);
    return;
  }
  const char *Kind = Block ? DoubleFree : "invalid-free";
  if (!Wanted.Memory ||
      !Program.Found.isNew(Kind, Here, Block ? Block->AllocatedAt : Here))
    return;
  Report R{"memory",
           Kind,
           Block ? "memory is given back that was given back before"
                 : "memory is given back that was not allocated",
           "",
           Address,
           0,
           {side("given back", Here)},
           ""};
  const HeapBlock *Near = Blocks.nearest(Address);
  if (Space.isLocal(Address))
    nameStackObject(T, Address, R);
  else if (Near && Address >= Program.HeapBegin)
    nameBlock(*Near, Address, R);
  else
    R.Object = Program.Names.describe(Address).value_or("");
  Program.Found.add(R);
}

bool MemoryChecks::isLocalObject(uint32_t Address, uint32_t Bytes) const {
  const uint64_t Begin = Space.LocalBegin;
  const uint64_t End = Begin + Space.LocalBytes;
  return Address % AccessGranule == 0 && Address >= Begin && Address < End &&
         uint64_t(Bytes) + AccessGranule + CheckedObject::PaddingBytes <=
             End - Address;
}

void MemoryChecks::objectBegins(FunctionalThread &T, uint32_t Pc,
                                uint32_t Address) {
  ThreadShadow &Shadow = shadowOf(T);
  CheckedObject Object;
  if (!hasGlobal(Shadow.ObjectDescriptor, sizeof(Object)))
    return;
  std::memcpy(&Object, Space.Global + Shadow.ObjectDescriptor, sizeof(Object));
  if (Object.Bytes == CheckedObject::VariableBytes)
    Object.Bytes = Shadow.ObjectBytes;
  const uint32_t Before = Address - CheckedObject::PaddingBytes;
  if (!isLocalObject(Before, CheckedObject::PaddingBytes) ||
      !isLocalObject(Address, Object.Bytes))
    return;
  Shadow.Local->setAccess(Before, CheckedObject::PaddingBytes,
                          Access::StackPadding);
  Shadow.Local->setAccess(Address, Object.Bytes, Access::All);
  Shadow.Local->setAccess(toGranules(Address + Object.Bytes),
                          CheckedObject::PaddingBytes, Access::StackPadding);
  Shadow.Local->setUndefined(Address, Object.Bytes);
  Shadow.Objects[Address] = {Address, Object.Bytes, textAt(Object.Name),
                             placeOf(T, Pc)};
}

bool MemoryChecks::hasGlobal(uint32_t Address, uint32_t Bytes) const {
  return Space.isGlobal(Address) &&
         Bytes <= Space.GlobalBytes - (Address - kGlobalMemoryBegin);
}

std::string_view MemoryChecks::textAt(uint32_t Address) const {
  constexpr uint32_t MaxNameBytes = 256;
  if (!hasGlobal(Address, MaxNameBytes))
    return "";
  const auto *Text = reinterpret_cast<const char *>(Space.Global) + Address;
  return {Text, strnlen(Text, MaxNameBytes)};
}

void MemoryChecks::objectEnds(FunctionalThread &T, uint32_t, uint32_t Address) {
  ThreadShadow &Shadow = shadowOf(T);
  auto Known = Shadow.Objects.find(Address);
  if (Known != Shadow.Objects.end())
    Shadow.Local->setAccess(Address, toGranules(Known->second.Bytes),
                            Access::StackDead);
}

} // namespace tp
