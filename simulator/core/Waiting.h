//===- Waiting.h - Threads that cannot issue --------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_WAITING_H
#define TP_SIMULATOR_CORE_WAITING_H

#include "simulator/core/Slot.h"
#include "simulator/core/ThreadRequests.h"

namespace tp::waiting {

/// The loss of waiting for a result that this level served.
constexpr Loss lossOf(ServedBy Level) {
  switch (Level) {
  case ServedBy::L1:
    return Loss::L1;
  case ServedBy::L2:
    return Loss::L2;
  case ServedBy::DramQueue:
  case ServedBy::DramRowHit:
  case ServedBy::DramRowMiss:
  case ServedBy::DramRowConflict:
    return Loss::Dram;
  case ServedBy::Memory:
    return Loss::Memory;
  }
  __builtin_unreachable();
}

/// Charges the thread for waiting for what an instruction produces.
inline void chargeProducer(Thread *T, uint32_t Word, TmRunnerState *R,
                           Loss Reason, Opcode Producer, uint64_t Cycles) {
  R->charge(*T, Word, Reason, Cycles);
  T->LastProducer = Producer;
  R->DataStall[unsigned(Producer)] += Cycles;
}

/// Charges it for waiting for those sources of its next instruction that are
/// \p Latest: of several the one from the farthest level.
template <class Word>
void chargeSources(Thread *T, const Slot<Word> *S, TmRunner<Word> *R,
                   ReadyWord Latest, uint64_t Cycles) {
  Loss Reason = Loss::Data;
  if ((Latest & ready::FromGlobalMemory) != 0) {
    ServedBy Level = T->Requests ? ServedBy::L1 : ServedBy::Memory;
    if (T->Requests)
      for (uint8_t Source : S->Instruction.Source)
        if (T->Ready[Source] == Latest)
          Level = std::max(Level, T->Requests->request(Source).level());
    Reason = lossOf(Level);
  }
  chargeProducer(T, S->Number, R, Reason, ready::producerOf(Latest), Cycles);
}

/// The thread goes on with \p S in relative cycle \p Cycle.
template <class Word>
void leave(Thread *T, const Slot<Word> *S, uint64_t Cycle, TmRunner<Word> *R) {
  T->Resume = S;
  R->NextCycle = R->Epoch + Cycle;
}

/// The thread goes on with \p S when it is known when it can; it waits for what
/// \p Producer makes.
template <class Word>
void suspend(Thread *T, const Slot<Word> *S, uint64_t Cycle, TmRunner<Word> *R,
             Awaited What, Opcode Producer) {
  T->Resume = S;
  T->LastWord = S->Number;
  T->LastProducer = Producer;
  T->Requests->suspend(What, R->Epoch + Cycle);
  R->NextCycle = NeverCycle;
}

/// The thread goes on with \p S, whose line nobody has yet, when it has come.
template <class Word>
void missLine(Thread *T, const Slot<Word> *S, uint64_t Cycle,
              TmRunner<Word> *R) {
  T->Resume = S;
  T->LastWord = S->Number;
  R->Icache->addMiss({R->Epoch + Cycle, T->Line, priorityOf(R->OwnOrder),
                      uint16_t(T->Number % R->Chip.Chip->TpsPerTm)});
  if (T->Requests)
    T->Requests->suspend(Awaited::Line, R->Epoch + Cycle);
  R->NextCycle = NeverCycle;
}

/// The cycle in which a suspended thread goes on, charged up to there;
/// NeverCycle if that is not known yet.
template <class Word> uint64_t resume(Thread *T, TmRunner<Word> *R) {
  ThreadRequests &Requests = *T->Requests;
  auto *S = static_cast<const Slot<Word> *>(T->Resume);
  const uint64_t From = Requests.suspendedAt();
  uint64_t To = From;
  switch (Requests.waitsFor()) {
  case Awaited::Nothing:
    __builtin_unreachable();
  case Awaited::Sources: {
    ReadyWord Latest = latestSource<3>(T, S);
    if (ready::isPending(Latest)) {
      // Who is charged if the run ends now.
      T->LastProducer = ready::producerOf(Latest);
      return NeverCycle;
    }
    To = std::max(From, R->Epoch + ready::cycleOf(Latest));
    if (To != From)
      chargeSources(T, S, R, Latest, To - From);
    break;
  }
  case Awaited::StoreEntry:
    if (Requests.oldestStore().FreeFrom == ThreadRequests::NeverFree)
      return NeverCycle;
    To = std::max(From, Requests.oldestStore().FreeFrom);
    chargeProducer(T, S->Number, R, Loss::StoreBuffer, S->Instruction.Op,
                   To - From);
    break;
  case Awaited::AllStores:
    if (Requests.unansweredStores() != 0)
      return NeverCycle;
    To = std::max(From, Requests.lastStoreAnswer());
    R->charge(*T, T->LastWord, Loss::Sync, To - From);
    break;
  case Awaited::Line:
    To = R->Icache->arrivalOf(T->Line, From);
    if (To == InstructionCache::Unknown)
      return NeverCycle;
    R->charge(*T, T->LastWord, Loss::IcacheMiss, To - From);
    break;
  }
  Requests.resume();
  return To;
}

} // namespace tp::waiting

#endif // TP_SIMULATOR_CORE_WAITING_H
