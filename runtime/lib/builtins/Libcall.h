//===- Libcall.h - Functions that the code generator calls ------*- C++ -*-===//
//
// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
//
//===----------------------------------------------------------------------===//
//
// The names and meanings are those of GCC's runtime library, which LLVM's code
// generator expects. The host has functions of these names already, so that
// there, for tests, ours carry a prefix.
//
//===----------------------------------------------------------------------===//

#ifndef TP_RUNTIME_LIB_BUILTINS_LIBCALL_H
#define TP_RUNTIME_LIB_BUILTINS_LIBCALL_H

#include "runtime/lib/builtins/WideInteger.h"
#include <stdint.h>

#ifdef __tp__
#define TP_LIBCALL(Name) Name
#else
#define TP_LIBCALL(Name) tpSoft_##Name
#endif

extern "C" {

uint64_t TP_LIBCALL(__udivdi3)(uint64_t A, uint64_t B);
uint64_t TP_LIBCALL(__umoddi3)(uint64_t A, uint64_t B);
uint64_t TP_LIBCALL(__udivmoddi4)(uint64_t A, uint64_t B, uint64_t *Remainder);
int64_t TP_LIBCALL(__divdi3)(int64_t A, int64_t B);
int64_t TP_LIBCALL(__moddi3)(int64_t A, int64_t B);
int64_t TP_LIBCALL(__divmoddi4)(int64_t A, int64_t B, int64_t *Remainder);
int64_t TP_LIBCALL(__muldi3)(int64_t A, int64_t B);
int64_t TP_LIBCALL(__mulodi4)(int64_t A, int64_t B, int *Overflow);
int64_t TP_LIBCALL(__ashldi3)(int64_t Value, int Shift);
int64_t TP_LIBCALL(__lshrdi3)(int64_t Value, int Shift);
int64_t TP_LIBCALL(__ashrdi3)(int64_t Value, int Shift);
int TP_LIBCALL(__cmpdi2)(int64_t A, int64_t B);
int TP_LIBCALL(__ucmpdi2)(uint64_t A, uint64_t B);
int TP_LIBCALL(__clzsi2)(uint32_t Value);
int TP_LIBCALL(__clzdi2)(uint64_t Value);
int TP_LIBCALL(__ctzsi2)(uint32_t Value);
int TP_LIBCALL(__ctzdi2)(uint64_t Value);
int TP_LIBCALL(__ffssi2)(uint32_t Value);
int TP_LIBCALL(__ffsdi2)(uint64_t Value);
int TP_LIBCALL(__paritysi2)(uint32_t Value);
int TP_LIBCALL(__paritydi2)(uint64_t Value);
int TP_LIBCALL(__popcountsi2)(uint32_t Value);
int TP_LIBCALL(__popcountdi2)(uint64_t Value);
uint32_t TP_LIBCALL(__bswapsi2)(uint32_t Value);
uint64_t TP_LIBCALL(__bswapdi2)(uint64_t Value);

// A 128-bit argument arrives as its two halves, and a result leaves through a
// hidden pointer, like a struct. Clang's own 128-bit types are not needed here.
tp::wide::Integer128 TP_LIBCALL(__udivti3)(uint64_t ALow, uint64_t AHigh,
                                           uint64_t BLow, uint64_t BHigh);
tp::wide::Integer128 TP_LIBCALL(__umodti3)(uint64_t ALow, uint64_t AHigh,
                                           uint64_t BLow, uint64_t BHigh);
tp::wide::Integer128 TP_LIBCALL(__udivmodti4)(uint64_t ALow, uint64_t AHigh,
                                              uint64_t BLow, uint64_t BHigh,
                                              tp::wide::Integer128 *Remainder);
tp::wide::Integer128 TP_LIBCALL(__divti3)(uint64_t ALow, uint64_t AHigh,
                                          uint64_t BLow, uint64_t BHigh);
tp::wide::Integer128 TP_LIBCALL(__modti3)(uint64_t ALow, uint64_t AHigh,
                                          uint64_t BLow, uint64_t BHigh);
tp::wide::Integer128 TP_LIBCALL(__divmodti4)(uint64_t ALow, uint64_t AHigh,
                                             uint64_t BLow, uint64_t BHigh,
                                             tp::wide::Integer128 *Remainder);
tp::wide::Integer128 TP_LIBCALL(__multi3)(uint64_t ALow, uint64_t AHigh,
                                          uint64_t BLow, uint64_t BHigh);
tp::wide::Integer128 TP_LIBCALL(__muloti4)(uint64_t ALow, uint64_t AHigh,
                                           uint64_t BLow, uint64_t BHigh,
                                           int *Overflow);
tp::wide::Integer128 TP_LIBCALL(__ashlti3)(uint64_t Low, uint64_t High,
                                           int Shift);
tp::wide::Integer128 TP_LIBCALL(__lshrti3)(uint64_t Low, uint64_t High,
                                           int Shift);
tp::wide::Integer128 TP_LIBCALL(__ashrti3)(uint64_t Low, uint64_t High,
                                           int Shift);
tp::wide::Integer128 TP_LIBCALL(__fixdfti)(double A);
tp::wide::Integer128 TP_LIBCALL(__fixunsdfti)(double A);
tp::wide::Integer128 TP_LIBCALL(__fixsfti)(float A);
tp::wide::Integer128 TP_LIBCALL(__fixunssfti)(float A);
double TP_LIBCALL(__floattidf)(uint64_t Low, uint64_t High);
double TP_LIBCALL(__floatuntidf)(uint64_t Low, uint64_t High);
float TP_LIBCALL(__floattisf)(uint64_t Low, uint64_t High);
float TP_LIBCALL(__floatuntisf)(uint64_t Low, uint64_t High);

double TP_LIBCALL(__adddf3)(double A, double B);
double TP_LIBCALL(__subdf3)(double A, double B);
double TP_LIBCALL(__muldf3)(double A, double B);
double TP_LIBCALL(__divdf3)(double A, double B);
double TP_LIBCALL(__negdf2)(double A);
double TP_LIBCALL(__powidf2)(double A, int Exponent);
float TP_LIBCALL(__powisf2)(float A, int Exponent);
int TP_LIBCALL(__eqdf2)(double A, double B);
int TP_LIBCALL(__nedf2)(double A, double B);
int TP_LIBCALL(__ltdf2)(double A, double B);
int TP_LIBCALL(__ledf2)(double A, double B);
int TP_LIBCALL(__gtdf2)(double A, double B);
int TP_LIBCALL(__gedf2)(double A, double B);
int TP_LIBCALL(__unorddf2)(double A, double B);

double TP_LIBCALL(__extendsfdf2)(float A);
float TP_LIBCALL(__truncdfsf2)(double A);
int32_t TP_LIBCALL(__fixdfsi)(double A);
uint32_t TP_LIBCALL(__fixunsdfsi)(double A);
int64_t TP_LIBCALL(__fixdfdi)(double A);
uint64_t TP_LIBCALL(__fixunsdfdi)(double A);
double TP_LIBCALL(__floatsidf)(int32_t A);
double TP_LIBCALL(__floatunsidf)(uint32_t A);
double TP_LIBCALL(__floatdidf)(int64_t A);
double TP_LIBCALL(__floatundidf)(uint64_t A);
int64_t TP_LIBCALL(__fixsfdi)(float A);
uint64_t TP_LIBCALL(__fixunssfdi)(float A);
float TP_LIBCALL(__floatdisf)(int64_t A);
float TP_LIBCALL(__floatundisf)(uint64_t A);
uint16_t TP_LIBCALL(__truncsfhf2)(float A);
uint16_t TP_LIBCALL(__truncdfhf2)(double A);
float TP_LIBCALL(__extendhfsf2)(uint16_t A);
uint16_t TP_LIBCALL(__truncsfbf2)(float A);
uint16_t TP_LIBCALL(__truncdfbf2)(double A);

/// The square root's kernel of sqrt() in math.h.
double TP_LIBCALL(__tp_sqrtdf)(double A);
/// A * B + C, rounded once: the kernel of fma() in math.h.
double TP_LIBCALL(__tp_fmadf)(double A, double B, double C);

} // extern "C"

#endif // TP_RUNTIME_LIB_BUILTINS_LIBCALL_H
