//===- TPFixupKinds.h - Places that the assembler fills later ---*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_MCTARGETDESC_TPFIXUPKINDS_H
#define TP_LLVM_BACKEND_MCTARGETDESC_TPFIXUPKINDS_H

#include "llvm/MC/MCFixup.h"

namespace llvm {
namespace TP {

enum Fixups : unsigned {
  /// `%hi(value)` in a 16-bit immediate.
  fixup_tp_hi16 = FirstTargetFixupKind,
  /// `%lo(value)` in a 16-bit immediate.
  fixup_tp_lo16,
  /// A constant known after layout in a signed 16-bit immediate.
  fixup_tp_simm16,
  /// A constant known after layout in an unsigned 16-bit immediate.
  fixup_tp_uimm16,
  /// Target of a branch: words from the branch, 16 bits.
  fixup_tp_pc16,
  /// Target of a jump or call: words from it, 26 bits.
  fixup_tp_pc26,

  fixup_tp_end,
  NumTargetFixupKinds = fixup_tp_end - FirstTargetFixupKind
};

} // namespace TP
} // namespace llvm

#endif // TP_LLVM_BACKEND_MCTARGETDESC_TPFIXUPKINDS_H
