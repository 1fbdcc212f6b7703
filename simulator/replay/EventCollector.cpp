//===- EventCollector.cpp - Finds events while an engine runs -------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/replay/EventCollector.h"
#include "simulator/core/LocalStore.h"
#include "simulator/core/WindowLog.h"

namespace tp {

uint32_t orderOf(const ChipConfig &Chip, uint64_t Cycle, uint32_t Thread) {
  const uint32_t Tm = Thread / Chip.TpsPerTm;
  const uint32_t Tp = Thread % Chip.TpsPerTm;
  const auto First = uint32_t(Cycle / Chip.ArbitrationWindow % Chip.TpsPerTm);
  const uint32_t Priority =
      Tp >= First ? Tp - First : Tp + Chip.TpsPerTm - First;
  return uint32_t(orderKey(0, Priority, Tm));
}

EventCollector::EventCollector(const ChipConfig &Chip, const Program &Text,
                               const Events &Wanted, Which Kept,
                               std::optional<EventPlace> After,
                               std::optional<EventPlace> Before)
    : Chip(Chip), Text(Text), Wanted(Wanted), Kept(Kept), After(After),
      Before(Before), LocalBegin(LocalStoreRange(Chip.LocalStoreBytes).Begin),
      Words(Text.instructions().size()), Tentative(Chip.threadCount()) {
  std::span<const Instruction> All = Text.instructions();
  for (const InstructionEvents &Event : Wanted.Instructions) {
    std::vector<bool> &Of = WordsOf.emplace_back();
    if (Event.Pcs.empty())
      Words.assign(All.size(), true);
    else
      Of.resize(All.size());
    for (uint32_t Pc : Event.Pcs) {
      size_t Word = (Pc - Text.textBegin()) / 4;
      // Threads pass over what takes no time.
      while (Word < All.size() && All[Word].Op != IllegalOpcode &&
             !takesTime(All[Word].Op))
        ++Word;
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

bool EventCollector::isIn(const AccessEvents &Event, const MemoryAccess &Access,
                          uint32_t Thread) const {
  if (!((Event.Reads && Access.Reads) || (Event.Writes && Access.Writes)))
    return false;
  if (Event.Thread && *Event.Thread != Thread)
    return false;
  if (!Event.Thread && Event.Address >= LocalBegin)
    return false;
  return Access.Address < uint64_t(Event.Address) + Event.Bytes &&
         Event.Address < uint64_t(Access.Address) + Access.Bytes;
}

template <class Event> static bool matches(const Event &E, const Probe &Place) {
  return (!E.Thread || *E.Thread == Place.Thread) &&
         (!E.Wanted || E.Wanted(Place));
}

std::optional<FoundEvent>
EventCollector::findInstruction(const Probe &Place) const {
  const size_t Word = (Place.Pc - Text.textBegin()) / 4;
  for (size_t I = 0; I != Wanted.Instructions.size(); ++I)
    if ((WordsOf[I].empty() || WordsOf[I][Word]) &&
        matches(Wanted.Instructions[I], Place))
      return FoundEvent{
          ReplayStop::Instruction, Place.At, Place.Thread, Place.Pc, I, {}};
  return std::nullopt;
}

std::optional<FoundEvent> EventCollector::findAccess(const Probe &Place) const {
  if (Wanted.Accesses.empty())
    return std::nullopt;
  const size_t Word = (Place.Pc - Text.textBegin()) / 4;
  std::optional<MemoryAccess> Access =
      accessOf(Text.instructions()[Word], Place.Registers);
  if (!Access)
    return std::nullopt;
  for (size_t I = 0; I != Wanted.Accesses.size(); ++I)
    if (isIn(Wanted.Accesses[I], *Access, Place.Thread) &&
        matches(Wanted.Accesses[I], Place))
      return FoundEvent{ReplayStop::Access, Place.At, Place.Thread,
                        Place.Pc,           I,        *Access};
  return std::nullopt;
}

void EventCollector::issuing(const Thread &T, uint32_t Word, uint64_t Cycle,
                             const TmRunnerState &Runner) {
  const std::lock_guard Guard(Lock);
  std::optional<FoundEvent> &Own = Tentative[T.Number];
  if (Own)
    keep(*Own);
  Own.reset();
  const Moment At{Cycle, orderOf(Chip, Cycle, T.Number)};
  const bool WantsInstruction = isWanted({At, false});
  const bool WantsAccess = isWanted({At, true});
  if (!WantsInstruction && !WantsAccess)
    return;
  std::function<bool(uint32_t, std::span<uint8_t>)> Read =
      [&](uint32_t Address, std::span<uint8_t> Bytes) {
        return readAsThread(T, Runner, Address, Bytes);
      };
  Probe Place{T.Number, Text.textBegin() + Word * 4, At, T.Registers, Read};
  if (WantsInstruction && Kept == First)
    Own = findInstruction(Place);
  if (WantsAccess && !Own)
    Own = findAccess(Place);
  if (WantsInstruction && Kept == Last && !Own)
    Own = findInstruction(Place);
  if (!Own || Kept != First)
    return;
  MayHaveFound = true;
  if (StopFlag)
    *StopFlag = true;
}

void EventCollector::postponed(const Thread &T) {
  const std::lock_guard Guard(Lock);
  Tentative[T.Number].reset();
}

void EventCollector::keep(const FoundEvent &Candidate) {
  if (!Best || (Kept == First ? Candidate.place() < Best->place()
                              : Candidate.place() > Best->place()))
    Best = Candidate;
}

std::optional<FoundEvent> EventCollector::found() {
  for (std::optional<FoundEvent> &Own : Tentative) {
    if (Own)
      keep(*Own);
    Own.reset();
  }
  return Best;
}

} // namespace tp
