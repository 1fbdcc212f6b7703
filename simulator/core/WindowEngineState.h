//===- WindowEngineState.h - An engine's state from and to outside -*- C++ -*-//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_WINDOWENGINESTATE_H
#define TP_SIMULATOR_CORE_WINDOWENGINESTATE_H

#include "simulator/core/WindowEngine.h"

namespace tp {

template <class Word, bool FlushToZero>
void WindowEngine<Word, FlushToZero>::setInitialState(
    std::span<const ArchitecturalState> States) {
  LocalStoreRange Local(Chip.LocalStoreBytes);
  Schedule.clear();
  for (uint32_t I = 0; I != Threads.size(); ++I) {
    const ArchitecturalState &From = States[I];
    Thread &T = Threads[I];
    uint32_t NextWord = (From.Pc - Context.TextBegin) / 4;
    T.Registers = From.Registers;
    T.Resume = &Slots[NextWord];
    T.State = From.State;
    T.Status = From.Status;
    std::memcpy(reinterpret_cast<void *>(T.LocalStoreBias + Local.Begin),
                From.LocalStore, Chip.LocalStoreBytes);
    Waiting += T.State == ThreadState::AtBarrier;
    Halted += T.State == ThreadState::Halted;
    if (T.State == ThreadState::Running) {
      Schedule.wake(I / Chip.TpsPerTm, 0);
    } else {
      NextCycles[I] = NeverCycle;
      T.LastWord = NextWord - 1;
    }
  }
}

template <class Word, bool FlushToZero>
void WindowEngine<Word, FlushToZero>::setRegister(uint32_t Number,
                                                  unsigned Register,
                                                  uint32_t Value) {
  if (Register == 0)
    return;
  Threads[Number].Registers[Register] = Value;
  Threads[Number].Ready[Register] = 0;
}

template <class Word, bool FlushToZero>
void WindowEngine<Word, FlushToZero>::setNextWord(uint32_t Number,
                                                  uint32_t NextWord) {
  Thread &T = Threads[Number];
  T.Resume = &Slots[NextWord];
  T.Line = NoLine;
  if (!T.Requests || (T.Requests->waitsFor() != Awaited::Sources &&
                      T.Requests->waitsFor() != Awaited::Line))
    return;
  T.Requests->resume();
  NextCycles[Number] = WindowEnd;
  Schedule.wake(Number / Chip.TpsPerTm, WindowEnd);
}

template <class Word, bool FlushToZero>
void WindowEngine<Word, FlushToZero>::serialize(Archive &A, Thread &T) {
  auto Resume =
      uint32_t(static_cast<const Slot<Word> *>(T.Resume) - Slots.data());
  A(Resume);
  if (Resume < Slots.size())
    T.Resume = &Slots[Resume];
  A(T.Registers);
  A(T.Ready);
  A(T.Lost);
  A(T.EndCycle);
  A(T.Status);
  A(T.State);
  A(T.LastLoss);
  A(T.LastProducer);
  A(T.LastWord);
  A(T.Line);
  if (T.Requests)
    T.Requests->serialize(A);
}

template <class Word, bool FlushToZero>
void WindowEngine<Word, FlushToZero>::serializeCounters(Archive &A) {
  TmRunnerState Sum;
  Sum.IssuedAt.resize(Slots.size());
  Sum.LostAt.resize(Slots.size());
  for (std::unique_ptr<Runner> &R : Runners)
    R->moveCountersTo(Sum);
  A(Sum.IssuedAt);
  A(Sum.LostAt);
  A(Sum.DataStall);
  A(Sum.Markers);
  Sum.moveCountersTo(*Runners[0]);
}

template <class Word, bool FlushToZero>
void WindowEngine<Word, FlushToZero>::serialize(Archive &A) {
  prepareHostThreads();
  foldCodeCounts();
  for (Thread &T : Threads)
    serialize(A, T);
  LocalStores.serialize(A);
  serializeCounters(A);
  A(NextCycles);
  A(Schedule);
  A(Unanswered);
  A(UndecidedFrom);
  A(WindowEnd);
  A(Epoch);
  A(Waiting);
  A(Halted);
  A(EndCycle);
  if (A.isRestoring()) {
    Final.reset();
    FirstTrap.reset();
    for (std::unique_ptr<Runner> &R : Runners)
      R->FirstTrap.reset();
  }
  for (InstructionCache &Icache : Icaches)
    A(Icache);
  if (Hierarchy)
    Hierarchy->serialize(A);
}

} // namespace tp

#endif // TP_SIMULATOR_CORE_WINDOWENGINESTATE_H
