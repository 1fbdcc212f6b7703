// Assembly that the assembler refuses, modifiers that do not exist, operands
// that are no constants, too many registers.
// RUN: not tpcc -fno-lto -c -O1 %s -o %t.o 2>&1 | FileCheck %s

// CHECK: [[#@LINE+1]]:{{[0-9]+}}: error: constraint 'I' expects an integer constant expression
int number(int X) { __asm__("addi %0, %0, %1" : "+r"(X) : "I"(X)); return X; }

// CHECK: [[#@LINE+1]]:{{[0-9]+}}: error: unknown instruction 'bogus'
int mnemonic(int X) { __asm__("bogus %0, %0" : "+r"(X)); return X; }

// CHECK: [[#@LINE+1]]:{{[0-9]+}}: error: invalid operand in inline asm: 'add $0, $1, ${1:q}'
int modifier(int X) { __asm__("add %0, %1, %q1" : "=r"(X) : "r"(X)); return X; }

// CHECK: [[#@LINE+1]]:{{[0-9]+}}: error: invalid operand in inline asm: 'move $0, ${1:M}'
int second(int X) { __asm__("move %0, %M1" : "=r"(X) : "r"(X)); return X; }

// CHECK: [[#@LINE+1]]:{{[0-9]+}}: error: operand must be an integer register
int kind(float X) { int R; __asm__("add %0, %1, r0" : "=r"(R) : "f"(X)); return R; }
