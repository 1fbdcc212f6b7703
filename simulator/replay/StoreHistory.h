//===- StoreHistory.h - Tells a history each functional store ---*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_REPLAY_STOREHISTORY_H
#define TP_SIMULATOR_REPLAY_STOREHISTORY_H

#include "simulator/functional/Checks.h"
#include "simulator/replay/GlobalHistory.h"

namespace tp {

/// Tells \p History each write of a functional machine to global memory; its
/// time is the number of the instruction.
class StoreHistory final : public ExecutionChecks, public NoChecks {
public:
  /// \p History must outlive it.
  explicit StoreHistory(GlobalHistory &History) : History(History) {}

  static StoreHistory &of(FunctionalContextState &Shared) {
    return static_cast<StoreHistory &>(*Shared.Checks);
  }

  std::vector<FunctionalSlot> decode(const Program &Text,
                                     bool FlushToZero) override;
  void start(const AddressSpace &, const ChipConfig &,
             std::span<const FunctionalThread>) override {}

  void store(Step &, const CheckedAccess &A) { tell(A); }
  void atomic(Step &, const CheckedAccess &A) { tell(A); }
  void streamStore(Step &, const CheckedAccess &A) { tell(A); }

private:
  void tell(const CheckedAccess &A) {
    if (!A.IsLocal)
      History.writing({A.Number, A.T.Number, A.Pc, A.Address, A.Bytes});
  }

  GlobalHistory &History;
};

} // namespace tp

#endif // TP_SIMULATOR_REPLAY_STOREHISTORY_H
