// Infinities, NaNs and tests for them under finite math, in tpcc and in stock
// clang with the plug-in.

// RUN: tpcc -ffast-math -fsyntax-only -Xclang -verify %s
// RUN: tpcc -ftp-fp=fast -fsyntax-only -Xclang -verify %s
// RUN: clang++ -fplugin=%tp_bin/../lib/TPFloatingPoint.so -ffast-math \
// RUN:   -fsyntax-only -Xclang -verify %s

// Where infinities and NaNs count there is nothing to say.
// RUN: tpcc -fsyntax-only -Xclang -verify=silent %s
// RUN: tpcc -ffast-math -fno-finite-math-only -fsyntax-only \
// RUN:   -Xclang -verify=silent %s
// RUN: tpcc -ftp-fp=reproducible -fsyntax-only -Xclang -verify=silent %s
// RUN: tpcc -ftp-fp=strict -fsyntax-only -Xclang -verify=silent %s
// silent-no-diagnostics

#include <cmath>
#include <limits>

// The cure is told once.
// expected-note@+1 {{'-fno-finite-math-only' after the flags that imply finite math}}
float macro() { return INFINITY; } // expected-warning {{infinity has no defined effect under finite math [-Wtp-fp-nonfinite]}}
float nanMacro() { return NAN; }   // expected-warning {{NaN has no defined effect under finite math [-Wtp-fp-nonfinite]}}
float huge() { return HUGE_VALF; } // expected-warning {{infinity has no defined effect}}
double huge2() { return HUGE_VAL; } // expected-warning {{infinity has no defined effect}}
float limit() {
  return -std::numeric_limits<float>::infinity(); // expected-warning {{infinity has no defined effect}}
}
double quiet() {
  return std::numeric_limits<double>::quiet_NaN(); // expected-warning {{NaN has no defined effect}}
}
double signaling() {
  return std::numeric_limits<double>::signaling_NaN(); // expected-warning {{NaN has no defined effect}}
}
double builtin() { return __builtin_inf(); }    // expected-warning {{infinity has no defined effect}}
float builtin2() { return __builtin_nanf(""); } // expected-warning {{NaN has no defined effect}}

bool tests(float X) {
  return std::isnan(X) ||      // expected-warning {{this test for NaN may be folded away under finite math [-Wtp-fp-nonfinite]}}
         std::isinf(X) ||      // expected-warning {{this test for infinity may be folded away}}
         !std::isfinite(X) ||  // expected-warning {{this test for infinity and NaN may be folded away}}
         __builtin_isnan(X) || // expected-warning {{this test for NaN may be folded away}}
         std::fpclassify(X) == FP_NAN; // expected-warning {{this test for infinity and NaN may be folded away}}
}
bool masks(float X) {
  return __builtin_isfpclass(X, 0x0003) || // expected-warning {{this test for NaN may be folded away}}
         __builtin_isfpclass(X, 0x0204) || // expected-warning {{this test for infinity may be folded away}}
         __builtin_isfpclass(X, 0x0060);
}

struct Sample {
  float Value;
  float Array[4];
};
bool idioms(float X, double Y, const Sample &S, int I) {
  return X != X ||                      // expected-warning {{this test for NaN may be folded away}}
         !(Y == Y) ||                   // expected-warning {{this test for NaN may be folded away}}
         S.Value != (S.Value) ||        // expected-warning {{this test for NaN may be folded away}}
         S.Array[I] != S.Array[I] ||    // expected-warning {{this test for NaN may be folded away}}
         X - X != 0.0f ||               // expected-warning {{this test for infinity and NaN may be folded away}}
         X > std::numeric_limits<float>::max() || // expected-warning {{this test for infinity may be folded away}}
         -__FLT_MAX__ > X ||            // expected-warning {{this test for infinity may be folded away}}
         !(std::fabs(X) <= __FLT_MAX__); // expected-warning {{this test for infinity may be folded away}}
}

// Nothing is wrong with these.
float next(float *&P);
bool sound(float X, float Y, const Sample &S, int I, float *P) {
  bool Sentinel = X < std::numeric_limits<float>::max() || X == __FLT_MAX__;
  bool Others = X != Y || S.Array[I] != S.Array[I + 1] ||
                next(P) != next(P);
  bool Range = Y > __DBL_MIN__ || std::isnormal(X) || std::signbit(Y);
  bool Integers = I != int(X);
  static_assert(std::numeric_limits<float>::infinity() > 1);
  static_assert(sizeof(INFINITY) == sizeof(float));
  return Sentinel || Others || Range || Integers ||
         std::numeric_limits<int>::infinity() != 0 ||
         std::numeric_limits<float>::has_infinity;
}

// A test that looks at the bits works.
namespace bits {
bool isnan(float X) { return (__builtin_bit_cast(unsigned, X) << 1) > 0xff000000; }
} // namespace bits
bool ownTest(float X) { return bits::isnan(X); }
