//===- LibcDouble.cpp - The C library's exact functions of doubles --------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//

#include "runtime/lib/builtins/DoubleFormat.h"
#include "runtime/lib/builtins/Libcall.h"

using namespace tp::soft;

namespace {

enum class Direction { Zero, Down, Up, NearestEven, NearestAway };

} // namespace

/// The whole number beside \p X in \p To's direction.
static double roundWhole(double X, Direction To) {
  uint64_t Bits = bits(X);
  uint64_t Magnitude = Bits & ~kSign;
  uint64_t Sign = Bits & kSign;
  if (Magnitude > kInfinity)
    return fromBits(kNaN);
  int Exponent = static_cast<int>(Magnitude >> 52) - kBias;
  if (Exponent >= 52 || Magnitude == 0)
    return X;
  // One is the weight of the last whole bit; Lost is what lies below it.
  uint64_t One = Exponent < 0 ? 0 : uint64_t(1) << (52 - Exponent);
  uint64_t Whole = Exponent < 0 ? 0 : Magnitude & ~(One - 1);
  uint64_t Lost = Exponent < 0 ? Magnitude : Magnitude & (One - 1);
  if (Lost == 0)
    return X;
  uint64_t Half = Exponent < 0 ? uint64_t(kBias - 1) << 52 : One >> 1;
  bool Odd = Exponent == 0 || (Exponent > 0 && (Whole & One) != 0);
  bool Away = false;
  switch (To) {
  case Direction::Zero:
    break;
  case Direction::Down:
    Away = Sign != 0;
    break;
  case Direction::Up:
    Away = Sign == 0;
    break;
  case Direction::NearestEven:
    Away = Lost > Half || (Lost == Half && Odd);
    break;
  case Direction::NearestAway:
    Away = Lost >= Half;
    break;
  }
  if (Exponent < 0)
    return fromBits(Sign | (Away ? uint64_t(kBias) << 52 : 0));
  return fromBits(Sign | (Whole + (Away ? One : 0)));
}

static double scaleBy(double X, int Exponent) {
  uint64_t Magnitude = bits(X) & ~kSign;
  if (Magnitude > kInfinity)
    return fromBits(kNaN);
  if (Magnitude == 0 || Magnitude == kInfinity)
    return X;
  Unpacked U = unpack(Magnitude);
  // Beyond these every number overflows or vanishes.
  if (Exponent > 5000)
    Exponent = 5000;
  if (Exponent < -5000)
    Exponent = -5000;
  return fromBits(pack(bits(X) & kSign, U.Exponent + Exponent, U.Significand));
}

namespace {

/// What division by subtraction leaves, and how often it subtracted, modulo
/// 2^32.
struct Division {
  double Rest;
  uint32_t Quotient;
};

} // namespace

/// Of magnitudes of finite numbers, the divisor not 0.
static Division divideMagnitudes(uint64_t Dividend, uint64_t Divisor) {
  if (Dividend < Divisor)
    return {fromBits(Dividend), 0};
  Unpacked UX = unpack(Dividend);
  Unpacked UY = unpack(Divisor);
  uint64_t Rest = UX.Significand >> 11;
  uint64_t Unit = UY.Significand >> 11;
  uint32_t Quotient = 0;
  int Shift = UX.Exponent - UY.Exponent;
  for (;;) {
    if (Rest >= Unit) {
      Rest -= Unit;
      Quotient |= 1;
    }
    if (Shift == 0 || Rest == 0)
      break;
    Rest <<= 1;
    Quotient <<= 1;
    --Shift;
  }
  Quotient = Shift < 32 ? Quotient << Shift : 0;
  if (Rest == 0)
    return {0.0, Quotient};
  int Lift = tp::wide::leadingZeros(Rest);
  return {fromBits(pack(0, UY.Exponent + 11 - Lift, Rest << Lift)), Quotient};
}

static bool isDivisible(double X, double Y) {
  uint64_t Divisor = bits(Y) & ~kSign;
  return (bits(X) & ~kSign) < kInfinity && Divisor <= kInfinity && Divisor != 0;
}

static double modulo(double X, double Y) {
  if (!isDivisible(X, Y))
    return fromBits(kNaN);
  Division D = divideMagnitudes(bits(X) & ~kSign, bits(Y) & ~kSign);
  return fromBits((bits(X) & kSign) | bits(D.Rest));
}

/// As modulo, from the nearest multiple, the even one if there are two; the
/// quotient's lower bits have its sign.
static double nearestRemainder(double X, double Y, int &Quotient) {
  Quotient = 0;
  if (!isDivisible(X, Y))
    return fromBits(kNaN);
  uint64_t Magnitude = bits(Y) & ~kSign;
  Division D = divideMagnitudes(bits(X) & ~kSign, Magnitude);
  double Beyond = fromBits(Magnitude) - D.Rest;
  if (D.Rest > Beyond || (D.Rest == Beyond && (D.Quotient & 1))) {
    D.Rest = fromBits(bits(Beyond) | kSign);
    ++D.Quotient;
  }
  int Lower = static_cast<int>(D.Quotient & 0x7FFFFFFF);
  Quotient = (bits(X) ^ bits(Y)) & kSign ? -Lower : Lower;
  return fromBits(bits(D.Rest) ^ (bits(X) & kSign));
}

/// The smaller of the two in the order -0 < +0, NaN losing.
static double smaller(double A, double B) {
  if ((bits(A) & ~kSign) > kInfinity)
    return (bits(B) & ~kSign) > kInfinity ? fromBits(kNaN) : B;
  if ((bits(B) & ~kSign) > kInfinity)
    return A;
  bool NegativeA = (bits(A) & kSign) != 0;
  bool NegativeB = (bits(B) & kSign) != 0;
  if (NegativeA != NegativeB)
    return NegativeA ? A : B;
  return (bits(A) < bits(B)) != NegativeA ? A : B;
}

extern "C" {

double TP_LIBCALL(ceil)(double X) { return roundWhole(X, Direction::Up); }
double TP_LIBCALL(floor)(double X) { return roundWhole(X, Direction::Down); }
double TP_LIBCALL(trunc)(double X) { return roundWhole(X, Direction::Zero); }
double TP_LIBCALL(round)(double X) {
  return roundWhole(X, Direction::NearestAway);
}
double TP_LIBCALL(rint)(double X) {
  return roundWhole(X, Direction::NearestEven);
}
double TP_LIBCALL(nearbyint)(double X) {
  return roundWhole(X, Direction::NearestEven);
}
double TP_LIBCALL(roundeven)(double X) {
  return roundWhole(X, Direction::NearestEven);
}
long TP_LIBCALL(lrint)(double X) {
  return static_cast<long>(roundWhole(X, Direction::NearestEven));
}
long TP_LIBCALL(lround)(double X) {
  return static_cast<long>(roundWhole(X, Direction::NearestAway));
}
long long TP_LIBCALL(llrint)(double X) {
  return static_cast<long long>(roundWhole(X, Direction::NearestEven));
}
long long TP_LIBCALL(llround)(double X) {
  return static_cast<long long>(roundWhole(X, Direction::NearestAway));
}

double TP_LIBCALL(fabs)(double X) { return fromBits(bits(X) & ~kSign); }
double TP_LIBCALL(copysign)(double Magnitude, double Sign) {
  return fromBits((bits(Magnitude) & ~kSign) | (bits(Sign) & kSign));
}
double TP_LIBCALL(fdim)(double X, double Y) { return X <= Y ? 0.0 : X - Y; }
double TP_LIBCALL(fmin)(double X, double Y) { return smaller(X, Y); }
double TP_LIBCALL(fmax)(double X, double Y) {
  double Negated =
      smaller(fromBits(bits(X) ^ kSign), fromBits(bits(Y) ^ kSign));
  if ((bits(Negated) & ~kSign) > kInfinity)
    return Negated;
  return fromBits(bits(Negated) ^ kSign);
}
double TP_LIBCALL(fmod)(double X, double Y) { return modulo(X, Y); }
double TP_LIBCALL(remquo)(double X, double Y, int *Quotient) {
  return nearestRemainder(X, Y, *Quotient);
}
double TP_LIBCALL(remainder)(double X, double Y) {
  int Ignored;
  return nearestRemainder(X, Y, Ignored);
}

double TP_LIBCALL(nextafter)(double X, double Toward) {
  uint64_t Magnitude = bits(X) & ~kSign;
  if (Magnitude > kInfinity || (bits(Toward) & ~kSign) > kInfinity)
    return fromBits(kNaN);
  if (X == Toward)
    return Toward;
  if (Magnitude == 0)
    return fromBits((bits(Toward) & kSign) | 1);
  bool Up = (X < Toward) == ((bits(X) & kSign) == 0);
  return fromBits(Up ? bits(X) + 1 : bits(X) - 1);
}

int TP_LIBCALL(ilogb)(double X) {
  uint64_t Magnitude = bits(X) & ~kSign;
  if (Magnitude == 0 || Magnitude > kInfinity)
    return INT32_MIN;
  return Magnitude == kInfinity ? INT32_MAX
                                : unpack(Magnitude).Exponent - kBias;
}

double TP_LIBCALL(logb)(double X) {
  uint64_t Magnitude = bits(X) & ~kSign;
  if (Magnitude >= kInfinity)
    return fromBits(Magnitude > kInfinity ? kNaN : kInfinity);
  if (Magnitude == 0)
    return fromBits(kSign | kInfinity);
  return unpack(Magnitude).Exponent - kBias;
}
double TP_LIBCALL(sqrt)(double X) { return TP_LIBCALL(__tp_sqrtdf)(X); }
double TP_LIBCALL(fma)(double X, double Y, double Z) {
  return TP_LIBCALL(__tp_fmadf)(X, Y, Z);
}
double TP_LIBCALL(ldexp)(double X, int Exponent) {
  return scaleBy(X, Exponent);
}
double TP_LIBCALL(scalbn)(double X, int Exponent) {
  return scaleBy(X, Exponent);
}
double TP_LIBCALL(scalbln)(double X, long Exponent) {
  // Beyond these every number overflows or vanishes.
  return scaleBy(X, Exponent > 5000    ? 5000
                    : Exponent < -5000 ? -5000
                                       : static_cast<int>(Exponent));
}
double TP_LIBCALL(nan)(const char *) { return fromBits(kNaN); }

double TP_LIBCALL(frexp)(double X, int *Exponent) {
  *Exponent = 0;
  uint64_t Magnitude = bits(X) & ~kSign;
  if (Magnitude == 0 || Magnitude >= kInfinity)
    return X;
  Unpacked U = unpack(Magnitude);
  *Exponent = U.Exponent - (kBias - 1);
  return fromBits(pack(bits(X) & kSign, kBias - 1, U.Significand));
}

double TP_LIBCALL(modf)(double X, double *Whole) {
  *Whole = roundWhole(X, Direction::Zero);
  uint64_t Sign = bits(X) & kSign;
  uint64_t Magnitude = bits(X) & ~kSign;
  if (Magnitude >= kInfinity)
    return Magnitude > kInfinity ? fromBits(kNaN) : fromBits(Sign);
  return fromBits((bits(X - *Whole) & ~kSign) | Sign);
}

} // extern "C"
