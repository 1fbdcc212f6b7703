//===- ExactHits.cpp - Rays against triangles in double precision ---------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/embree/ExactHits.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tp {

namespace {

struct Double3 {
  double X, Y, Z;
};

} // namespace

static Double3 toDouble(Vector3 V) { return {V.X, V.Y, V.Z}; }
static Double3 subtract(Double3 A, Double3 B) {
  return {A.X - B.X, A.Y - B.Y, A.Z - B.Z};
}
static Double3 cross(Double3 A, Double3 B) {
  return {A.Y * B.Z - A.Z * B.Y, A.Z * B.X - A.X * B.Z, A.X * B.Y - A.Y * B.X};
}
static double dot(Double3 A, Double3 B) {
  return A.X * B.X + A.Y * B.Y + A.Z * B.Z;
}
static double length(Double3 A) { return std::sqrt(dot(A, A)); }

ExactPassage passTriangle(const TriangleRecord &Triangle, const Ray &R) {
  const Double3 Direction = toDouble(R.Direction);
  Double3 Corners[3];
  for (unsigned Corner = 0; Corner != 3; ++Corner)
    Corners[Corner] =
        subtract(toDouble(Triangle.Corners[Corner]), toDouble(R.Origin));
  const Double3 Normal =
      cross(subtract(Corners[1], Corners[0]), subtract(Corners[2], Corners[0]));
  const double Slope = dot(Normal, Direction);
  ExactPassage Result{dot(Normal, Corners[0]) / Slope,
                      std::numeric_limits<double>::infinity()};
  for (unsigned Corner = 0; Corner != 3; ++Corner) {
    const Double3 From = Corners[Corner], To = Corners[(Corner + 1) % 3];
    // The volume between the two lines, over their common area.
    const double Volume = dot(Direction, cross(From, To));
    const double Area = length(cross(Direction, subtract(To, From)));
    const double Distance = Volume / Area;
    Result.Margin = std::min(Result.Margin, Slope > 0 ? Distance : -Distance);
  }
  return Result;
}

Hit findExactHit(const SceneView &Scene, const Ray &R) {
  Hit Nearest{0, kNoTriangle};
  double Distance = std::numeric_limits<double>::infinity();
  for (uint32_t Number = 0; Number != Scene.Header->TriangleCount; ++Number) {
    const ExactPassage Passage = passTriangle(Scene.Triangles[Number], R);
    if (Passage.Margin >= 0 && Passage.Distance > 0 &&
        Passage.Distance < Distance) {
      Distance = Passage.Distance;
      Nearest.Triangle = Number;
    }
  }
  Nearest.Distance = float(Distance);
  return Nearest;
}

} // namespace tp
