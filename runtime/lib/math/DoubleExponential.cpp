//===- DoubleExponential.cpp - Powers and logarithms of doubles -----------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// As in Exponential.cpp, with longer polynomials.
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/math/DoubleParts.h"

using namespace tp;
using namespace tp::soft;

constexpr DoublePair Ln2 = {0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};
constexpr DoublePair Log10Of2 = {0x1.34413509f79ffp-2, -0x1.9dc1da994fd21p-59};
/// ln 2 so that its product with any exponent is exact, and the rest.
constexpr DoublePair Ln2Exact = {0x1.62e42fefa0000p-1, 0x1.cf79abc9e3b3ap-40};

double tp::exponential2(DoublePair X) {
  static const double P[] = {
      0x1.ebfbdff82c58fp-3,  0x1.c6b08d704a0c0p-5,  0x1.3b2ab6fba4e79p-7,
      0x1.5d87fe78a6732p-10, 0x1.430912f86b7dbp-13, 0x1.ffcbfc588a530p-17,
      0x1.62c02242b8805p-20, 0x1.b5253d3f8c723p-24, 0x1.e4cf10de9f224p-28,
      0x1.e8ca978afd7bdp-32, 0x1.c4a29360c3799p-36, 0x1.820b009b57cfap-40};
  double Whole = TP_LIBCALL(rint)(X.High);
  DoublePair Fraction = twoSum(X.High - Whole, X.Low);
  double Rest = Fraction.High;
  DoublePair Linear = twoProduct(Rest, Ln2.High);
  DoublePair Sum = fastTwoSum(1.0, Linear.High);
  double Tail = Rest * Rest * polynomial(Rest, P) +
                (Linear.Low + (Fraction.Low * Ln2.High + Rest * Ln2.Low));
  return TP_LIBCALL(ldexp)(Sum.High + (Sum.Low + Tail),
                           static_cast<int>(Whole));
}

/// \p Magnitude times 2 to the minus \p Exponent, in [sqrt(1/2), sqrt(2)), for
/// a finite number above 0.
static double splitAroundOne(uint64_t Magnitude, int &Exponent) {
  constexpr uint64_t SquareRootOf2 = 0xB504F333F9DE6484u;
  Unpacked U = unpack(Magnitude);
  bool Lower = U.Significand >= SquareRootOf2;
  Exponent = U.Exponent - kBias + Lower;
  return fromBits(pack(0, kBias - Lower, U.Significand));
}

DoublePair tp::logarithm2(uint64_t Magnitude) {
  static const double P[] = {
      0x1.999999999999ap-3, 0x1.2492492492491p-3, 0x1.c71c71c71cfd7p-4,
      0x1.745d17451376fp-4, 0x1.3b13b1bc64de3p-4, 0x1.1110dfb241e74p-4,
      0x1.e1f7f8b3abadap-5, 0x1.ac4ab12489da3p-5, 0x1.b8d2ce6714f8bp-5};
  int Exponent;
  double F = splitAroundOne(Magnitude, Exponent) - 1.0;
  if (F == 0.0)
    return {static_cast<double>(Exponent), 0.0};
  // ln(1 + F) is 2 atanh(S).
  DoublePair S = divide(F, fastTwoSum(2.0, F));
  DoublePair Square = multiply(S, S);
  // The series starts with 1/3.
  DoublePair T = fastTwoSum(0x1.5555555555555p-2,
                            Square.High * polynomial(Square.High, P));
  T.Low += 0x1.5555555555555p-56;
  DoublePair Sum = add(1.0, multiply(Square, T));
  // 2 / ln 2.
  DoublePair L = multiply(multiply(S, Sum), DoublePair{0x1.71547652b82fep+1,
                                                       0x1.777d0ffda0d24p-55});
  return Exponent != 0 ? add(static_cast<double>(Exponent), L) : L;
}

DoublePair tp::logarithm(DoublePair X) {
  return sum(multiply(logarithm2(bits(X.High)), Ln2), X.Low / X.High);
}

namespace {

/// e^X is 2^Whole (1 + High + Low).
struct Exponential {
  int Whole;
  DoublePair Fraction;
};

} // namespace

static Exponential splitExponential(double X) {
  static const double P[] = {
      0x1.0000000000000p-1,  0x1.5555555555557p-3,  0x1.5555555555556p-5,
      0x1.11111111100dfp-7,  0x1.6c16c16c162d6p-10, 0x1.a01a01abe6334p-13,
      0x1.a01a01a6d783ap-16, 0x1.71de023744efap-19, 0x1.27e4db67aa3f0p-22,
      0x1.af4ddda8c10fap-26, 0x1.1f72fc87bcc58p-29};
  double Whole = TP_LIBCALL(rint)(X * 0x1.71547652b82fep+0);
  double High = X - Whole * Ln2Exact.High;
  DoublePair Rest = twoSum(High, -(Whole * Ln2Exact.Low));
  double R = Rest.High;
  return {static_cast<int>(Whole), {R, Rest.Low + R * R * polynomial(R, P)}};
}

double tp::exponential(double X, int Shift) {
  if (isNaN(X))
    return doubleNaN();
  if (X > 2000.0)
    return doubleInfinity();
  if (X < -2000.0)
    return 0.0;
  Exponential E = splitExponential(X);
  DoublePair Sum = fastTwoSum(1.0, E.Fraction.High);
  return TP_LIBCALL(ldexp)(Sum.High + (Sum.Low + E.Fraction.Low),
                           E.Whole + Shift);
}

DoublePair tp::exponentialMinus1(double X) {
  Exponential E = splitExponential(X);
  DoublePair Fraction = fastTwoSum(E.Fraction.High, E.Fraction.Low);
  double Scale = doublePowerOfTwo(E.Whole);
  return sum(twoSum(Scale, -1.0),
             {Fraction.High * Scale, Fraction.Low * Scale});
}

/// Handles what has no finite logarithm; true if that was it.
static bool isSpecialLogarithm(double X, double &Result) {
  uint64_t Magnitude = bits(X) & ~kSign;
  if (Magnitude == 0)
    Result = -doubleInfinity();
  else if (Magnitude > kInfinity || (bits(X) & kSign))
    Result = doubleNaN();
  else if (Magnitude == kInfinity)
    Result = X;
  else
    return false;
  return true;
}

/// 0 if \p Y is no integer, else 1 (even) or 2 (odd).
static int integerKind(double Y) {
  double Magnitude = magnitudeOf(Y);
  if (Magnitude >= 0x1p53)
    return 1;
  uint64_t Whole = static_cast<uint64_t>(Magnitude);
  if (static_cast<double>(Whole) != Magnitude)
    return 0;
  return 1 + (Whole & 1);
}

extern "C" {

double TP_LIBCALL(exp)(double X) { return exponential(X, 0); }

double TP_LIBCALL(exp2)(double X) {
  if (isNaN(X))
    return doubleNaN();
  if (X >= 1024.0)
    return doubleInfinity();
  if (X < -1075.0)
    return 0.0;
  return exponential2({X, 0.0});
}

double TP_LIBCALL(log)(double X) {
  double Special;
  if (isSpecialLogarithm(X, Special))
    return Special;
  return multiply(logarithm2(bits(X)), Ln2).High;
}

double TP_LIBCALL(log2)(double X) {
  double Special;
  if (isSpecialLogarithm(X, Special))
    return Special;
  return logarithm2(bits(X)).High;
}

double TP_LIBCALL(log10)(double X) {
  double Special;
  if (isSpecialLogarithm(X, Special))
    return Special;
  return multiply(logarithm2(bits(X)), Log10Of2).High;
}

double TP_LIBCALL(pow)(double X, double Y) {
  if (Y == 0.0 || X == 1.0)
    return 1.0;
  if (isNaN(X) || isNaN(Y))
    return doubleNaN();
  uint64_t Magnitude = bits(X) & ~kSign;
  bool Negative = (bits(X) & kSign) != 0;
  int Kind = integerKind(Y);
  uint64_t Sign = Negative && Kind == 2 ? kSign : 0;
  if (Magnitude == 0 || Magnitude == kInfinity) {
    bool Zero = (Magnitude == 0) == (Y > 0.0);
    return fromBits(Sign | (Zero ? 0 : kInfinity));
  }
  if (Magnitude == bits(1.0) && magnitudeOf(Y) == doubleInfinity())
    return 1.0;
  if (Negative && Kind == 0)
    return doubleNaN();

  double Result = 1.0;
  if (magnitudeOf(Y) >= 0x1p-70 && Magnitude != bits(1.0)) {
    DoublePair L = logarithm2(Magnitude);
    double Estimate = L.High * Y;
    if (Estimate > 1025.0) {
      Result = doubleInfinity();
    } else if (Estimate < -1077.0) {
      Result = 0.0;
    } else {
      DoublePair Exponent = multiply(L, Y);
      bool Overflow = Exponent.High > 1024.0 ||
                      (Exponent.High == 1024.0 && Exponent.Low >= 0.0);
      Result = Overflow ? doubleInfinity() : exponential2(Exponent);
    }
  }
  return fromBits(Sign | bits(Result));
}

} // extern "C"
