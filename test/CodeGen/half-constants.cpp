// A constant of _Float16 is a number wherever it comes from.
// RUN: tpcc -O0 -S -emit-llvm -fno-lto %s -o - | FileCheck %s
// RUN: tpcc -O2 -c -fno-lto -mllvm -verify-machineinstrs %s -o %t.o

static const _Float16 Low = -769.0f;
// CHECK-LABEL: @_Z6chooseb
// CHECK: select i1 %{{.*}}, half 0xHE202, half 0xH7C00
_Float16 choose(bool Condition) {
  return Condition ? Low : (_Float16)__builtin_inff();
}

void take(_Float16);

// CHECK-LABEL: @_Z4passv
// CHECK: call void @_Z4takeDF16_(half noundef 0xHE202)
void pass() { take(Low); }
