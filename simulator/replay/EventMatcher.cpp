//===- EventMatcher.cpp - Whether an instruction is an event --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/replay/EventMatcher.h"
#include "simulator/core/LocalStore.h"
#include "simulator/isa/StreamAccess.h"

#include <array>
#include <bit>
#include <cstring>

namespace tp {

uint32_t nextTimedWord(const Program &Text, uint32_t Word) {
  std::span<const Instruction> All = Text.instructions();
  while (Word < All.size() && All[Word].Op != IllegalOpcode &&
         !takesTime(All[Word].Op))
    ++Word;
  return Word;
}

EventMatcher::EventMatcher(const ChipConfig &Chip, const Program &Text,
                           const Events &Wanted, Which Kept,
                           std::optional<EventPlace> After,
                           std::optional<EventPlace> Before)
    : Text(Text), Wanted(Wanted), Kept(Kept), After(After), Before(Before),
      LocalBegin(LocalStoreRange(Chip.LocalStoreBytes).Begin),
      Words(Text.instructions().size()) {
  std::span<const Instruction> All = Text.instructions();
  for (const InstructionEvents &Event : Wanted.Instructions) {
    std::vector<bool> &Of = WordsOf.emplace_back();
    if (Event.Pcs.empty())
      Words.assign(All.size(), true);
    else
      Of.resize(All.size());
    for (uint32_t Pc : Event.Pcs) {
      const uint32_t Word = nextTimedWord(Text, (Pc - Text.textBegin()) / 4);
      if (Word < All.size())
        Words[Word] = Of[Word] = true;
    }
  }
  if (Wanted.Accesses.empty())
    return;
  for (size_t Word = 0; Word != All.size(); ++Word)
    if (All[Word].Op != IllegalOpcode && accessesMemory(All[Word].Op))
      Words[Word] = true;
}

bool EventMatcher::isIn(const AccessEvents &Event, const MemoryAccess &Access,
                        uint32_t Thread) const {
  if (!((Event.Reads && Access.Reads) || (Event.Writes && Access.Writes)))
    return false;
  if (Event.Thread && *Event.Thread != Thread)
    return false;
  if (!Event.Thread && Event.Address >= LocalBegin)
    return false;
  return overlaps(Event, Access.Address, Access.Bytes);
}

template <class Event> static bool matches(const Event &E, const Probe &Place) {
  return (!E.Thread || *E.Thread == Place.Thread) &&
         (!E.Wanted || E.Wanted(Place));
}

std::optional<FoundEvent>
EventMatcher::findInstruction(const Probe &Place) const {
  const size_t Word = (Place.Pc - Text.textBegin()) / 4;
  for (size_t I = 0; I != Wanted.Instructions.size(); ++I)
    if ((WordsOf[I].empty() || WordsOf[I][Word]) &&
        matches(Wanted.Instructions[I], Place))
      return FoundEvent{
          ReplayStop::Instruction, Place.At, Place.Thread, Place.Pc, I, {}};
  return std::nullopt;
}

/// The bytes of the whole stream; those of its descriptor if it is none.
static uint32_t streamBytes(uint32_t Descriptor, const Probe &Place) {
  std::array<uint8_t, 4> Bytes;
  uint32_t Capacity = 0;
  if (Place.Read(Descriptor + 8, Bytes))
    std::memcpy(&Capacity, Bytes.data(), sizeof(Capacity));
  if (!std::has_single_bit(Capacity) || Capacity > UINT32_MAX / 8)
    Capacity = 0;
  return StreamDescriptorBytes + Capacity * 4;
}

std::optional<FoundEvent> EventMatcher::findAccess(const Probe &Place) const {
  if (Wanted.Accesses.empty())
    return std::nullopt;
  const size_t Word = (Place.Pc - Text.textBegin()) / 4;
  std::optional<MemoryAccess> Access =
      accessOf(Text.instructions()[Word], Place.Registers);
  if (!Access)
    return std::nullopt;
  if (Access->IsStream)
    Access->Bytes = streamBytes(Access->Address, Place);
  for (size_t I = 0; I != Wanted.Accesses.size(); ++I)
    if (isIn(Wanted.Accesses[I], *Access, Place.Thread) &&
        matches(Wanted.Accesses[I], Place))
      return FoundEvent{ReplayStop::Access, Place.At, Place.Thread,
                        Place.Pc,           I,        *Access};
  return std::nullopt;
}

std::optional<FoundEvent> EventMatcher::match(const Probe &Place) const {
  const bool WantsInstruction = isWanted({Place.At, false});
  const bool WantsAccess = isWanted({Place.At, true});
  std::optional<FoundEvent> Found;
  if (WantsInstruction && Kept == First)
    Found = findInstruction(Place);
  if (WantsAccess && !Found)
    Found = findAccess(Place);
  if (WantsInstruction && Kept == Last && !Found)
    Found = findInstruction(Place);
  return Found;
}

} // namespace tp
