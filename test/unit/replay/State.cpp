//===- State.cpp - What can be seen of a machine --------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/replay/State.h"
#include "simulator/core/LocalStore.h"
#include "simulator/replay/EventMatcher.h"

#include <span>

namespace tp::test {

static void addMemory(State &To, const Memory &Global) {
  To.Memory.assign(Global.data() + kGlobalMemoryBegin,
                   Global.data() + Global.size());
}

static void addCounts(State &To, const Statistics &Counts) {
  for (const PcStatistics &Pc : Counts.Pcs)
    To.Executed.push_back(Pc.Executed);
  for (const ThreadStatistics &Thread : Counts.Threads) {
    To.Issued.push_back(Thread.Instructions);
    To.Lost.push_back(Thread.Lost);
  }
}

static void addThread(State &To,
                      const std::array<uint32_t, NumRegisters> &Registers,
                      uint32_t Pc, std::span<const uint8_t> LocalStore) {
  To.Registers.push_back(Registers);
  To.Pcs.push_back(Pc);
  To.LocalStores.insert(To.LocalStores.end(), LocalStore.begin(),
                        LocalStore.end());
}

State stateOf(const Replay &R, const ChipConfig &Chip, const Memory &Global) {
  const LocalStoreRange Local(Chip.LocalStoreBytes);
  State Result;
  // Before its first cycle a machine has no counts.
  if (R.now().Time != 0)
    addCounts(Result, R.statistics());
  for (uint32_t I = 0; I != R.threadCount(); ++I) {
    const ReplayThread Thread = R.thread(I);
    std::vector<uint8_t> Bytes(Local.Size);
    // Else there is less than in the other state.
    if (!R.read(I, Local.Begin, Bytes))
      Bytes.clear();
    addThread(Result, Thread.Registers, Thread.Pc, Bytes);
  }
  addMemory(Result, Global);
  return Result;
}

State stateOf(const Engine &Machine, const ChipConfig &Chip,
              const Program &Text, const Memory &Global) {
  const LocalStoreRange Local(Chip.LocalStoreBytes);
  State Result;
  if (Machine.cycles() != 0)
    addCounts(Result, Machine.statistics());
  for (uint32_t I = 0; I != Chip.threadCount(); ++I) {
    const Thread &T = Machine.thread(I);
    addThread(
        Result, T.Registers,
        Text.textBegin() + nextTimedWord(Text, Machine.placeOf(I).Word) * 4,
        {reinterpret_cast<const uint8_t *>(T.LocalStoreBias + Local.Begin),
         Local.Size});
  }
  addMemory(Result, Global);
  return Result;
}

State stateOf(const FunctionalMachine &Machine, const ChipConfig &Chip,
              const Memory &Global) {
  const LocalStoreRange Local(Chip.LocalStoreBytes);
  State Result;
  if (Machine.executed() != 0)
    addCounts(Result, Machine.statistics());
  for (const ArchitecturalState &T : Machine.threads())
    addThread(Result, T.Registers, T.Pc, {T.LocalStore, Local.Size});
  addMemory(Result, Global);
  return Result;
}

} // namespace tp::test
