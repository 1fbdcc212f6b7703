//===- FrameRecords.h - What the functions need of the stack ----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_LINK_FRAMERECORDS_H
#define TP_LLVM_BACKEND_CLANG_LINK_FRAMERECORDS_H

#include "llvm-backend/clang/link/ElfInput.h"

namespace tp {

/// A record of MCTargetDesc/TPFrameRecord.h.
struct FrameRecord {
  /// Where the function is.
  const InputSection *Section = nullptr;
  uint32_t Offset = 0;
  /// Bytes, or TPFrameRecord::DynamicSize.
  uint32_t FrameBytes = 0;
  uint32_t OwnType = 0;
  uint32_t RegisterCallCount = 0;
  std::vector<uint32_t> CalleeTypes;
};

/// Reads the records of the functions that are in the program. Reports records
/// that are cut off or name no function.
std::vector<FrameRecord>
readFrameRecords(llvm::ArrayRef<std::unique_ptr<ElfObject>> Objects,
                 LinkDiagnostics &Diags);

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_LINK_FRAMERECORDS_H
