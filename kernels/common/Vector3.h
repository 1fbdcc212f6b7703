//===- Vector3.h - Three floats ---------------------------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Compiles for the TP and for the host. Every operation is single-precision and
// its order is fixed by the expression, so that both make the same bits.
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_COMMON_VECTOR3_H
#define TP_KERNELS_COMMON_VECTOR3_H

namespace tp {

/// A point, a direction or a linear RGB colour.
struct Vector3 {
  float X = 0;
  float Y = 0;
  float Z = 0;
};

static_assert(sizeof(Vector3) == 3 * sizeof(float));

constexpr Vector3 operator+(Vector3 A, Vector3 B) {
  return {A.X + B.X, A.Y + B.Y, A.Z + B.Z};
}
constexpr Vector3 operator-(Vector3 A, Vector3 B) {
  return {A.X - B.X, A.Y - B.Y, A.Z - B.Z};
}
constexpr Vector3 operator-(Vector3 A) { return {-A.X, -A.Y, -A.Z}; }
/// Component by component, for colours.
constexpr Vector3 operator*(Vector3 A, Vector3 B) {
  return {A.X * B.X, A.Y * B.Y, A.Z * B.Z};
}
constexpr Vector3 operator*(Vector3 A, float Factor) {
  return {A.X * Factor, A.Y * Factor, A.Z * Factor};
}

constexpr float dot(Vector3 A, Vector3 B) {
  return A.X * B.X + A.Y * B.Y + A.Z * B.Z;
}
constexpr Vector3 cross(Vector3 A, Vector3 B) {
  return {A.Y * B.Z - A.Z * B.Y, A.Z * B.X - A.X * B.Z, A.X * B.Y - A.Y * B.X};
}

} // namespace tp

#endif // TP_KERNELS_COMMON_VECTOR3_H
