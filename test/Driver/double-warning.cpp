// -Wtp-double warns of arithmetic in double, once for an expression. It is off
// unless asked for, and independent of the group tp-fp.
//
// RUN: tpcc -fsyntax-only -Wtp-double %s 2>&1 | FileCheck %s
// RUN: tpcc -fsyntax-only -Wtp-double %s 2>&1 | grep -c 'warning:' | FileCheck --check-prefix=COUNT %s
// RUN: tpcc -fsyntax-only -Wtp-fp %s 2>&1 | count 0
// RUN: tpcc -fsyntax-only -Wtp-double -Wno-tp-double %s 2>&1 | count 0
// RUN: tpcc -fsyntax-only -Wtp-double -w %s 2>&1 | count 0
// RUN: tpcc -fsyntax-only -Wno-tp-fp -Wtp-double %s 2>&1 | FileCheck %s
// RUN: not tpcc -fsyntax-only -Werror=tp-double %s 2>&1 | FileCheck --check-prefix=ERROR %s
// RUN: not tpcc -fsyntax-only -Wtp-doubel %s 2>&1 | FileCheck --check-prefix=UNKNOWN %s
// The fix-it is right.
// RUN: cp %s %t.cpp && tpcc -fsyntax-only -Wtp-double -Xclang -fixit %t.cpp 2> %t.txt; FileCheck --check-prefix=FIXED %s < %t.cpp

// COUNT: {{^}}12{{$}}
// ERROR: error: arithmetic in double, which the TP does in software [-Werror,-Wtp-double]
// UNKNOWN: tpcc: error: unknown warning option '-Wtp-doubel'; did you mean '-Wtp-double'?

#include <cmath>
#include <cstdio>

// CHECK: :[[@LINE+3]]:33: warning: arithmetic in double, which the TP does in software [-Wtp-double]
// CHECK: :[[@LINE+2]]:35: note: a literal in double; '2.0f' is one in float
// FIXED: return X * 2.0f; }
float scale(float X) { return X * 2.0; }
// CHECK: warning: 'sqrt' computes in double, which the TP does in software; 'sqrtf' computes in float
float root(float X) { return ::sqrt(X); }
double Member;
// CHECK: :[[@LINE+1]]:{{[0-9]+}}: warning: conversion from 'float' to 'double', which the TP does in software
void store(float X) { Member = X; }
// CHECK: :[[@LINE+1]]:{{[0-9]+}}: warning: conversion from 'double' to 'float'
float load() { return Member; }
// CHECK: :[[@LINE+1]]:{{[0-9]+}}: warning: conversion from 'double' to 'int'
int toInteger() { return static_cast<int>(Member); }
// CHECK: :[[@LINE+1]]:{{[0-9]+}}: warning: conversion from 'int' to 'double'
double fromInteger(int I) { return I; }
// CHECK: :[[@LINE+1]]:{{[0-9]+}}: warning: comparison in double
bool less(float X) { return X < 0.5; }
// CHECK: :[[@LINE+1]]:{{[0-9]+}}: warning: arithmetic in double
void increment() { ++Member; }
// CHECK: :[[@LINE+1]]:{{[0-9]+}}: warning: arithmetic in double
void add() { Member += 1; }
// CHECK: :[[@LINE+1]]:{{[0-9]+}}: warning: arithmetic in double
template <class T> T instance(T X) { return X * 3.0; }
template float instance(float);
// CHECK: :[[@LINE+3]]:{{[0-9]+}}: warning: arithmetic in double
// CHECK: note: a literal in double; '2.0f'
// CHECK: note: a literal in double; '3.0f'
float chain(float X) { return X * 2.0 + X * 3.0 - 1; }
#define PI 3.14
// CHECK: :[[@LINE+1]]:{{[0-9]+}}: warning: arithmetic in double
float macro(float X) { return X * PI; }

// What is in float, constant, or has to be double.
float good(float X) { return std::sqrt(X) * 2.0f + std::pow(X, 2.0f); }
constexpr float Third = 1.0 / 3.0;
float half(float X) { return X * static_cast<float>(0.5); }
void print(float X) { std::printf("%f\n", X); }
double hand(double X) { return X; }
unsigned size(float X) { return sizeof(X * 2.0); }
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wtp-double"
float silenced(float X) { return X * 2.0; }
#pragma clang diagnostic pop
