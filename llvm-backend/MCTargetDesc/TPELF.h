//===- TPELF.h - ELF numbers of the TP --------------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_MCTARGETDESC_TPELF_H
#define TP_LLVM_BACKEND_MCTARGETDESC_TPELF_H

#include "llvm/ADT/StringRef.h"
#include <cstdint>

namespace llvm {
namespace TPELF {

/// e_machine of TP objects and executables ("TP"; not registered).
inline constexpr uint16_t EM_TP = 0x5450;

/// The address that data which is not loaded (debug data, the section below)
/// gives of code and data that are not in the program.
inline constexpr uint32_t DeadAddress = 0xFFFFFFFF;

/// A section that lists the functions with floating-point checks: of each its
/// address and its size in bytes, one word each.
inline constexpr const char CheckedFunctionsSection[] = ".tp_fp_checked";

/// A section that lists the atomic loads and stores: of each its address in one
/// word, and with it, as its last bits, the flags below. It also lists atomic
/// instructions that have flags.
inline constexpr const char AtomicAccessesSection[] = ".tp_atomics";
enum AtomicAccessFlags : uint32_t {
  /// A load with the order of an acquire operation.
  AcquiresFlag = 1,
  /// Of the word only those bytes are meant that change.
  PartOfWordFlag = 2,
};

/// Types of relocations; see TPRelocations.def for what each one writes.
enum Relocation : uint32_t {
#define TP_RELOC(Name, Value) Name = (Value),
#include "llvm-backend/MCTargetDesc/TPRelocations.def"
};

/// The name of a relocation type, or an empty string if there is none.
inline StringRef getRelocationName(uint32_t Type) {
  switch (Type) {
#define TP_RELOC(Name, Value)                                                  \
  case Value:                                                                  \
    return #Name;
#include "llvm-backend/MCTargetDesc/TPRelocations.def"
  }
  return {};
}

} // namespace TPELF
} // namespace llvm

#endif // TP_LLVM_BACKEND_MCTARGETDESC_TPELF_H
