// Registers, immediates and memory as operands of inline assembly.
//
// RUN: tpcc -O2 -S %s -o - | FileCheck %s
// RUN: not tpcc -fsyntax-only -DBAD %s 2>&1 | FileCheck --check-prefix=BAD %s

// CHECK-LABEL: operands:
// CHECK: addi [[R:r[0-9]+]], r4, 12
// CHECK: mul_s {{f[0-9]+}}, f4, f4
int operands(int A, float B, float *Out) {
  int Sum;
  __asm__("addi %0, %1, %2" : "=r"(Sum) : "r"(A), "I"(12));
  __asm__("mul_s %0, %1, %1" : "=f"(*Out) : "f"(B));
  return Sum;
}

// CHECK-LABEL: clobbers:
// CHECK: sw {{.*}}r16
void clobbers(void) { __asm__ volatile("nop" ::: "r16", "f20", "memory"); }

#ifdef BAD
// BAD: error: value '70000' out of range for constraint 'I'
int immediate(void) {
  int R;
  __asm__("addi %0, r0, %1" : "=r"(R) : "I"(70000));
  return R;
}
// BAD: error: unknown register name 'eax' in asm
void name(void) { __asm__("nop" ::: "eax"); }
#endif
