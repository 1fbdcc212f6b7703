//===- FloatCases.cpp - Float instructions, computed otherwise ------------===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// In wider formats, rounded once: where the exact result does not fit the wider
// format it has so many more bits that rounding twice changes nothing.
//
//===----------------------------------------------------------------------===//

#include "test/unit/isa/InstructionCases.h"

#include <bit>
#include <cmath>

namespace tp::test {

namespace {

/// 113 bits of precision.
using Quad = __float128;

float asFloat(uint32_t Bits) { return std::bit_cast<float>(Bits); }

uint32_t asBits(float Value) {
  return std::isnan(Value) ? 0x7FC00000 : std::bit_cast<uint32_t>(Value);
}

bool isNaN(uint32_t Bits) { return (Bits & 0x7FFFFFFF) > 0x7F800000; }

/// -1, 0, 1 for less, equal, greater; 2 if unordered. In integers.
int compare(uint32_t A, uint32_t B) {
  if (isNaN(A) || isNaN(B))
    return 2;
  auto Ordinal = [](uint32_t Bits) {
    int64_t Magnitude = Bits & 0x7FFFFFFF;
    return Bits >> 31 ? -Magnitude : Magnitude;
  };
  int64_t X = Ordinal(A), Y = Ordinal(B);
  return X < Y ? -1 : X > Y;
}

/// The smaller or larger in the total order of numbers, NaN only if both are.
uint32_t extreme(uint32_t A, uint32_t B, bool Larger) {
  if (isNaN(A))
    return isNaN(B) ? 0x7FC00000 : B;
  if (isNaN(B))
    return A;
  auto Key = [](uint32_t Bits) { return Bits >> 31 ? ~Bits : Bits | 1u << 31; };
  return (Key(A) < Key(B)) != Larger ? A : B;
}

/// A * B + C, rounded once. The product is exact in 113 bits; a sum that is not
/// is rounded to odd, so that the rounding to float sees on which side of a tie
/// it lies.
float multiplyAdd(float A, float B, float C) {
  Quad Product = Quad(A) * Quad(B);
  Quad Sum = Product + Quad(C);
  auto Bits = std::bit_cast<unsigned __int128>(Sum);
  Quad Added = Sum - Product;
  Quad Error = (Product - (Sum - Added)) + (Quad(C) - Added);
  // An infinite sum has the error NaN.
  if (!(Error < 0 || Error > 0) || Bits & 1)
    return float(Sum);
  bool Outward = (Error > 0) == (Sum > 0);
  return float(std::bit_cast<Quad>(Outward ? Bits + 1 : Bits - 1));
}

enum class Rounding { Zero, Nearest, Down, Up };

/// Rounds a finite double that is a float to an integer by looking at its
/// floor and the distance from it.
double toIntegral(double Value, Rounding Mode) {
  if (std::fabs(Value) >= 0x1p40)
    return Value;
  int64_t Floor = int64_t(Value);
  if (double(Floor) > Value)
    --Floor;
  double Rest = Value - double(Floor);
  bool Up = false;
  switch (Mode) {
  case Rounding::Zero:
    Up = Rest > 0 && Value < 0;
    break;
  case Rounding::Nearest:
    Up = Rest > 0.5 || (Rest == 0.5 && Floor % 2 != 0);
    break;
  case Rounding::Down:
    break;
  case Rounding::Up:
    Up = Rest > 0;
    break;
  }
  return std::copysign(double(Floor + Up), Value);
}

uint32_t toInteger(uint32_t Bits, Rounding Mode, double Least, double Most) {
  if (isNaN(Bits))
    return 0;
  double Value = asFloat(Bits);
  if (std::isfinite(Value))
    Value = toIntegral(Value, Mode);
  return uint32_t(int64_t(std::fmin(std::fmax(Value, Least), Most)));
}

} // namespace

void addFloatCases(InstructionCases &Cases) {
  auto Arithmetic = [&](const char *Mnemonic, auto Function,
                        uint32_t Ulps = 0) {
    Cases[Mnemonic] =
        ValueCase{.Expected = [=](const Inputs &In) -> std::optional<uint32_t> {
                    return asBits(Function(asFloat(In.Rs), asFloat(In.Rt)));
                  },
                  .Flushes = true,
                  .Ulps = Ulps};
  };
  Arithmetic("add_s",
             [](float A, float B) { return float(Quad(A) + Quad(B)); });
  Arithmetic("sub_s",
             [](float A, float B) { return float(Quad(A) - Quad(B)); });
  Arithmetic("mul_s",
             [](float A, float B) { return float(Quad(A) * Quad(B)); });
  Arithmetic("div_s",
             [](float A, float B) { return float(Quad(A) / Quad(B)); });
  Cases["madd_s"] =
      ValueCase{.Expected = [](const Inputs &In) -> std::optional<uint32_t> {
                  return asBits(multiplyAdd(asFloat(In.Rs), asFloat(In.Rt),
                                            asFloat(In.Old)));
                },
                .Flushes = true,
                .Accumulates = true};
  Arithmetic("rcp_s", [](float A, float) { return float(Quad(1) / Quad(A)); });
  Arithmetic("sqrt_s", [](float A, float) {
    return float(std::sqrt(static_cast<long double>(A)));
  });
  // By definition two roundings to double before the one to float.
  Arithmetic("rsqrt_s", [](float A, float) {
    double Root = double(std::sqrt(static_cast<long double>(A)));
    return float(double(Quad(1) / Quad(Root)));
  });
  Arithmetic(
      "sin_s",
      [](float A, float) {
        return A == 0 ? A : float(std::sin(static_cast<long double>(A)));
      },
      1);
  Arithmetic(
      "cos_s",
      [](float A, float) {
        return float(std::cos(static_cast<long double>(A)));
      },
      1);

  auto Value = [&](const char *Mnemonic, auto Function, bool Flushes = true) {
    Cases[Mnemonic] =
        ValueCase{.Expected = [=](const Inputs &In) -> std::optional<uint32_t> {
                    return uint32_t(Function(In));
                  },
                  .Flushes = Flushes};
  };
  Value("min_s", [](auto &In) { return extreme(In.Rs, In.Rt, false); });
  Value("max_s", [](auto &In) { return extreme(In.Rs, In.Rt, true); });

  // By the outcomes for which the condition holds.
  auto Compare = [&](const char *Mnemonic, bool Less, bool Equal, bool Greater,
                     bool Unordered) {
    Value(Mnemonic, [=](auto &In) {
      switch (compare(In.Rs, In.Rt)) {
      case -1:
        return Less;
      case 0:
        return Equal;
      case 1:
        return Greater;
      default:
        return Unordered;
      }
    });
  };
  Compare("c_un_s", false, false, false, true);
  Compare("c_or_s", true, true, true, false);
  Compare("c_eq_s", false, true, false, false);
  Compare("c_une_s", true, false, true, true);
  Compare("c_ueq_s", false, true, false, true);
  Compare("c_one_s", true, false, true, false);
  Compare("c_olt_s", true, false, false, false);
  Compare("c_ole_s", true, true, false, false);
  Compare("c_ult_s", true, false, false, true);
  Compare("c_ule_s", true, true, false, true);

  // Any 32-bit integer is a double.
  Value("cvt_s_w", [](auto &In) {
    return asBits(float(double(int64_t(In.Rs) - (int64_t(In.Rs >> 31) << 32))));
  });
  Value("cvt_s_wu",
        [](auto &In) { return asBits(float(double(uint64_t(In.Rs)))); });

  const std::pair<const char *, Rounding> Modes[] = {
      {"trunc", Rounding::Zero},
      {"round", Rounding::Nearest},
      {"floor", Rounding::Down},
      {"ceil", Rounding::Up}};
  for (auto [Name, Mode] : Modes) {
    Value((std::string(Name) + "_w_s").c_str(), [Mode = Mode](auto &In) {
      return toInteger(In.Rs, Mode, -0x1p31, 0x1p31 - 1);
    });
    Value((std::string(Name) + "_s").c_str(), [Mode = Mode](auto &In) {
      float Number = asFloat(In.Rs);
      return asBits(std::isfinite(Number) ? float(toIntegral(Number, Mode))
                                          : Number);
    });
  }
  Value("trunc_wu_s", [](auto &In) {
    return toInteger(In.Rs, Rounding::Zero, 0, 0x1p32 - 1);
  });
}

} // namespace tp::test
