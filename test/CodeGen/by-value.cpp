// Structs passed by value: a temporary that is made for the call is itself
// passed; what is used afterwards is copied; the callee's changes stay its own.
//
// RUN: tpcc -O2 -fno-lto -S -emit-llvm %s -o - | FileCheck %s
// RUN: tpcc -O0 -S -emit-llvm %s -o - | FileCheck %s --check-prefix=UNOPTIMIZED
// RUN: tpcc -O2 %s -DRUN -o %t.elf && tpsim %t.elf --chip 1x1 | FileCheck %s --check-prefix=OUTPUT
// RUN: tpcc -O0 %s -DRUN -o %t.elf && tpsim %t.elf --chip 1x1 | FileCheck %s --check-prefix=OUTPUT

#include <stdio.h>

struct Vector {
  float X, Y, Z;
};

#ifdef RUN
#define EXTERNAL __attribute__((noinline))
#else
#define EXTERNAL
#endif

Vector make(float X);
float use(Vector V);
// The attribute speaks of what the program sees: not of the copy.
__attribute__((const)) float length(Vector V);

// UNOPTIMIZED: call {{.*}} @_Z3use6Vector({{.*}}byval(%struct.Vector)

// CHECK-LABEL: @_Z9temporaryf(
// CHECK: alloca
// CHECK-NOT: alloca
// CHECK-NOT: memcpy
// CHECK: call {{.*}}@_Z3use6Vector(ptr
EXTERNAL float temporary(float X) { return use(make(X)); }

// CHECK-LABEL: @_Z5twicef(
// CHECK-COUNT-2: memcpy
// CHECK: ret float
EXTERNAL float twice(float X) {
  Vector V = make(X);
  return use(V) + use(V);
}

// CHECK-LABEL: @_Z10constTwicef(
// CHECK: memcpy
// CHECK: call {{.*}}@_Z6length6Vector(
EXTERNAL float constTwice(float X) {
  Vector V = make(X);
  return length(V) + V.X;
}

// CHECK-LABEL: @_Z4loopi(
// CHECK: memcpy
EXTERNAL float loop(int Count) {
  float Sum = 0;
  Vector V = make(1);
  for (int I = 0; I < Count; ++I)
    Sum += use(V);
  return Sum;
}

#ifdef RUN
EXTERNAL Vector make(float X) { return {X, 2 * X, 3 * X}; }
EXTERNAL float use(Vector V) {
  V.X += 1;
  volatile float *Y = &V.Y;
  *Y *= 2;
  return V.X + V.Y;
}
EXTERNAL float length(Vector V) {
  V.X *= V.X;
  V.Y *= V.Y;
  return V.X + V.Y + V.Z;
}

int main() {
  // OUTPUT: 6
  printf("%d\n", int(temporary(1)));
  // OUTPUT: 12
  printf("%d\n", int(twice(1)));
  // OUTPUT: 28
  printf("%d\n", int(constTwice(2)));
  // OUTPUT: 18
  printf("%d\n", int(loop(3)));
}
#endif
