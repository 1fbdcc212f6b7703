//===- CombinedChecks.h - Two kinds of checks in one run --------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_CHECK_COMBINEDCHECKS_H
#define TP_SIMULATOR_CHECK_COMBINEDCHECKS_H

#include "simulator/functional/Checks.h"
#include "simulator/functional/FunctionalText.h"

namespace tp {

/// Tells two classes of checks all that happens, the first one first.
template <class First, class Second>
class CombinedChecks final : public ExecutionChecks {
public:
  struct Step {
    typename First::Step OfFirst;
    typename Second::Step OfSecond;
  };

  /// The arguments must outlive it.
  CombinedChecks(First &One, Second &Other) : One(One), Other(Other) {}

  static CombinedChecks &of(FunctionalContextState &Shared) {
    return static_cast<CombinedChecks &>(*Shared.Checks);
  }

  std::vector<FunctionalSlot> decode(const Program &Text,
                                     bool FlushToZero) override {
    return decodeWithChecks<CombinedChecks>(Text, FlushToZero,
                                            /*WatchesStack=*/true);
  }
  void start(const AddressSpace &Space, const ChipConfig &Chip,
             std::span<const FunctionalThread> Threads) override {
    One.start(Space, Chip, Threads);
    Other.start(Space, Chip, Threads);
  }
  void barrierOpened() override {
    One.barrierOpened();
    Other.barrierOpened();
  }

  template <Opcode Op, class Body>
  void before(Step &S, FunctionalThread &T, uint32_t Pc, const Instruction &I,
              const Body &Run) {
    One.template before<Op>(S.OfFirst, T, Pc, I, Run);
    Other.template before<Op>(S.OfSecond, T, Pc, I, Run);
  }
  template <Opcode Op, class Body>
  void after(Step &S, FunctionalThread &T, uint32_t Pc, const Instruction &I,
             const Body &Run, bool KeepsDestination) {
    One.template after<Op>(S.OfFirst, T, Pc, I, Run, KeepsDestination);
    Other.template after<Op>(S.OfSecond, T, Pc, I, Run, KeepsDestination);
  }
  template <Opcode Op>
  void branched(FunctionalThread &T, uint32_t Pc, const Instruction &I,
                uint32_t Target) {
    One.template branched<Op>(T, Pc, I, Target);
    Other.template branched<Op>(T, Pc, I, Target);
  }
  void stackMoved(FunctionalThread &T, uint32_t Pc) {
    One.stackMoved(T, Pc);
    Other.stackMoved(T, Pc);
  }

  void load(Step &S, const CheckedAccess &A) {
    One.load(S.OfFirst, A);
    Other.load(S.OfSecond, A);
  }
  void store(Step &S, const CheckedAccess &A) {
    One.store(S.OfFirst, A);
    Other.store(S.OfSecond, A);
  }
  void atomic(Step &S, const CheckedAccess &A) {
    One.atomic(S.OfFirst, A);
    Other.atomic(S.OfSecond, A);
  }
  void streamLoad(Step &S, const CheckedAccess &A) {
    One.streamLoad(S.OfFirst, A);
    Other.streamLoad(S.OfSecond, A);
  }
  void streamStore(Step &S, const CheckedAccess &A) {
    One.streamStore(S.OfFirst, A);
    Other.streamStore(S.OfSecond, A);
  }
  void output(FunctionalThread &T, uint32_t Pc, uint32_t Address,
              uint32_t Bytes) {
    One.output(T, Pc, Address, Bytes);
    Other.output(T, Pc, Address, Bytes);
  }
  void sync(FunctionalThread &T, uint32_t Pc) {
    One.sync(T, Pc);
    Other.sync(T, Pc);
  }
  void barrier(FunctionalThread &T, uint32_t Pc) {
    One.barrier(T, Pc);
    Other.barrier(T, Pc);
  }
  void message(FunctionalThread &T, uint32_t Pc, uint32_t Marker,
               uint32_t Value) {
    One.message(T, Pc, Marker, Value);
    Other.message(T, Pc, Marker, Value);
  }

private:
  First &One;
  Second &Other;
};

} // namespace tp

#endif // TP_SIMULATOR_CHECK_COMBINEDCHECKS_H
