//===- harness.h - What the fuzzer's programs share -------------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// Programs of scripts/fuzz-fp.sh print one line per function and input:
// function, input, and the bits of the result in each context. Where one
// evaluation of a context differs from the direct call, its bits stand for the
// context.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SCRIPTS_FUZZ_FP_HARNESS_H
#define TP_SCRIPTS_FUZZ_FP_HARNESS_H

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

template <class Real> struct Vector {
  Real x, y, z;
};

// What kernels' vector classes have: expressions behind inline functions.
inline float root(float X) { return sqrtf(X); }
inline double root(double X) { return sqrt(X); }
template <class Real>
inline Vector<Real> operator+(const Vector<Real> &A, const Vector<Real> &B) {
  return {A.x + B.x, A.y + B.y, A.z + B.z};
}
template <class Real>
inline Vector<Real> operator*(const Vector<Real> &A, Real Factor) {
  return {A.x * Factor, A.y * Factor, A.z * Factor};
}
template <class Real>
inline Real dot(const Vector<Real> &A, const Vector<Real> &B) {
  return A.x * B.x + A.y * B.y + A.z * B.z;
}
template <class Real> inline Real length(const Vector<Real> &A) {
  return root(dot(A, A));
}
template <class Real> inline Vector<Real> normalize(const Vector<Real> &A) {
  return A * (Real(1.0f) / length(A));
}
template <class Real> inline Real mix(Real A, Real B, Real Weight) {
  return A * (Real(1.0f) - Weight) + B * Weight;
}

constexpr int MemorySize = 12;

/// What the pointers of a call see; changed by the call.
template <class Real> struct Memory {
  Real Values[MemorySize];
};

template <class Real> struct Input {
  Real a, b, c, d;
  Vector<Real> s;
  Memory<Real> m;
  int n;
};

/// The same value, of which the compiler knows nothing.
template <class T> inline T opaque(T Value) {
  asm volatile("" : "+r"(Value) : : "memory");
  return Value;
}

inline uint64_t bitsOf(float Value) {
  uint32_t Bits;
  memcpy(&Bits, &Value, sizeof(Bits));
  return (Bits & 0x7FFFFFFF) > 0x7F800000 ? 0x7FC00000 : Bits;
}
inline uint64_t bitsOf(double Value) {
  uint64_t Bits;
  memcpy(&Bits, &Value, sizeof(Bits));
  return (Bits & ~(1ULL << 63)) > 0x7FFULL << 52 ? 0x7FF8ULL << 48 : Bits;
}

/// A line of the output. Its functions are not inlined: the compiler's time is
/// for the expressions.
class Line {
  char Text[256];
  char *End = Text;

  void digits(uint64_t Value) {
    int Shift = 60;
    while (Shift != 0 && Value >> Shift == 0)
      Shift -= 4;
    for (; Shift >= 0; Shift -= 4)
      *End++ = "0123456789abcdef"[Value >> Shift & 15];
  }

public:
  [[gnu::noinline]] Line(unsigned Function, unsigned Input) {
    digits(Function);
    word(Input);
  }
  [[gnu::noinline]] ~Line() {
    *End = 0;
    puts(Text);
  }
  void word(uint64_t Value) {
    *End++ = ' ';
    digits(Value);
  }
  template <class Real> [[gnu::noinline]] void value(Real Value) {
    word(bitsOf(Value));
  }

  /// A context with several evaluations, which should all be \p Direct.
  template <class Real>
  [[gnu::noinline]] void values(const Real *Values, int Count, Real Direct) {
    int i = 0;
    while (i != Count - 1 && bitsOf(Values[i]) == bitsOf(Direct))
      ++i;
    value(Values[i]);
  }
};

/// Keeps the compiler from knowing that a value is not used.
template <class Real> inline void use(Real Value) {
  volatile Real Sink = Value;
  (void)Sink;
}

#endif // TP_SCRIPTS_FUZZ_FP_HARNESS_H
