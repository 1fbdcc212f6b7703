//===- TPAtomicAccesses.h - Lists atomic loads and stores -------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_TPATOMICACCESSES_H
#define TP_LLVM_BACKEND_TPATOMICACCESSES_H

#include <cstdint>
#include <vector>

namespace llvm {

class MachineInstr;
class MCStreamer;
class MCSymbol;

/// The atomic loads and stores of a unit. They are the same instructions as all
/// others; who looks for data races must tell them apart.
class TPAtomicAccesses {
public:
  /// Notes \p MI, which is to be written next, if it is one.
  void add(const MachineInstr &MI, MCStreamer &Streamer);
  /// Writes all of them into their section (TPELF::AtomicAccessesSection) and
  /// forgets them.
  void emit(MCStreamer &Streamer);

private:
  struct Access {
    const MCSymbol *Address;
    /// TPELF::AtomicAccessFlags.
    uint32_t Flags;
  };
  std::vector<Access> Accesses;
};

} // namespace llvm

#endif // TP_LLVM_BACKEND_TPATOMICACCESSES_H
