//===- ExactHits.h - Rays against triangles in double precision -*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The judge between two tests in single precision. Coordinates are floats, so
// that differences are exact and products err by some 2^-53 only.
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_EMBREE_EXACTHITS_H
#define TP_KERNELS_EMBREE_EXACTHITS_H

#include "kernels/bvh/Ray.h"
#include "kernels/common/SceneLayout.h"

namespace tp {

/// How the line of a ray passes a triangle.
struct ExactPassage {
  /// Where it meets the plane, in units of the ray's direction.
  double Distance;
  /// How far it passes from the nearest edge's line, in units of the scene:
  /// positive inside, negative outside.
  double Margin;
};

/// How \p R passes \p Triangle.
ExactPassage passTriangle(const TriangleRecord &Triangle, const Ray &R);

/// The first triangle of all that \p R meets, looking at each.
Hit findExactHit(const SceneView &Scene, const Ray &R);

} // namespace tp

#endif // TP_KERNELS_EMBREE_EXACTHITS_H
