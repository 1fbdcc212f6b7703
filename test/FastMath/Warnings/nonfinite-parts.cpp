// Each half of finite math has its own flag, and a pragma gives them back.

// RUN: clang++ -fplugin=%tp_bin/../lib/TPFloatingPoint.so -fno-honor-nans \
// RUN:   -fsyntax-only -Xclang -verify=nan %s
// RUN: clang++ -fplugin=%tp_bin/../lib/TPFloatingPoint.so \
// RUN:   -fno-honor-infinities -fsyntax-only -Xclang -verify=infinity %s

// infinity-note@+1 {{or '#pragma float_control(precise, on)' before the function, makes}}
float a() { return __builtin_inff(); } // infinity-warning {{infinity has no defined effect}}
// nan-note@+1 {{or '#pragma float_control(precise, on)' before the function, makes}}
float b() { return __builtin_nanf(""); } // nan-warning {{NaN has no defined effect}}
bool c(float X) { return __builtin_isinf(X); } // infinity-warning {{test for infinity may}}
bool d(float X) { return __builtin_isnan(X); } // nan-warning {{test for NaN may}}
bool e(float X) { return X != X; } // nan-warning {{test for NaN may}}
bool f(float X) { return __builtin_isfinite(X); } // nan-warning {{test for infinity and NaN}} infinity-warning {{test for infinity and NaN}}

#pragma float_control(precise, on, push)
float a2() { return __builtin_inff() - __builtin_nanf(""); }
bool c2(float X) { return __builtin_isinf(X) || X != X; }
float g() { return 1.0f / 0.0f; }
#pragma float_control(pop)

float h() { return 1.0f / 0.0f; } // infinity-warning {{this constant is infinite}}
