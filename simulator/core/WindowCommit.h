//===- WindowCommit.h - Accesses taking effect at a window's end *- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CORE_WINDOWCOMMIT_H
#define TP_SIMULATOR_CORE_WINDOWCOMMIT_H

#include "simulator/core/AddressSpace.h"
#include "simulator/core/Engine.h"
#include "simulator/core/EngineObservers.h"
#include "simulator/core/WindowLog.h"

#include <optional>
#include <vector>

namespace tp {

/// Lets the accesses of a window take effect in the order of their keys.
class WindowCommit {
public:
  /// \p Space must outlive it.
  explicit WindowCommit(const AddressSpace &Space) : Space(Space) {}

  void setOutput(OutputFunction Function) { Output = std::move(Function); }
  void setObserver(CommitObserver *NewObserver) { Observer = NewObserver; }

  /// Adds the accesses of one log; they must stay where they are until
  /// commit().
  void add(const std::vector<GlobalAccess> &Log);

  /// Does all that was added, and forgets it. \p WindowStart is the cycle from
  /// which the keys count. Of \p FirstTrap and the traps found here the first
  /// is left in \p FirstTrap.
  void commit(uint64_t WindowStart, std::optional<PendingTrap> &FirstTrap);

private:
  struct Entry {
    OrderKey Key;
    const GlobalAccess *Access;
    bool operator<(const Entry &Other) const { return Key < Other.Key; }
  };

  uint32_t load(uint32_t Address) const;
  void store(uint32_t Address, uint32_t Value, unsigned Bytes);
  /// Tells the observer.
  void announce(const GlobalAccess &Access, uint64_t WindowStart,
                uint32_t Address, uint32_t Bytes) const;
  const AddressSpace &Space;
  OutputFunction Output;
  CommitObserver *Observer = nullptr;
  std::vector<Entry> Order;
};

} // namespace tp

#endif // TP_SIMULATOR_CORE_WINDOWCOMMIT_H
