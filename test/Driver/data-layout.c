// Clang and the code generator agree on the data layout: llc keeps what clang
// wrote and does not complain.
//
// RUN: tpcc -S -emit-llvm %s -o %t.ll
// RUN: %llc_tp %t.ll -o - | FileCheck %s

// CHECK: f:
long long f(long long *P) { return *P; }
