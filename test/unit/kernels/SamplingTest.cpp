//===- SamplingTest.cpp - Densities of directions and points --------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "kernels/common/Sampling.h"

#include <cmath>
#include <gtest/gtest.h>

using namespace tp;

static constexpr uint32_t SampleCount = 200000;

TEST(Sampling, SphereIsUniform) {
  Vector3 Sum;
  double SquareX = 0, SquareY = 0, SquareZ = 0;
  for (uint32_t I = 0; I != SampleCount; ++I) {
    const RandomWords R = randomWords(I, 0, 0, 1);
    const Vector3 P = sampleSphere(R.X, R.Y);
    EXPECT_NEAR(dot(P, P), 1, 1e-5);
    Sum = Sum + P;
    SquareX += P.X * P.X;
    SquareY += P.Y * P.Y;
    SquareZ += P.Z * P.Z;
  }
  EXPECT_NEAR(Sum.X / SampleCount, 0, 0.01);
  EXPECT_NEAR(Sum.Y / SampleCount, 0, 0.01);
  EXPECT_NEAR(Sum.Z / SampleCount, 0, 0.01);
  EXPECT_NEAR(SquareX / SampleCount, 1.0 / 3, 0.005);
  EXPECT_NEAR(SquareY / SampleCount, 1.0 / 3, 0.005);
  EXPECT_NEAR(SquareZ / SampleCount, 1.0 / 3, 0.005);
}

/// With a density of cosine / pi, the mean of the cosine is 2/3, that of its
/// square 1/2, and directions about the normal cancel.
TEST(Sampling, HemisphereFollowsTheCosine) {
  for (const Vector3 Normal :
       {Vector3{0, 0, 1}, Vector3{0, -1, 0}, Vector3{0.6f, 0, -0.8f}}) {
    double Cosines = 0, Squares = 0;
    Vector3 Sum;
    for (uint32_t I = 0; I != SampleCount; ++I) {
      const RandomWords R = randomWords(I, 1, 0, 1);
      const Vector3 D = sampleCosineHemisphere(Normal, R.X, R.Y);
      const float Length = std::sqrt(dot(D, D));
      const float Cosine = dot(D, Normal) / Length;
      ASSERT_GE(Cosine, 0.0f);
      ASSERT_GT(Length, 0.009f);
      ASSERT_LE(Length, 2.001f);
      Cosines += Cosine;
      Squares += Cosine * Cosine;
      Sum = Sum + D * (1 / Length);
    }
    EXPECT_NEAR(Cosines / SampleCount, 2.0 / 3, 0.005);
    EXPECT_NEAR(Squares / SampleCount, 0.5, 0.005);
    const Vector3 Mean = Sum * (1.0f / SampleCount) - Normal * (2.0f / 3);
    EXPECT_LT(std::sqrt(dot(Mean, Mean)), 0.01);
  }
}

TEST(Sampling, TriangleIsUniform) {
  const Vector3 Vertex = {1, 2, 3}, EdgeA = {2, 0, 0}, EdgeB = {0, 1, 0};
  Vector3 Sum;
  uint32_t NearVertex = 0;
  for (uint32_t I = 0; I != SampleCount; ++I) {
    const RandomWords R = randomWords(I, 2, 0, 1);
    const Vector3 P = sampleTriangle(Vertex, EdgeA, EdgeB, R.X, R.Y) - Vertex;
    const float A = P.X / 2, B = P.Y;
    ASSERT_TRUE(A >= 0 && B >= 0 && A + B <= 1.00001f);
    NearVertex += A + B < 0.5f;
    Sum = Sum + P;
  }
  EXPECT_NEAR(Sum.X / SampleCount, 2.0 / 3, 0.01);
  EXPECT_NEAR(Sum.Y / SampleCount, 1.0 / 3, 0.01);
  EXPECT_NEAR(double(NearVertex) / SampleCount, 0.25, 0.01);
}
