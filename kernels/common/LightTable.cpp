//===- LightTable.cpp - The lights of a scene and their choice ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/common/LightTable.h"

#include <algorithm>
#include <cmath>

namespace tp {

std::vector<LightChoice> makeAliasTable(const std::vector<double> &Weights) {
  const uint32_t Count = uint32_t(Weights.size());
  double Sum = 0;
  for (double Weight : Weights)
    Sum += Weight;
  // Shares are 1 on average; each cell gives what a small one lacks to a large
  // one.
  std::vector<double> Share;
  std::vector<uint32_t> Small, Large;
  for (uint32_t Number = 0; Number != Count; ++Number) {
    Share.push_back(Weights[Number] * Count / Sum);
    (Share[Number] < 1 ? Small : Large).push_back(Number);
  }
  std::vector<LightChoice> Table(Count);
  for (uint32_t Number = 0; Number != Count; ++Number)
    Table[Number] = {UINT32_MAX, Number};
  while (!Small.empty() && !Large.empty()) {
    const uint32_t Giver = Large.back();
    const uint32_t Taker = Small.back();
    Small.pop_back();
    Table[Taker] = {uint32_t(std::min(Share[Taker] * 0x1p32, 0x1p32 - 1)),
                    Giver};
    Share[Giver] -= 1 - Share[Taker];
    if (Share[Giver] < 1) {
      Large.pop_back();
      Small.push_back(Giver);
    }
  }
  return Table;
}

LightTable makeLightTable(const Scene &Source) {
  LightTable Table;
  std::vector<double> Areas;
  for (const Triangle &Shape : Source.Triangles) {
    const Material &Surface = Source.Materials[Shape.Material];
    if (!Surface.isEmissive())
      continue;
    LightRecord Record{};
    Record.Vertex = Shape.Vertices[0];
    Record.Edges[0] = Shape.Vertices[1] - Shape.Vertices[0];
    Record.Edges[1] = Shape.Vertices[2] - Shape.Vertices[0];
    const Vector3 Normal = cross(Record.Edges[0], Record.Edges[1]);
    const double Length = std::sqrt(double(dot(Normal, Normal)));
    Record.UnitNormal = {float(Normal.X / Length), float(Normal.Y / Length),
                         float(Normal.Z / Length)};
    Record.Emission = Surface.Emission;
    Table.Records.push_back(Record);
    Areas.push_back(Length / 2);
    Table.TotalArea += Length / 2;
  }
  Table.Choices = makeAliasTable(Areas);
  return Table;
}

} // namespace tp
