// Operands that cannot be are clear errors.
// RUN: not tpcc -c -O1 %s -o %t.o 2>&1 | FileCheck %s

typedef struct { int A[3]; } Three;

int constraint(int X) {
  // CHECK: [[#@LINE+1]]:{{[0-9]+}}: error: invalid output constraint '=q' in asm
  __asm__("nop" : "=q"(X));
  // CHECK: [[#@LINE+1]]:{{[0-9]+}}: error: value '70000' out of range for constraint 'I'
  __asm__("addi %0, %0, %1" : "+r"(X) : "I"(70000));
  // CHECK: [[#@LINE+1]]:{{[0-9]+}}: error: value '-1' out of range for constraint 'K'
  __asm__("ori %0, %0, %1" : "+r"(X) : "K"(-1));
  // CHECK: [[#@LINE+1]]:{{[0-9]+}}: error: value '1' out of range for constraint 'J'
  __asm__("move %0, %z1" : "=r"(X) : "J"(1));
  // CHECK: [[#@LINE+1]]:{{[0-9]+}}: error: unknown register name 'r77' in asm
  __asm__("nop" ::: "r77");
  return X;
}

int size(double D, Three T, __int128 I) {
  int R;
  // CHECK: [[#@LINE+1]]:{{[0-9]+}}: error: invalid input size for constraint 'f'
  __asm__("trunc_w_s %0, %1" : "=r"(R) : "f"(D));
  // CHECK: [[#@LINE+1]]:{{[0-9]+}}: error: invalid output size for constraint '=f'
  __asm__("cvt_s_w %0, r4" : "=f"(D));
  // CHECK: [[#@LINE+1]]:{{[0-9]+}}: error: invalid input size for constraint 'r'
  __asm__("nop" : "=r"(R) : "r"(T));
  // CHECK: [[#@LINE+1]]:{{[0-9]+}}: error: invalid output size for constraint '+r'
  __asm__("nop" : "+r"(I));
  return R;
}

// CHECK: [[#@LINE+1]]:{{[0-9]+}}: error: register 'r16' unsuitable for global register variables
register int Allocated __asm__("r16");
// CHECK-NOT: error:
register void *StackPointer __asm__("sp");
void *top(void) { return StackPointer; }
