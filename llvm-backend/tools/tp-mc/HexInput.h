//===- HexInput.h - Bytes written as hexadecimal text -----------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_TOOLS_TP_MC_HEXINPUT_H
#define TP_LLVM_BACKEND_TOOLS_TP_MC_HEXINPUT_H

#include "llvm/ADT/StringRef.h"
#include <cstdint>
#include <vector>

namespace llvm {
class SourceMgr;
} // namespace llvm

namespace tp {

/// Bytes and where in the text each one stands.
struct HexBytes {
  std::vector<uint8_t> Values;
  std::vector<const char *> Places;
};

/// Reads bytes of one or two hexadecimal digits, with or without `0x`, apart
/// by blanks, commas or brackets; `#` starts a comment. Reports what is none
/// through `Sources` and returns false.
bool parseHexBytes(llvm::StringRef Text, const llvm::SourceMgr &Sources,
                   HexBytes &Bytes);

} // namespace tp

#endif // TP_LLVM_BACKEND_TOOLS_TP_MC_HEXINPUT_H
