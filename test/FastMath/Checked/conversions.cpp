// A NaN and a number out of range stop where they become integers; the greatest
// and the smallest numbers in range do not.

// RUN: tpcc -O0 -ftp-check-fp %s -o %t0.elf
// RUN: %run_cases %s tpsim --chip 1x1 --quiet %t0.elf -- | FileCheck %s
// RUN: tpcc -O3 -ftp-check-fp %s -o %t3.elf
// RUN: %run_cases %s tpsim --chip 1x1 --quiet %t3.elf -- | FileCheck %s
// Whether the conversion saturates or has no defined result.
// RUN: tpcc -O3 -ftp-check-fp -fstrict-float-cast-overflow %s -o %ts.elf
// RUN: %run_cases %s tpsim --chip 1x1 --quiet %ts.elf -- | FileCheck %s
// The check is what stops them.
// RUN: tpcc -O3 %s -o %tu.elf
// RUN: %run_cases %s tpsim --chip 1x1 --quiet %tu.elf -- \
// RUN:   | FileCheck %s --check-prefix=OFF --implicit-check-not=trap
// OFF: nan: 0

#include "Inputs/cases.h"
#include <math.h>

using FloatVector = float __attribute__((vector_size(16)));
using IntegerVector = int __attribute__((vector_size(16)));

NOINLINE int truncated(float X) { return int(X); }
template <typename To, typename From> NOINLINE To convert(From X) {
  return To(X);
}

static void vector(float X) {
  FloatVector V{1, 2, X, 4};
  volatile IntegerVector Result = __builtin_convertvector(V, IntegerVector);
}

volatile int Sink;

int main(int, char **Arguments) {
  const char *Case = Arguments[1];
  // CHECK: nan: 1
  // CHECK-NEXT: tpsim: error: thread 0: NaN converted to an integer: nan (0x7fc00000) to int32_t
  // CHECK-NEXT: in truncated(float) at {{.*}}conversions.cpp:23:46
  CASE("nan", Sink = truncated(floatOf(NaN)))
  // CHECK: signalling: 1
  // CHECK-NEXT: NaN converted to an integer: -nan{{.*}} (0xffa00001) to int32_t
  CASE("signalling", Sink = truncated(floatOf(0xFFA00001)))
  // CHECK: infinity: 1
  // CHECK-NEXT: number out of range converted to an integer: -inf (0xff800000) to int32_t
  CASE("infinity", Sink = truncated(floatOf(0xFF800000)))

  // CHECK: above: 1
  // CHECK-NEXT: number out of range converted to an integer: {{.*}} (0x4f000000) to int32_t
  CASE("above", Sink = truncated(floatOf(0x4F000000)))
  // CHECK: below: 1
  // CHECK-NEXT: number out of range converted to an integer: {{.*}} (0xcf000001) to int32_t
  CASE("below", Sink = truncated(floatOf(0xCF000001)))
  // CHECK: limits: 0
  // CHECK-NEXT: zero: 0
  CASE("limits", Sink = truncated(floatOf(0x4EFFFFFF)) +
                        truncated(floatOf(0xCF000000)))
  CASE("zero", Sink = truncated(floatOf(0x80000000)) + truncated(floatOf(1)))

  // CHECK-NEXT: unsigned: 1
  // CHECK-NEXT: number out of range converted to an integer: -1 (0xbf800000) to uint32_t
  CASE("unsigned", (Sink = convert<unsigned, float>(floatOf(0xBF800000))))
  // CHECK: unsigned-limits: 0
  CASE("unsigned-limits", (Sink = convert<unsigned, float>(floatOf(0x4F7FFFFF)) +
                                  convert<unsigned, float>(floatOf(0xBF7FFFFF))))
  // CHECK: byte: 1
  // CHECK-NEXT: number out of range converted to an integer: 128 (0x43000000) to int8_t
  CASE("byte", (Sink = convert<signed char, float>(floatOf(0x43000000))))
  // CHECK: byte-limits: 0
  CASE("byte-limits", (Sink = convert<signed char, float>(floatOf(0x42FFFFFF)) +
                              convert<signed char, float>(floatOf(0xC300FFFF))))
  // CHECK: long: 1
  // CHECK-NEXT: number out of range converted to an integer: 1e+20 (0x60ad78ec) to int64_t
  CASE("long", (Sink = convert<long long, float>(floatOf(0x60AD78EC))))

  // CHECK: double: 1
  // CHECK-NEXT: number out of range converted to an integer: -2147483649 (0xc1e0000000200000) to int32_t
  CASE("double", (Sink = convert<int, double>(doubleOf(0xC1E0000000200000))))
  // CHECK: double-nan: 1
  // CHECK-NEXT: NaN converted to an integer: nan (0x7ff8000000000001) to uint64_t
  CASE("double-nan", (Sink = convert<unsigned long long, double>(
                          doubleOf(0x7FF8000000000001))))
  // CHECK: double-limits: 0
  CASE("double-limits", (Sink = convert<int, double>(doubleOf(0xC1E00000001FFFFF)) +
                                convert<int, double>(doubleOf(0x41DFFFFFFFFFFFFF))))

  // CHECK: builtins: 0
  CASE("builtins", Sink = __builtin_tp_trunc_w(floatOf(0xCF000000)) +
                          __builtin_tp_round_w(floatOf(0x4EFFFFFF)) +
                          __builtin_tp_floor_w(floatOf(0xCF000000)) +
                          __builtin_tp_ceil_w(floatOf(0x4EFFFFFF)))
  // CHECK: floor: 1
  // CHECK-NEXT: NaN converted to an integer: nan (0x7fc00000) to int32_t
  // CHECK-NEXT: in main at {{.*}}conversions.cpp:[[#@LINE+1]]:
  CASE("floor", Sink = __builtin_tp_floor_w(floatOf(NaN)))
  // CHECK: round: 1
  // CHECK-NEXT: number out of range converted to an integer: 3e+09 (0x4f32d05e) to int32_t
  CASE("round", Sink = __builtin_tp_round_w(floatOf(0x4F32D05E)))
  // CHECK: lround: 1
  // CHECK-NEXT: number out of range converted to an integer: 2147483647.5 (0x41dfffffffe00000) to int32_t
  CASE("lround", Sink = lround(doubleOf(0x41DFFFFFFFE00000)))
  // CHECK: lrint-limits: 0
  CASE("lrint-limits", Sink = lrint(doubleOf(0xC1E0000000100000)))
  // CHECK: vector: 1
  // CHECK-NEXT: NaN converted to an integer: nan (0x7fc00000) to int32_t
  // CHECK-NEXT: in vector{{.*}} at {{.*}}conversions.cpp:30:
  CASE("vector", vector(floatOf(NaN)))
  // CHECK: vector-limits: 0
  CASE("vector-limits", vector(floatOf(0x4EFFFFFF)))
  return 2;
}
