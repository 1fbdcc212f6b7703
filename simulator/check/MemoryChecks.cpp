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

MemoryChecks::MemoryChecks(const MemoryCheckOptions &Wanted,
                           CheckedProgram &Program)
    : Wanted(Wanted), Program(Program) {
  for (const AtomicAccess &Known : Program.Elf.atomicAccesses())
    AtomicAccesses.insert(Known.Address);
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
  if (!IsMapped)
    Error = "the host has no room for what --check knows of each byte";
  else
    padGlobals();
  StackBegin = Program.Elf.stackLimit().value_or(Space.LocalBegin);
  if (Program.HeapEnd != 0)
    HeapFrontier = Program.HeapBegin;
}

void MemoryChecks::padGlobals() {
  for (const CheckedGlobal &Known : Program.Globals) {
    const uint32_t Padded =
        (Known.Bytes + AccessGranule - 1) & ~(AccessGranule - 1);
    if (!isBlock(Known.Address, Padded))
      continue;
    Global->setAccess(Known.Address, Known.Bytes, Access::All);
    Global->setAccess(Known.Address + Padded, CheckedObject::PaddingBytes,
                      Access::GlobalPadding);
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
  Access Why = Access(Code);
  if (Code < AccessGranule)
    Why = Access(memoryOf(A).accessOf(A.Address + AccessGranule));
  reportAccess(A, IsStore, Why);
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
  if (!Program.Found.isNew("stack-use-after-return", A.Pc, 0))
    return;
  Program.Found.add(
      {"stack",
       "stack-use-after-return",
       std::string(IsStore ? "store" : "load") + " of " + inBytes(A.Bytes) +
           " below the stack pointer",
       "the function whose memory that was has returned",
       A.Address,
       A.Bytes,
       {side(IsStore ? "stored" : "loaded", placeOf(A.T, A.Pc))}});
}

/// The name of the fault of an access to what \p Code says.
static const char *kindOf(Access Code) {
  switch (Code) {
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
  default:
    return "launch-out-of-bounds";
  }
}

void MemoryChecks::reportAccess(const CheckedAccess &A, bool IsStore,
                                Access Code) {
  if (!Wanted.Memory)
    return;
  const HeapBlock *Block = A.IsLocal || A.Address < Program.HeapBegin
                               ? nullptr
                               : Blocks.nearest(A.Address);
  const char *Kind = kindOf(Code);
  if (!Program.Found.isNew(Kind, A.Pc, Block ? Block->AllocatedAt.Pc : 0))
    return;
  Report R{"memory",
           Kind,
           std::string(IsStore ? "store" : "load") + " of " + inBytes(A.Bytes),
           "",
           A.Address,
           A.Bytes,
           {side(IsStore ? "stored" : "loaded", placeOf(A.T, A.Pc))}};
  if (A.IsLocal) {
    const StackObject *Object = shadowOf(A.T).nearestObject(A.Address);
    if (Object) {
      R.Object = Object->describe(A.Address);
      R.Sides.push_back(side("the object began to live", Object->BeganAt));
    }
  } else if (Block) {
    R.Object = Block->describe(A.Address);
    if (Block->FreedAt)
      R.Sides.push_back(side("given back", *Block->FreedAt));
    R.Sides.push_back(side("allocated", Block->AllocatedAt));
  } else if (std::optional<std::string> Name =
                 Program.Names.describe(A.Address)) {
    R.Object = *Name;
  }
  Program.Found.add(R);
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
       {side("overflow", {Why.Thread, Why.Pc, Shadow.Calls.context()})}});
}

//===----------------------------------------------------------------------===//
// Undefined values
//===----------------------------------------------------------------------===//

void MemoryChecks::stackMoved(FunctionalThread &T, uint32_t) {
  ThreadShadow &Shadow = shadowOf(T);
  const uint32_t Now = T.Registers[StackPointerRegister];
  const uint32_t Before = std::exchange(Shadow.StackPointer, Now);
  auto isInStore = [this](uint32_t At) {
    return At - Space.LocalBegin <= Space.LocalBytes;
  };
  if (Before == 0)
    Shadow.StackTop = Now;
  if (Before == 0 || !isInStore(Now) || !isInStore(Before))
    return;
  if (Now < Before)
    Shadow.Local->setUndefined(Now, Before - Now);
  else
    Shadow.forgetObjects(Before, Now);
}

void MemoryChecks::loadUndefined(Step &S, const CheckedAccess &A) {
  if (AtomicAccesses.contains(A.Pc)) {
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

void MemoryChecks::storeUndefined(const CheckedAccess &A, OriginId Origin) {
  memoryOf(A).setOrigin(A.Address, Origin);
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
                     Address, 0, std::move(Sides)});
}

void MemoryChecks::reportUndefined(FunctionalThread &T, uint32_t Pc,
                                   const char *Kind, const char *Title,
                                   uint8_t Register) {
  ThreadShadow &Shadow = shadowOf(T);
  OriginId Origin = Shadow.Origin[Register];
  // The consequences are no news.
  Shadow.Undefined[Register] = 0;
  if (!Wanted.Init || !Program.Found.isNew(Kind, Pc, Origin))
    return;
  reportUndefined(Kind, Title, {side("used", placeOf(T, Pc))}, Origin);
}

void MemoryChecks::atomic(Step &S, const CheckedAccess &A) {
  checkAccess(A, /*IsStore=*/true);
  ShadowMemory &Memory = memoryOf(A);
  std::memcpy(&S.Loaded, Memory.undefined(A.Address), 4);
  if (S.Loaded != 0)
    loadUndefined(S, A);
  UndefinedBits New = S.Loaded | S.Stored;
  std::memcpy(Memory.undefined(A.Address), &New, 4);
  if (New != 0)
    storeUndefined(A, S.Stored != 0 ? S.StoredOrigin : S.LoadedOrigin);
}

void MemoryChecks::streamLoad(Step &S, const CheckedAccess &A) {
  checkAccess(A, /*IsStore=*/false);
  UndefinedBits Bits;
  std::memcpy(&Bits, Global->undefined(A.Address), 4);
  S.Loaded |= Bits;
  if (Bits != 0)
    loadUndefined(S, A);
}

void MemoryChecks::streamStore(Step &S, const CheckedAccess &A) {
  checkAccess(A, /*IsStore=*/true);
  std::memcpy(Global->undefined(A.Address), &S.Stored, 4);
  if (S.Stored != 0)
    storeUndefined(A, S.StoredOrigin);
}

void MemoryChecks::output(FunctionalThread &T, uint32_t Pc, uint32_t Address,
                          uint32_t Bytes) {
  bool IsLocal = Space.isLocal(Address);
  for (uint32_t I = 0; I != Bytes; ++I) {
    CheckedAccess A{T, Pc, Address + I, 1, nullptr, IsLocal};
    checkAccess(A, /*IsStore=*/false);
    if (*memoryOf(A).undefined(A.Address) == 0)
      continue;
    Step S;
    loadUndefined(S, A);
    if (Wanted.Init &&
        Program.Found.isNew("undefined-output", Pc, S.LoadedOrigin))
      reportUndefined(
          "undefined-output",
          "byte " + std::to_string(I) + " of the output is undefined",
          {side("written", placeOf(T, Pc))}, S.LoadedOrigin, A.Address);
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
        Program.Found.isNew("undefined-output", 0, Origin))
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
  uint32_t End = Address + Bytes;
  if (HeapFrontier < Address)
    Global->setAccess(HeapFrontier & ~(AccessGranule - 1),
                      Address - (HeapFrontier & ~(AccessGranule - 1)),
                      Access::HeapPadding);
  Global->setAccess(Address, Bytes, Access::All);
  // Others' memory has no padding.
  if (Address < Program.HeapBegin || Address >= Program.HeapEnd)
    return;
  uint32_t Padding = (End + AccessGranule - 1) & ~(AccessGranule - 1);
  Global->setAccess(Padding, HeapPaddingBytes, Access::HeapPadding);
  HeapFrontier = std::max(HeapFrontier, Padding + HeapPaddingBytes);
}

bool MemoryChecks::isBlock(uint32_t Address, uint32_t Bytes) const {
  const uint64_t WithPadding =
      uint64_t(Bytes) + AccessGranule + HeapPaddingBytes;
  return Address % AccessGranule == 0 && Space.isGlobal(Address) &&
         WithPadding <= Space.GlobalBytes - (Address - kGlobalMemoryBegin);
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
    Global->setAccess(
        (Address + Bytes + AccessGranule - 1) & ~(AccessGranule - 1),
        (OldBytes - Bytes) & ~(AccessGranule - 1), Access::HeapPadding);
  Blocks.add({Address, Bytes, placeOf(T, Pc), std::nullopt});
}

void MemoryChecks::freeing(FunctionalThread &T, uint32_t Pc, uint32_t Address) {
  HeapBlock *Block = Blocks.at(Address);
  CodePlace Here = placeOf(T, Pc);
  if (Block && !Block->FreedAt) {
    Block->FreedAt = Here;
    Global->setAccess(Address,
                      (Block->Bytes + AccessGranule - 1) & ~(AccessGranule - 1),
                      Access::HeapFreed);
    return;
  }
  const char *Kind = Block ? "double-free" : "invalid-free";
  if (!Wanted.Memory ||
      !Program.Found.isNew(Kind, Pc, Block ? Block->AllocatedAt.Pc : 0))
    return;
  Report R{"memory",
           Kind,
           Block ? "memory is given back that was given back before"
                 : "memory is given back that was not allocated",
           "",
           Address,
           0,
           {side("given back", Here)}};
  if (Block) {
    R.Object = Block->describe(Address);
    R.Sides.push_back(side("given back before", *Block->FreedAt));
    R.Sides.push_back(side("allocated", Block->AllocatedAt));
  } else if (const HeapBlock *Near = Blocks.nearest(Address)) {
    R.Object = Near->describe(Address);
    R.Sides.push_back(side("allocated", Near->AllocatedAt));
  }
  Program.Found.add(R);
}

void MemoryChecks::objectBegins(FunctionalThread &T, uint32_t Pc,
                                uint32_t Address) {
  ThreadShadow &Shadow = shadowOf(T);
  CheckedObject Object;
  if (!Space.isGlobal(Shadow.ObjectDescriptor) || !Space.isLocal(Address))
    return;
  std::memcpy(&Object, Space.Global + Shadow.ObjectDescriptor, sizeof(Object));
  const char *Name =
      Space.isGlobal(Object.Name)
          ? reinterpret_cast<const char *>(Space.Global) + Object.Name
          : "";
  const uint32_t Padded =
      (Object.Bytes + AccessGranule - 1) & ~(AccessGranule - 1);
  Shadow.Local->setAccess(Address - CheckedObject::PaddingBytes,
                          CheckedObject::PaddingBytes, Access::StackPadding);
  Shadow.Local->setAccess(Address, Object.Bytes, Access::All);
  Shadow.Local->setAccess(Address + Padded, CheckedObject::PaddingBytes,
                          Access::StackPadding);
  Shadow.Local->setUndefined(Address, Object.Bytes);
  Shadow.Objects[Address] = {Address, Object.Bytes, Name, placeOf(T, Pc)};
}

void MemoryChecks::objectEnds(FunctionalThread &T, uint32_t, uint32_t Address) {
  ThreadShadow &Shadow = shadowOf(T);
  auto Known = Shadow.Objects.find(Address);
  if (Known != Shadow.Objects.end())
    Shadow.Local->setAccess(Address,
                            (Known->second.Bytes + AccessGranule - 1) &
                                ~(AccessGranule - 1),
                            Access::StackDead);
}

} // namespace tp
