//===- Transform.h - Affine transforms of glTF nodes ------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_SCENES_LOADER_TRANSFORM_H
#define TP_SCENES_LOADER_TRANSFORM_H

#include "kernels/common/Vector3.h"

#include <array>

namespace tp {

/// An affine map in double precision: three columns and the translation.
struct Transform {
  using Column = std::array<double, 3>;
  std::array<Column, 4> Columns = {
      {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}};

  /// The map of a direction (the translation left out).
  Column direction(const Column &V) const {
    Column Result{};
    for (int Row = 0; Row != 3; ++Row)
      Result[Row] = Columns[0][Row] * V[0] + Columns[1][Row] * V[1] +
                    Columns[2][Row] * V[2];
    return Result;
  }

  /// The map of a point, rounded once to single precision.
  Vector3 point(Vector3 P) const {
    const Column Mapped = direction({P.X, P.Y, P.Z});
    return {float(Mapped[0] + Columns[3][0]), float(Mapped[1] + Columns[3][1]),
            float(Mapped[2] + Columns[3][2])};
  }

  /// Negative if the map mirrors.
  double determinant() const {
    const auto &[A, B, C, T] = Columns;
    return A[0] * (B[1] * C[2] - B[2] * C[1]) -
           A[1] * (B[0] * C[2] - B[2] * C[0]) +
           A[2] * (B[0] * C[1] - B[1] * C[0]);
  }

  /// This map after \p Inner.
  Transform after(const Transform &Inner) const {
    Transform Result;
    for (int Column = 0; Column != 4; ++Column)
      Result.Columns[Column] = direction(Inner.Columns[Column]);
    for (int Row = 0; Row != 3; ++Row)
      Result.Columns[3][Row] += Columns[3][Row];
    return Result;
  }
};

} // namespace tp

#endif // TP_SCENES_LOADER_TRANSFORM_H
