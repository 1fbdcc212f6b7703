//===- Engine.cpp - The cycle model of a chip -----------------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "simulator/core/Engine.h"
#include "simulator/core/EngineImplementation.h"
#include "simulator/core/WindowLog.h"

#include <cassert>

namespace tp {

/// Latencies and windows must be small against the range of ready words.
static constexpr uint32_t MaxLatency = ready::CycleLimit / 8;

static std::string findError(const ChipConfig &Chip, const Program &Text,
                             const Memory &Global,
                             const ResourceLayout &Layout) {
  if (!Global.isMapped())
    return "the host has no room for the chip's global memory";
  if (Global.size() <= kGlobalMemoryBegin ||
      Global.size() > (uint64_t(1) << 32) - Chip.LocalStoreBytes)
    return "global memory does not fit between address 0x10000 and the local "
           "store";
  if (Chip.TpsPerTm > OrderKeyLimit || Chip.TmCount > OrderKeyLimit)
    return "more than 65536 TMs, or TPs per TM";
  if (Chip.ArbitrationWindow == 0 ||
      (!Chip.hasMemorySystem() && Chip.ArbitrationWindow > Chip.MemoryLatency))
    return "the arbitration window is not within 1 and the memory latency";
  if (Chip.ArbitrationWindow > MaxLatency)
    return "the arbitration window is above " + std::to_string(MaxLatency);
  for (uint32_t Latency : Chip.Latency)
    if (Latency == 0 || Latency > MaxLatency)
      return "a latency is not within 1 and " + std::to_string(MaxLatency);
  if (Chip.IcacheMissKind == IcacheMisses::Fixed &&
      (Chip.IcacheMissLatency < Chip.ArbitrationWindow ||
       Chip.IcacheMissLatency > MaxLatency))
    return "the latency of instruction-cache misses is not within the "
           "arbitration window and " +
           std::to_string(MaxLatency);
  if (Chip.IcacheMissKind == IcacheMisses::Memory && !Chip.hasMemorySystem())
    return "instruction-cache misses go to a memory system, which the chip "
           "does not have";
  if (Chip.MemoryLatency > MaxLatency)
    return "the memory latency is above " + std::to_string(MaxLatency);
  if (Layout.bits() > sizeof(WideWord) * 8)
    return "too many unit types and icache banks that TPs can contend for";
  if (Text.entry() % 4 != 0 || Text.entry() < Text.textBegin() ||
      Text.entry() >= Text.textEnd())
    return "the entry point is outside the program's text";
  return {};
}

static EngineFactory chooseEngine(unsigned Bits, bool FlushToZero) {
  if (Bits <= 64)
    return FlushToZero ? makeEngine<uint64_t, true>
                       : makeEngine<uint64_t, false>;
  if (Bits <= 128)
    return FlushToZero ? makeEngine<unsigned __int128, true>
                       : makeEngine<unsigned __int128, false>;
  return FlushToZero ? makeEngine<WideWord, true> : makeEngine<WideWord, false>;
}

Engine::Engine(const ChipConfig &Chip, const Program &Text, Memory &Global,
               std::unique_ptr<MemorySystem> Hierarchy) {
  ResourceLayout Layout(Chip);
  Error = findError(Chip, Text, Global, Layout);
  if (Error.empty() && Chip.hasMemorySystem() != bool(Hierarchy))
    Error = "the chip's caches and DRAM are not those of its memory system";
  if (!Error.empty())
    return;
  EngineFactory Factory = chooseEngine(Layout.bits(), Chip.FlushToZero);
  Implementation = Factory(Chip, Text, Global, Layout, std::move(Hierarchy));
  if (!Implementation->isMapped())
    Error = "the host has no room for the local stores";
}

Engine::~Engine() = default;

void Engine::setHostThreads(unsigned Count) {
  Implementation->setHostThreads(Count);
}

void Engine::setObserver(ProfileObserver *Observer) {
  Implementation->setObserver(Observer);
}

void Engine::setCodeGenerator(std::unique_ptr<CodeGenerator> Generator) {
  Implementation->setCodeGenerator(std::move(Generator));
}

void Engine::setOutput(OutputFunction Function) {
  Implementation->setOutput(std::move(Function));
}

void Engine::setRecorder(ExecutionRecorder &Recorder) {
  Implementation->setRecorder(&Recorder);
}

void Engine::setIssueObserver(IssueObserver *Observer,
                              const std::vector<bool> &Words) {
  Implementation->setIssueObserver(Observer, Words);
}

void Engine::setCommitObserver(CommitObserver *Observer) {
  Implementation->setCommitObserver(Observer);
}

void Engine::setInitialState(std::span<const ArchitecturalState> States) {
  Implementation->setInitialState(States);
}

RunResult Engine::run(const RunLimits &Limits) {
  assert(Error.empty() && "run() of an engine with an error");
  return Implementation->run(Limits);
}

uint64_t Engine::cycles() const { return Implementation->cycles(); }

Progress Engine::progress() const { return Implementation->progress(); }

uint64_t Engine::passes(uint32_t Marker) const {
  return Implementation->passes(Marker);
}

Statistics Engine::statistics() const { return Implementation->statistics(); }

void Engine::serialize(Archive &A) { Implementation->serialize(A); }

uint32_t Engine::registerOf(uint32_t Thread, unsigned Register) const {
  return Implementation->thread(Thread).Registers[Register];
}

const Thread &Engine::thread(uint32_t Number) const {
  return Implementation->thread(Number);
}

ThreadPlace Engine::placeOf(uint32_t Number) const {
  return Implementation->placeOf(Number);
}

uint64_t Engine::epoch() const { return Implementation->epoch(); }

void Engine::setRegister(uint32_t Number, unsigned Register, uint32_t Value) {
  Implementation->setRegister(Number, Register, Value);
}

void Engine::setNextWord(uint32_t Number, uint32_t Word) {
  Implementation->setNextWord(Number, Word);
}

int32_t Engine::statusOf(uint32_t Thread) const {
  return Implementation->thread(Thread).Status;
}

} // namespace tp
