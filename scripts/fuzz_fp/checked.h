//===- checked.h - Arithmetic that notes what is not finite -----*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The fuzzer's functions over Checked<Real> compute in IEEE arithmetic and note
// the range of every operand and result: under finite-math-only an infinity or
// NaN leaves the result undefined.
//
//===----------------------------------------------------------------------===//

#ifndef TP_SCRIPTS_FUZZ_FP_CHECKED_H
#define TP_SCRIPTS_FUZZ_FP_CHECKED_H

#include <math.h>

/// What an evaluation has met. Extreme: so large or small that a product or
/// quotient of a few such values need not be finite in another order.
enum Range { Ordinary = 0, Extreme = 1, NotFinite = 2 };
inline int MetRange = Ordinary;

inline void note(double Value, double Largest) {
  double Magnitude = fabs(Value);
  if (!(Magnitude <= Largest))
    MetRange |= NotFinite;
  else if (Magnitude != 0 && (Magnitude > 1e9 || Magnitude < 1e-9))
    MetRange |= Extreme;
}

template <class Real> class Checked {
  Real Value;

public:
  Checked() = default;
  Checked(float V) : Value(V) {}
  Checked(double V) : Value(Real(V)) {}
  explicit Checked(int V) : Value(Real(V)) {}

  /// The value, which the evaluation depends on.
  Real used() const {
    note(Value, sizeof(Real) == 4 ? 3.402823466e38 : 1.7976931348623157e308);
    return Value;
  }

  explicit operator int() const {
    if (used() != used())
      return 0;
    if (Value >= Real(2147483648.0))
      return 2147483647;
    return Value < Real(-2147483648.0) ? -2147483647 - 1 : int(Value);
  }
  explicit operator float() const {
    return Checked<float>(float(used())).used();
  }
  explicit operator double() const { return used(); }
  Checked operator-() const { return -used(); }

#define CHECKED_OPERATOR(OPERATOR)                                             \
  friend Checked operator OPERATOR(Checked A, Checked B) {                     \
    return A.used() OPERATOR B.used();                                         \
  }                                                                            \
  Checked &operator OPERATOR## = (Checked B) {                                 \
    return *this = *this OPERATOR B;                                           \
  }
  CHECKED_OPERATOR(+)
  CHECKED_OPERATOR(-)
  CHECKED_OPERATOR(*)
  CHECKED_OPERATOR(/)
#undef CHECKED_OPERATOR

#define CHECKED_COMPARISON(OPERATOR)                                           \
  friend bool operator OPERATOR(Checked A, Checked B) {                        \
    return A.used() OPERATOR B.used();                                         \
  }
  CHECKED_COMPARISON(<)
  CHECKED_COMPARISON(>)
  CHECKED_COMPARISON(>=)
  CHECKED_COMPARISON(==)
#undef CHECKED_COMPARISON

#define CHECKED_UNARY(FUNCTION)                                                \
  friend Checked FUNCTION##f(Checked A) { return ::FUNCTION##f(A.used()); }    \
  friend Checked FUNCTION(Checked A) { return ::FUNCTION(A.used()); }
  CHECKED_UNARY(sqrt)
  CHECKED_UNARY(fabs)
  CHECKED_UNARY(floor)
  CHECKED_UNARY(sin)
  CHECKED_UNARY(exp)
  CHECKED_UNARY(log)
#undef CHECKED_UNARY

  friend Checked root(Checked A) { return sqrt(A); }

#define CHECKED_BINARY(FUNCTION)                                               \
  friend Checked FUNCTION##f(Checked A, Checked B) {                           \
    return ::FUNCTION##f(A.used(), B.used());                                  \
  }                                                                            \
  friend Checked FUNCTION(Checked A, Checked B) {                              \
    return ::FUNCTION(A.used(), B.used());                                     \
  }
  CHECKED_BINARY(fmin)
  CHECKED_BINARY(fmax)
  CHECKED_BINARY(pow)
#undef CHECKED_BINARY
};

#endif // TP_SCRIPTS_FUZZ_FP_CHECKED_H
