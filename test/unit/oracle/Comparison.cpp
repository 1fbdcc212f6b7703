//===- Comparison.cpp - A program on an engine and in the model -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "test/unit/oracle/Comparison.h"
#include "test/unit/oracle/ScoreboardModel.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <sstream>

namespace tp::test {

namespace {

class Recorder final : public ProfileObserver {
public:
  explicit Recorder(RunRecord &Record) : Record(Record) {}
  void profileValue(uint32_t Thread, uint32_t Marker, uint32_t Value) override {
    Record.ProfileValues[Thread].push_back({Marker, Value});
  }

private:
  RunRecord &Record;
};

/// Collects what differs.
class Differences {
public:
  template <class T>
  void compare(const std::string &What, const T &Model, const T &Simulated) {
    if (Model != Simulated)
      Text << What << ": model " << Model << ", engine " << Simulated << '\n';
  }
  void compare(const std::string &What, const LossCounts &Model,
               const LossCounts &Simulated) {
    for (unsigned I = 0; I != NumLosses; ++I)
      compare(What + " loss " + std::to_string(I), Model[I], Simulated[I]);
  }
  std::string text() const { return Text.str(); }

private:
  std::ostringstream Text;
};

std::string describe(const RunResult &Result) {
  std::ostringstream Text;
  Text << "end " << Result.End << " status " << Result.ExitStatus;
  if (const std::optional<Trap> &T = Result.TrapInfo)
    Text << " trap " << T->what() << " of thread " << T->Thread << " at "
         << std::hex << T->Pc << std::dec << " in cycle " << T->Cycle;
  return Text.str();
}

std::string describe(const std::vector<uint64_t> &Markers) {
  std::ostringstream Text;
  for (uint64_t Count : Markers)
    Text << Count << ' ';
  return Text.str();
}

std::string
describe(const std::vector<std::pair<uint32_t, uint32_t>> &ProfileValues) {
  std::ostringstream Text;
  for (auto [Marker, Value] : ProfileValues)
    Text << Marker << ':' << Value << ' ';
  return Text.str();
}

void compareByOpcode(Differences &D, const std::string &What,
                     const std::array<uint64_t, NumOpcodes> &Model,
                     const std::array<uint64_t, NumOpcodes> &Simulated) {
  for (unsigned I = 0; I != NumOpcodes; ++I)
    D.compare(What + ' ' + std::string(mnemonic(Opcode(I))), Model[I],
              Simulated[I]);
}

void compareCounts(Differences &D, const Statistics &Model,
                   const Statistics &Simulated) {
  D.compare("cycles", Model.Cycles, Simulated.Cycles);
  compareByOpcode(D, "executed", Model.Executed, Simulated.Executed);
  compareByOpcode(D, "data stall of", Model.DataStall, Simulated.DataStall);
  compareByOpcode(D, "unit conflicts of", Model.UnitConflict,
                  Simulated.UnitConflict);
  D.compare("markers", describe(Model.Markers), describe(Simulated.Markers));
  D.compare("global accesses", Model.GlobalAccesses, Simulated.GlobalAccesses);
  for (size_t I = 0; I != Model.Threads.size(); ++I) {
    std::string Name = "thread " + std::to_string(I);
    const ThreadStatistics &M = Model.Threads[I], &S = Simulated.Threads[I];
    D.compare(Name + " instructions", M.Instructions, S.Instructions);
    D.compare(Name + " finish", M.FinishCycle, S.FinishCycle);
    D.compare(Name, M.Lost, S.Lost);
  }
  D.compare("words of the text", Model.Pcs.size(), Simulated.Pcs.size());
  for (size_t I = 0; I != std::min(Model.Pcs.size(), Simulated.Pcs.size());
       ++I) {
    std::string Name = "word " + std::to_string(I);
    D.compare(Name + " executed", Model.Pcs[I].Executed,
              Simulated.Pcs[I].Executed);
    D.compare(Name, Model.Pcs[I].Lost, Simulated.Pcs[I].Lost);
  }
}

void compareCache(Differences &D, const std::string &Name,
                  const std::optional<CacheStatistics> &Model,
                  const std::optional<CacheStatistics> &Simulated) {
  D.compare(Name + " present", Model.has_value(), Simulated.has_value());
  if (!Model || !Simulated)
    return;
  D.compare(Name + " loads", Model->Loads, Simulated->Loads);
  D.compare(Name + " stores", Model->Stores, Simulated->Stores);
  D.compare(Name + " atomics", Model->Atomics, Simulated->Atomics);
  D.compare(Name + " hits", Model->Hits, Simulated->Hits);
  D.compare(Name + " misses", Model->Misses, Simulated->Misses);
  D.compare(Name + " merged", Model->Merged, Simulated->Merged);
  D.compare(Name + " bank conflict cycles", Model->BankConflictCycles,
            Simulated->BankConflictCycles);
  D.compare(Name + " miss register waits", Model->MissRegisterWaitCycles,
            Simulated->MissRegisterWaitCycles);
  D.compare(Name + " bytes read", Model->BytesRead, Simulated->BytesRead);
}

void compareMemory(Differences &D, const std::optional<MemoryStatistics> &Model,
                   const std::optional<MemoryStatistics> &Simulated) {
  D.compare("memory system", Model.has_value(), Simulated.has_value());
  if (!Model || !Simulated)
    return;
  compareCache(D, "L1", Model->L1, Simulated->L1);
  compareCache(D, "L2", Model->L2, Simulated->L2);
  for (size_t I = 0; I != Model->DramChannels.size(); ++I) {
    std::string Name = "channel " + std::to_string(I);
    const DramChannelStatistics &M = Model->DramChannels[I];
    const DramChannelStatistics &S = Simulated->DramChannels[I];
    D.compare(Name + " reads", M.Reads, S.Reads);
    D.compare(Name + " writes", M.Writes, S.Writes);
    D.compare(Name + " row hits", M.RowHits, S.RowHits);
    D.compare(Name + " row conflicts", M.RowConflicts, S.RowConflicts);
    D.compare(Name + " busy ticks", M.BusBusyTicks, S.BusBusyTicks);
  }
}

std::vector<uint8_t> contents(const Memory &Global) {
  return {Global.data() + kGlobalMemoryBegin, Global.data() + Global.size()};
}

} // namespace

RunRecord runModel(const ChipConfig &Chip, const RandomProgram &Source,
                   uint64_t MaxCycles) {
  Memory Global(Chip.MemoryBytes);
  Source.initialize(Global);
  Program Text = Source.text();
  ScoreboardModel Model(Chip, Text, Global);
  RunRecord Record;
  Record.Result = Model.run(MaxCycles);
  Record.Counts = Model.statistics();
  for (uint32_t I = 0; I != Chip.threadCount(); ++I) {
    const ModelThread &T = Model.thread(I);
    std::array<uint32_t, 64> &Registers = Record.Registers.emplace_back();
    for (unsigned R = 0; R != Registers.size(); ++R)
      Registers[R] = T.Registers[R].Value;
    Record.ProfileValues.push_back(T.ProfileValues);
  }
  Record.Memory = contents(Global);
  Record.Output = Model.output();
  return Record;
}

RunRecord runEngine(const ChipConfig &Chip, const RandomProgram &Source,
                    uint64_t MaxCycles, const EngineRun &Run) {
  Memory Global(Chip.MemoryBytes);
  Source.initialize(Global);
  Program Text = Source.text();
  RunRecord Record;
  Record.ProfileValues.resize(Chip.threadCount());
  Recorder Observer(Record);
  Engine Simulated(Chip, Text, Global, makeMemorySystem(Chip));
  if (!Simulated.error().empty()) {
    std::fprintf(stderr, "the engine refuses the chip: %s\n",
                 Simulated.error().c_str());
    std::abort();
  }
  Simulated.setObserver(&Observer);
  Simulated.setOutput(
      [&](int, std::string_view Bytes) { Record.Output += Bytes; });
  Record.Result = Run(Simulated, MaxCycles);
  Record.Counts = Simulated.statistics();
  for (uint32_t I = 0; I != Chip.threadCount(); ++I) {
    std::array<uint32_t, 64> &Registers = Record.Registers.emplace_back();
    for (unsigned R = 0; R != Registers.size(); ++R)
      Registers[R] = Simulated.registerOf(I, R);
  }
  Record.Memory = contents(Global);
  return Record;
}

std::string differences(const RunRecord &Model, const RunRecord &Simulated) {
  Differences D;
  D.compare("run", describe(Model.Result), describe(Simulated.Result));
  compareCounts(D, Model.Counts, Simulated.Counts);
  compareMemory(D, Model.Counts.Memory, Simulated.Counts.Memory);
  for (size_t I = 0; I != Model.Registers.size(); ++I) {
    std::string Name = "thread " + std::to_string(I);
    for (unsigned R = 0; R != Model.Registers[I].size(); ++R)
      D.compare(Name + " register " + std::to_string(R), Model.Registers[I][R],
                Simulated.Registers[I][R]);
    D.compare(Name + " profile values", describe(Model.ProfileValues[I]),
              describe(Simulated.ProfileValues[I]));
  }
  D.compare("output", Model.Output, Simulated.Output);
  if (Model.Memory != Simulated.Memory) {
    auto [M, S] = std::ranges::mismatch(Model.Memory, Simulated.Memory);
    size_t Address = kGlobalMemoryBegin + size_t(M - Model.Memory.begin());
    D.compare("byte " + std::to_string(Address), unsigned(*M), unsigned(*S));
  }
  return D.text();
}

} // namespace tp::test
