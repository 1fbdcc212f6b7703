// Constants that become infinite or NaN. What is wrong with a literal clang
// says itself; if it may not, we do.

// RUN: tpcc -ffast-math -Xclang -verify=expected,literal -fsyntax-only %s
// RUN: tpcc -ffast-math -Wno-literal-range -fsyntax-only \
// RUN:   -Xclang -verify=expected,ours %s
// RUN: tpcc -Wno-literal-range -fsyntax-only -Xclang -verify=silent %s
// silent-no-diagnostics

float Literal = 1e39f; // literal-warning {{magnitude of floating-point constant too large}} ours-warning {{this constant is infinite, which has no defined effect under finite math [-Wtp-fp-nonfinite]}} ours-note {{'-fno-finite-math-only'}}
float Quotient = 1.0f / 0.0f; // expected-warning {{this constant is infinite, which has no defined effect under finite math [-Wtp-fp-nonfinite]}} literal-note {{'-fno-finite-math-only'}}
double NotANumber = 0.0 / 0.0; // expected-warning {{this constant is NaN, which has no defined effect}}
float Product = -1e30f * 1e30f; // expected-warning {{this constant is infinite}}
float Narrowed = 1e300; // expected-warning {{this constant is infinite}}
float Cast = (float)1e300; // expected-warning {{this constant is infinite}}
constexpr float Big = 3e38f;
float folded() { return Big + Big; } // expected-warning {{this constant is infinite}}
// Once, where the infinity comes up.
float Chain = 1.0f / 0.0f * 2.0f - 1.0f; // expected-warning {{this constant is infinite}}

float Small = 1e-60;
float Largest = 3.4028234e38f;
float Fine = 1.0f / 3.0f;
float unknown(float X) { return X / 0.0f; }
int Integer = 7 / 2;
