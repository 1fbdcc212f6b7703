// The compiler's text assembles to the compiler's object: code, data, line
// numbers, names that are registers' names.
// RUN: tpcc -O2 -S %s -o %t.s
// RUN: tp-mc -filetype=obj %t.s -o %t.text.o
// RUN: tpcc -O2 -c %s -o %t.o
// RUN: cmp %t.text.o %t.o
// RUN: tp-objdump -d %t.o | FileCheck %s

// With debugging information the order of the debug sections differs.
// RUN: tpcc -O2 -g -S %s -o %t.s
// RUN: tp-mc -filetype=obj %t.s -o %t.debug.o
// RUN: tp-objdump -drlS %t.debug.o > %t.text.txt
// RUN: tpcc -O2 -g -c %s -o %t.debug.o
// RUN: tp-objdump -drlS %t.debug.o > %t.txt
// RUN: cmp %t.text.txt %t.txt
// RUN: FileCheck --check-prefix=LINES %s < %t.txt
// LINES: <f1>:
// LINES-NEXT: ; f1:
// LINES-NEXT: compiled-round-trip.c:
// LINES-NEXT: ; int f1(int A)

int r4;
extern int sp;
int zero(void);
_Thread_local int Local = 5;
long long Wide = 0x123456789abcdefll;
double Double = 1.5;
const char *String = "text";

int f1(int A) { return A + r4 + sp + zero() + Local; }

// CHECK: <f1>:
// CHECK-DAG: lui r{{[0-9]+}}, %hi(r4)
// CHECK-DAG: lw r{{[0-9]+}}, %lo(sp)
// CHECK-DAG: jal zero

int ra(int (*P)(void), int Selector) {
  switch (Selector) {
  case 0:
    return f1(P());
  case 1:
    return P();
  case 2:
    return (int)(Wide >> 3);
  case 3:
    return String[Selector];
  case 4:
    return (int)Double;
  default:
    return Selector;
  }
}

float inlineAssembly(float A) {
  float Result;
  __asm__("add_s %0, %1, %1" : "=f"(Result) : "f"(A));
  return Result;
}
// CHECK: <inlineAssembly>:
// CHECK: add_s f{{[0-9]+}}, f4, f4
