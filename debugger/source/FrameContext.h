//===- FrameContext.h - A thread's state at a frame -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_DEBUGGER_SOURCE_FRAMECONTEXT_H
#define TP_DEBUGGER_SOURCE_FRAMECONTEXT_H

#include "llvm/ADT/ArrayRef.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string>

namespace tp {

/// DWARF's numbers of the registers: 0 to 31 are r0 to r31, 32 to 63 are f0 to
/// f31.
inline constexpr unsigned DwarfRegisters = 64;
inline constexpr unsigned DwarfFirstFloat = 32;

/// `r4` or `f4`.
inline std::string registerName(unsigned DwarfNumber) {
  return (DwarfNumber < DwarfFirstFloat ? "r" : "f") +
         std::to_string(DwarfNumber % DwarfFirstFloat);
}

/// Registers as far as they are known.
struct RegisterSet {
  std::array<uint32_t, DwarfRegisters> Values = {};
  /// One bit per register that has a value at all.
  uint64_t Known = ~uint64_t(0);
  /// Of a caller: registers that the functions it called need not have kept.
  /// They hold the caller's values only if the compiler knows that of the call.
  uint64_t Uncertain = 0;

  bool isKnown(unsigned Register) const {
    return (Known & ~Uncertain) >> Register & 1;
  }
  /// Known, or uncertain.
  bool isPresent(unsigned Register) const { return Known >> Register & 1; }
  void set(unsigned Register, uint32_t Value) {
    Values[Register] = Value;
    Known |= uint64_t(1) << Register;
    Uncertain &= ~(uint64_t(1) << Register);
  }
  void forget(unsigned Register) { Known &= ~(uint64_t(1) << Register); }
  void doubt(unsigned Register) { Uncertain |= uint64_t(1) << Register; }
};

/// Memory and registers of one thread. Read and Write return false for what is
/// no memory of that thread.
struct MachineAccess {
  std::function<bool(uint32_t Address, llvm::MutableArrayRef<uint8_t> Bytes)>
      Read;
  /// Empty if nothing can be changed.
  std::function<bool(uint32_t Address, llvm::ArrayRef<uint8_t> Bytes)> Write;
  /// Sets a register of the innermost frame, by DWARF's number; empty if
  /// nothing can be changed.
  std::function<bool(unsigned Register, uint32_t Value)> WriteRegister;
  std::function<bool(uint32_t Pc)> WritePc;
};

/// A frame of a thread: where names and locations are looked up.
struct FrameContext {
  RegisterSet Registers;
  /// The next instruction of the frame: in a caller the return address.
  uint32_t Pc = 0;
  /// True for callers: Pc is behind the call.
  bool IsCaller = false;
  /// Which of the functions that are inlined at the pc this frame is: 0 is the
  /// innermost.
  unsigned InlineDepth = 0;
  /// Where this frame's value of a register stands: an address for those that
  /// frames further in have saved, 0 for those that are in the register.
  std::array<uint32_t, DwarfRegisters> SavedAt = {};
  /// Must outlive the frame.
  const MachineAccess *Machine = nullptr;

  /// An address inside of the instruction that the frame is at.
  uint32_t lookupPc() const { return IsCaller ? Pc - 4 : Pc; }
  bool read(uint32_t Address, llvm::MutableArrayRef<uint8_t> Bytes) const {
    return Machine->Read(Address, Bytes);
  }
};

} // namespace tp

#endif // TP_DEBUGGER_SOURCE_FRAMECONTEXT_H
