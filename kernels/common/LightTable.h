//===- LightTable.h - The lights of a scene and their choice ----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_COMMON_LIGHTTABLE_H
#define TP_KERNELS_COMMON_LIGHTTABLE_H

#include "kernels/common/SceneLayout.h"
#include "scenes/loader/Scene.h"

#include <vector>

namespace tp {

/// Every emissive triangle, and the table that picks them by area.
struct LightTable {
  std::vector<LightRecord> Records;
  /// As many as Records.
  std::vector<LightChoice> Choices;
  /// Of all lights together.
  double TotalArea = 0;
};

LightTable makeLightTable(const Scene &Source);

/// A table in which number i is chosen with probability Weights[i] over the sum
/// of Weights, to within 2^-32. Weights are positive.
std::vector<LightChoice> makeAliasTable(const std::vector<double> &Weights);

} // namespace tp

#endif // TP_KERNELS_COMMON_LIGHTTABLE_H
