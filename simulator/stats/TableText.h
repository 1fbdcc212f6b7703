//===- TableText.h - Numbers as the tables show them ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_STATS_TABLETEXT_H
#define TP_SIMULATOR_STATS_TABLETEXT_H

#include "llvm/Support/FormatVariadic.h"

#include <cstdint>
#include <string>

namespace tp {

/// 1234567 as `1,234,567`.
inline std::string grouped(uint64_t Value) {
  return llvm::formatv("{0:N}", Value).str();
}

/// 0.1234 as `12.3 %`. Something that is not nothing never shows as `0.0 %`.
/// Differences of what is under way may be negative.
inline std::string percent(double Share) {
  if (Share != 0 && Share > -0.0005 && Share < 0.0005)
    return "<0.1 %";
  return llvm::formatv("{0:F1} %", Share * 100).str();
}

} // namespace tp

#endif // TP_SIMULATOR_STATS_TABLETEXT_H
