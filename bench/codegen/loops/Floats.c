//===- Floats.c - Loops over numbers with fractions -----------------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

void saxpy(int Count, float A, const float *X, float *Y) {
  for (int I = 0; I < Count; ++I)
    Y[I] = A * X[I] + Y[I];
}

float dotProduct(const float *X, const float *Y, int Count) {
  float Sum = 0;
  for (int I = 0; I < Count; ++I)
    Sum += X[I] * Y[I];
  return Sum;
}

void multiplyMatrices(const float *A, const float *B, float *Product,
                      int Rows) {
  for (int I = 0; I < Rows; ++I)
    for (int J = 0; J < Rows; ++J) {
      float Sum = 0;
      for (int K = 0; K < Rows; ++K)
        Sum += A[I * Rows + K] * B[K * Rows + J];
      Product[I * Rows + J] = Sum;
    }
}

int mandelbrotSteps(float X, float Y, int Most) {
  float A = 0, B = 0;
  int Steps = 0;
  while (Steps < Most && A * A + B * B <= 4.0f) {
    float Next = A * A - B * B + X;
    B = 2.0f * A * B + Y;
    A = Next;
    ++Steps;
  }
  return Steps;
}
