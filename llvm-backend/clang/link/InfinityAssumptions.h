//===- InfinityAssumptions.h - Units that disagree about infinities -*- C++
//-*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_LLVM_BACKEND_CLANG_LINK_INFINITYASSUMPTIONS_H
#define TP_LLVM_BACKEND_CLANG_LINK_INFINITYASSUMPTIONS_H

#include "llvm-backend/FloatingPoint/FloatingPointUnits.h"
#include "llvm-backend/clang/link/LinkDiagnostics.h"
#include "llvm-backend/clang/warnings/WarningOptions.h"
#include "llvm/Support/MemoryBufferRef.h"

#include <optional>

namespace tp {

/// Whether the units of a program that compute with floats were compiled for
/// the same kind of values. The runtime takes no part: it is right for both.
class InfinityAssumptions {
public:
  /// Adds the units that were linked into \p Unit.
  void add(const llvm::Module &Unit);
  /// Adds the units that the object file \p Object was compiled from.
  void add(llvm::MemoryBufferRef Object);

  /// Warns if one unit honours NaN and infinities and another does not.
  void report(const WarningOptions &Warnings, LinkDiagnostics &Diags) const;

private:
  void add(const llvm::SmallVectorImpl<llvm::FloatingPointUnit> &Units);

  std::optional<std::string> FirstFinite, FirstHonouring;
};

} // namespace tp

#endif // TP_LLVM_BACKEND_CLANG_LINK_INFINITYASSUMPTIONS_H
