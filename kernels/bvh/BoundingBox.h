//===- BoundingBox.h - Axis-aligned boxes -----------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_BVH_BOUNDINGBOX_H
#define TP_KERNELS_BVH_BOUNDINGBOX_H

#include "kernels/common/FloatMath.h"
#include "kernels/common/SceneLayout.h"
#include "kernels/common/Vector3.h"

namespace tp {

constexpr float component(Vector3 V, unsigned Axis) {
  return Axis == 0 ? V.X : Axis == 1 ? V.Y : V.Z;
}

/// An axis-aligned box. The empty box is upside down, with finite sides so that
/// it needs no infinities (which -ffinite-math-only would break).
struct BoundingBox {
  /// Behind every scene, and so near that RayBoxTester's products with it are
  /// finite too.
  static constexpr float Far = 1.0e20f;
  static_assert(Far > 2 * kMaxCoordinate, "doubled centres are nearer");

  Vector3 Lower = {Far, Far, Far};
  Vector3 Upper = {-Far, -Far, -Far};

  void extend(Vector3 Point) { extend(BoundingBox{Point, Point}); }
  void extend(const BoundingBox &Other) {
    Lower = {minimum(Lower.X, Other.Lower.X), minimum(Lower.Y, Other.Lower.Y),
             minimum(Lower.Z, Other.Lower.Z)};
    Upper = {maximum(Upper.X, Other.Upper.X), maximum(Upper.Y, Other.Upper.Y),
             maximum(Upper.Z, Other.Upper.Z)};
  }
  Vector3 size() const { return Upper - Lower; }
  /// Twice the centre; the factor does not matter to who compares centres.
  Vector3 doubleCenter() const { return Lower + Upper; }
  /// Half the surface area; of a box that is not empty.
  float halfArea() const {
    const Vector3 Size = size();
    return Size.X * Size.Y + Size.Y * Size.Z + Size.Z * Size.X;
  }
};

} // namespace tp

#endif // TP_KERNELS_BVH_BOUNDINGBOX_H
