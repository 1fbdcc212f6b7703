//===- TPBaseInfo.h - Facts shared by code generator and MC -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_MCTARGETDESC_TPBASEINFO_H
#define TP_LLVM_BACKEND_MCTARGETDESC_TPBASEINFO_H

#include "llvm/ADT/StringRef.h"
#include <cstdint>

namespace llvm {

namespace TPII {
/// Target flags of a machine operand, and the specifier of an MCSpecifierExpr:
/// which half of the 32-bit value is meant.
enum OperandFlags : unsigned {
  /// The value as it is.
  MO_None,
  /// `%hi(value)`: (value + 0x8000) >> 16, so that adding the sign-extended
  /// `%lo(value)` to it shifted left by 16 gives the value.
  MO_HI,
  /// `%lo(value)`: value & 0xffff, used sign-extended.
  MO_LO
};
} // namespace TPII

namespace TPSpecialRegister {
/// A register that `mfsr` reads; the list is in TPRegisterInfo.td.
struct SpecialRegister {
  uint8_t Encoding;
  const char *Name;
};

// Enumerators are the encodings: TPSpecialRegister::thread is what `mfsr` takes
// for the thread number. The look-ups return null for an unknown register;
// names are compared without regard to case.
#define GET_SpecialRegisters_DECL
#define GET_SpecialRegisterEncoding_DECL
#include "TPGenSearchableTables.inc"
} // namespace TPSpecialRegister

} // namespace llvm

#endif // TP_LLVM_BACKEND_MCTARGETDESC_TPBASEINFO_H
