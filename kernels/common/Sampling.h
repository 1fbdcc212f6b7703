//===- Sampling.h - Random directions and points ----------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#ifndef TP_KERNELS_COMMON_SAMPLING_H
#define TP_KERNELS_COMMON_SAMPLING_H

#include "kernels/common/FloatMath.h"
#include "kernels/common/Random.h"
#include "kernels/common/Vector3.h"

namespace tp {

/// A point on the unit sphere, uniform by area.
inline Vector3 sampleSphere(uint32_t WordA, uint32_t WordB) {
  const float Height = 1.0f - 2.0f * unitFloat(WordA);
  const float Radius = sqrt(maximum(1.0f - Height * Height, 0.0f));
  const float Angle = unitFloat(WordB) * (2.0f * kPi);
  return {Radius * fastCos(Angle), Radius * fastSin(Angle), Height};
}

/// A direction in the hemisphere about \p UnitNormal with a density in
/// proportion to the cosine of the angle between them: a point of the unit
/// sphere that touches the surface, seen from the point of contact. Its length
/// is between 0.01 and 2.
inline Vector3 sampleCosineHemisphere(Vector3 UnitNormal, uint32_t WordA,
                                      uint32_t WordB) {
  const Vector3 Direction = UnitNormal + sampleSphere(WordA, WordB);
  // Rounding decides directions close to the point of contact.
  return dot(Direction, Direction) > 1e-4f ? Direction : UnitNormal;
}

/// A point of the triangle with corner \p Vertex and edges \p EdgeA and \p
/// EdgeB from it, uniform by area.
inline Vector3 sampleTriangle(Vector3 Vertex, Vector3 EdgeA, Vector3 EdgeB,
                              uint32_t WordA, uint32_t WordB) {
  float A = unitFloat(WordA);
  float B = unitFloat(WordB);
  // The other half of the parallelogram, turned onto the triangle.
  if (A + B > 1.0f) {
    A = 1.0f - A;
    B = 1.0f - B;
  }
  return Vertex + EdgeA * A + EdgeB * B;
}

} // namespace tp

#endif // TP_KERNELS_COMMON_SAMPLING_H
