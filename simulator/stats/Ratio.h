//===- Ratio.h - Division of counts -----------------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SIMULATOR_STATS_RATIO_H
#define TP_SIMULATOR_STATS_RATIO_H

namespace tp {

/// \p Part of \p Whole, where nothing of nothing is 0.
inline double ratio(double Part, double Whole) {
  return Whole == 0 ? 0 : Part / Whole;
}

} // namespace tp

#endif // TP_SIMULATOR_STATS_RATIO_H
