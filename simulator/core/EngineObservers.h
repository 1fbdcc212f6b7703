//===- EngineObservers.h - Who watches an engine ----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_ENGINEOBSERVERS_H
#define TP_SIMULATOR_CORE_ENGINEOBSERVERS_H

#include <cstdint>
#include <span>

namespace tp {

struct Thread;
struct TmRunnerState;

/// Sees chosen instructions before they are issued; those of different threads
/// possibly at once.
class IssueObserver {
public:
  virtual ~IssueObserver() = default;
  /// \p T issues \p Word in \p Cycle, and has not executed it yet.
  virtual void issuing(const Thread &T, uint32_t Word, uint64_t Cycle,
                       const TmRunnerState &Runner) = 0;
  /// What the last issuing() of \p T said was not so: the instruction must wait
  /// for memory, and will be seen again.
  virtual void postponed(const Thread &T) = 0;
};

/// Memory as \p T would load it while it runs: its own stores and, of the
/// others, those of earlier windows. Words that it has changed in this window
/// by atomics are as before. False for what is no memory.
bool readAsThread(const Thread &T, const TmRunnerState &Runner,
                  uint32_t Address, std::span<uint8_t> Bytes);

/// A write to global memory.
struct GlobalWrite {
  uint64_t Cycle = 0;
  uint32_t Thread = 0;
  uint32_t Pc = 0;
  uint32_t Address = 0;
  uint32_t Bytes = 0;
};

/// Sees all writes of the program to global memory, in the order in which they
/// take effect.
class CommitObserver {
public:
  virtual ~CommitObserver() = default;
  /// Before the memory changes.
  virtual void writing(const GlobalWrite &Write) = 0;
};

} // namespace tp

#endif // TP_SIMULATOR_CORE_ENGINEOBSERVERS_H
