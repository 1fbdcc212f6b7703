//===- Checks.h - What watches each instruction of a run --------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// FunctionalContext and FunctionalHandlers are templates over the checks that
// they make, so that a run without checks costs nothing and one with checks no
// call. A class of checks derives from ExecutionChecks and has the members of
// NoChecks, which are called in this order:
//
//   before, then those of what the instruction does (load, store, ...), after,
//   branched
//
// `Pc` is the instruction's address, `Host` the host's address of the accessed
// byte. An access that traps is not reported, and `after` not called then. What
// one of them leaves in the Step is there for the later ones of the same
// instruction.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_FUNCTIONAL_CHECKS_H
#define TP_SIMULATOR_FUNCTIONAL_CHECKS_H

#include "simulator/core/Program.h"
#include "simulator/functional/FunctionalThread.h"
#include "simulator/isa/Instructions.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tp {

struct FunctionalSlot;

/// An access to memory that an instruction makes.
struct CheckedAccess {
  FunctionalThread &T;
  uint32_t Pc;
  uint32_t Address;
  uint32_t Bytes;
  const uint8_t *Host;
  bool IsLocal;
  /// Instructions that all threads have executed before.
  uint64_t Number = 0;
};

/// Checks as the machine sees them.
class ExecutionChecks {
public:
  virtual ~ExecutionChecks() = default;

  /// The text with the handlers that make these checks, as decodeFunctional().
  virtual std::vector<FunctionalSlot> decode(const Program &Text,
                                             bool FlushToZero) = 0;
  /// Before the first instruction. What it is given outlives the run.
  virtual void start(const AddressSpace &Space, const ChipConfig &Chip,
                     std::span<const FunctionalThread> Threads) = 0;
  /// All threads at the barrier go on.
  virtual void barrierOpened() {}
};

/// Checks nothing.
struct NoChecks {
  struct Step {};

  static NoChecks of(FunctionalContextState &) { return {}; }

  /// The instruction \p Decoded, whose operands \p Run holds, is to be
  /// executed.
  template <Opcode Op, class Body>
  void before(Step &, FunctionalThread &, uint32_t /*Pc*/, const Instruction &,
              const Body & /*Run*/) {}
  /// It has been executed; its result, if it writes one, is in \p Run and not
  /// yet in the thread's register.
  template <Opcode Op, class Body>
  void after(Step &, FunctionalThread &, uint32_t /*Pc*/, const Instruction &,
             const Body & /*Run*/, bool /*KeepsDestination*/) {}
  /// It was a branch or jump to \p Target.
  template <Opcode Op>
  void branched(FunctionalThread &, uint32_t /*Pc*/, const Instruction &,
                uint32_t /*Target*/) {}
  /// The instruction before \p Pc has written the stack pointer.
  void stackMoved(FunctionalThread &, uint32_t /*Pc*/) {}

  void load(Step &, const CheckedAccess &) {}
  void store(Step &, const CheckedAccess &) {}
  /// A word is read and written.
  void atomic(Step &, const CheckedAccess &) {}
  /// Words of one stream operation; nothing has been stored yet.
  void streamLoad(Step &, const CheckedAccess &) {}
  void streamStore(Step &, const CheckedAccess &) {}
  /// A host call reads [Address, Address + Bytes).
  void output(FunctionalThread &, uint32_t /*Pc*/, uint32_t /*Address*/,
              uint32_t /*Bytes*/) {}
  void sync(FunctionalThread &, uint32_t /*Pc*/) {}
  void barrier(FunctionalThread &, uint32_t /*Pc*/) {}
  /// A profile marker with a value, which may be a message of the runtime's
  /// (tp/check.h).
  void message(FunctionalThread &, uint32_t /*Pc*/, uint32_t /*Marker*/,
               uint32_t /*Value*/) {}
};

} // namespace tp

#endif // TP_SIMULATOR_FUNCTIONAL_CHECKS_H
