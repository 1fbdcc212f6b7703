//===- EngineImplementation.h - Engine, by resource word --------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_ENGINEIMPLEMENTATION_H
#define TP_SIMULATOR_CORE_ENGINEIMPLEMENTATION_H

#include "simulator/core/CodeGenerator.h"
#include "simulator/core/Engine.h"
#include "simulator/core/ResourceLayout.h"
#include "simulator/core/Thread.h"

#include <memory>

namespace tp {

/// What the public Engine needs of the engine proper, which is compiled once
/// per width of the resource word and float mode.
class EngineImplementation {
public:
  virtual ~EngineImplementation() = default;
  /// Whether the host gave memory for the local stores.
  virtual bool isMapped() const = 0;
  virtual void setHostThreads(unsigned Count) = 0;
  virtual void setObserver(ProfileObserver *Observer) = 0;
  virtual void setOutput(OutputFunction Function) = 0;
  virtual void setIssueObserver(IssueObserver *Observer,
                                const std::vector<bool> &Words) = 0;
  virtual void setCommitObserver(CommitObserver *Observer) = 0;
  virtual void setInitialState(std::span<const ArchitecturalState> States) = 0;
  virtual void setCodeGenerator(std::unique_ptr<CodeGenerator> Generator) = 0;
  virtual void setRecorder(ExecutionRecorder *Recorder) = 0;
  virtual RunResult run(const RunLimits &Limits) = 0;
  virtual uint64_t cycles() const = 0;
  virtual Progress progress() const = 0;
  virtual uint64_t passes(uint32_t Marker) const = 0;
  virtual Statistics statistics() const = 0;
  virtual void serialize(Archive &A) = 0;
  virtual const Thread &thread(uint32_t Number) const = 0;
  virtual ThreadPlace placeOf(uint32_t Number) const = 0;
  virtual uint64_t epoch() const = 0;
  virtual void setRegister(uint32_t Number, unsigned Register,
                           uint32_t Value) = 0;
  virtual void setNextWord(uint32_t Number, uint32_t Word) = 0;
};

using EngineFactory = std::unique_ptr<EngineImplementation> (*)(
    const ChipConfig &Chip, const Program &Text, Memory &Global,
    const ResourceLayout &Layout, std::unique_ptr<MemorySystem> Hierarchy);

/// Makes the engine for resource words of type \p Word; one translation unit
/// each.
template <class Word, bool FlushToZero>
std::unique_ptr<EngineImplementation>
makeEngine(const ChipConfig &Chip, const Program &Text, Memory &Global,
           const ResourceLayout &Layout,
           std::unique_ptr<MemorySystem> Hierarchy);

} // namespace tp

#endif // TP_SIMULATOR_CORE_ENGINEIMPLEMENTATION_H
