// <cmath>: every function with its overloads, on the chip as on the host, to as
// many digits as both are right in. The last digits are the unit tests' part.
// RUN: %host_cxx -w -std=c++20 -O1 -ffp-contract=off %s -o %t.host
// RUN: %t.host > %t.expected
// RUN: tpcc -O2 %s -o %t.elf && tpsim --chip 1x1 --quiet %t.elf > %t.out
// RUN: diff %t.expected %t.out
// RUN: tpcc -O0 %s -o %t0.elf && tpsim --chip 1x1 --quiet %t0.elf > %t0.out
// RUN: diff %t.expected %t0.out

#include <cmath>
#include <complex>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <type_traits>

// The fourteen digits of a double that both compute, the six of a float; zeros
// keep their sign.
static void put(double X) {
  if (std::isnan(X))
    std::printf(" nan");
  else
    std::printf(" %.14g", X);
}
static void put(float X) {
  if (std::isnan(X))
    std::printf(" nan");
  else
    std::printf(" %.6g", static_cast<double>(X));
}

#define PUT_UNARY(Name)                                                        \
  std::printf("\n" #Name);                                                     \
  put(std::Name(X));                                                           \
  put(std::Name(F));                                                           \
  put(static_cast<double>(std::Name(static_cast<long double>(X))));            \
  put(std::Name(I));                                                           \
  static_assert(std::is_same_v<decltype(std::Name(F)), float>);                \
  static_assert(std::is_same_v<decltype(std::Name(I)), double>)

#define PUT_BINARY(Name)                                                       \
  std::printf("\n" #Name);                                                     \
  put(std::Name(X, Y));                                                        \
  put(std::Name(F, G));                                                        \
  put(std::Name(F, Y));                                                        \
  put(std::Name(I, Y));                                                        \
  static_assert(std::is_same_v<decltype(std::Name(F, Y)), double>)

static void putUnary(double X) {
  volatile double VX = X;
  X = VX;
  float F = static_cast<float>(X);
  int I = std::fabs(X) < 1e6 ? static_cast<int>(X) : 3;
  std::printf("\n--- %.9g", X);
  PUT_UNARY(acos);
  PUT_UNARY(acosh);
  PUT_UNARY(asin);
  PUT_UNARY(asinh);
  PUT_UNARY(atan);
  PUT_UNARY(atanh);
  PUT_UNARY(cbrt);
  PUT_UNARY(ceil);
  PUT_UNARY(cos);
  PUT_UNARY(cosh);
  PUT_UNARY(erf);
  PUT_UNARY(erfc);
  PUT_UNARY(exp);
  PUT_UNARY(exp2);
  PUT_UNARY(expm1);
  PUT_UNARY(fabs);
  PUT_UNARY(floor);
  PUT_UNARY(lgamma);
  PUT_UNARY(log);
  PUT_UNARY(log10);
  PUT_UNARY(log1p);
  PUT_UNARY(log2);
  PUT_UNARY(logb);
  PUT_UNARY(nearbyint);
  PUT_UNARY(rint);
  PUT_UNARY(round);
  PUT_UNARY(sin);
  PUT_UNARY(sinh);
  PUT_UNARY(sqrt);
  PUT_UNARY(tan);
  PUT_UNARY(tanh);
  PUT_UNARY(tgamma);
  PUT_UNARY(trunc);
  int Exponent = 0;
  double Whole;
  std::printf("\nparts");
  put(std::frexp(X, &Exponent));
  put(std::modf(X, &Whole));
  put(Whole);
  put(std::ldexp(F, 5));
  put(std::scalbn(X, -3));
  put(std::scalbln(F, 2));
  std::printf(" %d %d%d%d%d%d %d", std::isfinite(X) ? Exponent : 0,
              std::isfinite(F), std::isinf(X), std::isnan(X), std::isnormal(X),
              std::signbit(F), std::fpclassify(X) == FP_ZERO);
  if (std::fabs(X) < 1e9)
    std::printf(" %d %d %lld %lld %d", static_cast<int>(std::lrint(X)),
                static_cast<int>(std::lround(F)), std::llrint(F),
                std::llround(X), X == 0 ? 0 : std::ilogb(X));
}

static void putBinary(double X, double Y) {
  volatile double VX = X, VY = Y;
  X = VX;
  Y = VY;
  float F = static_cast<float>(X), G = static_cast<float>(Y);
  int I = static_cast<int>(X);
  std::printf("\n--- %.9g %.9g", X, Y);
  PUT_BINARY(atan2);
  PUT_BINARY(copysign);
  PUT_BINARY(fdim);
  PUT_BINARY(fmax);
  PUT_BINARY(fmin);
  PUT_BINARY(fmod);
  PUT_BINARY(hypot);
  PUT_BINARY(pow);
  PUT_BINARY(remainder);
  PUT_BINARY(nextafter);
  int Quotient = 0;
  std::printf("\nothers");
  put(std::remquo(X, Y, &Quotient));
  std::printf(" %d", std::abs(Quotient) & 7);
  put(std::fma(X, Y, 1.5));
  put(std::fma(F, G, 1.5f));
  put(std::hypot(X, Y, 2.0));
  put(std::nexttoward(F, static_cast<long double>(Y)));
  put(std::lerp(X, Y, 0.25));
  std::printf(" %d%d%d%d%d", std::isgreater(X, Y), std::isless(F, Y),
              std::islessgreater(X, Y), std::isunordered(X, Y),
              std::isgreaterequal(F, G));
}

int main() {
  const double Infinity = std::numeric_limits<double>::infinity();
  for (double X : {-0.0, 0.3, 1.0, -2.5, 20.25, 1e10, Infinity, std::nan("")})
    putUnary(X);
  for (double X : {0.0, -3.25, 1000.0})
    for (double Y : {-0.3, 2.5})
      putBinary(X, Y);
  std::printf("\nabs %d %lld", std::abs(-3), std::abs(-4'000'000'000ll));
  put(std::abs(-2.5));
  put(std::abs(-2.5f));
  std::complex<double> Z(1, 2);
  Z = std::exp(Z) * std::sqrt(Z) / std::complex<double>(0.5, -1);
  std::printf("\ncomplex");
  put(Z.real());
  put(Z.imag());
  put(std::abs(Z));
  put(std::arg(Z));
  std::complex<float> W = std::polar(2.0f, 0.5f);
  W = std::pow(W, 3) + std::log(W);
  put(W.real());
  put(W.imag());
  std::printf("\n");
}
