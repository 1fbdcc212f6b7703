// The whole-program link says where in the source wrong assembly is, for each
// line of its text, as a compilation to an object does.
// RUN: not tpcc -O0 %s -o %t.elf 2>&1 | FileCheck %s
// RUN: not tpcc -O0 -c %s -o %t.o 2>&1 | FileCheck %s

int mnemonic(int X) {
  // CHECK: inline-assembly-link-errors.c:[[#@LINE+2]]:17: error: unknown instruction 'bogus'
  // CHECK: <inline asm>:2:2: note: instantiated into assembly here
  __asm__("nop\n\t"
          "bogus %0, %0" : "+r"(X));
  return X;
}
int modifier(int X) {
  // CHECK: inline-assembly-link-errors.c:[[#@LINE+1]]:{{[0-9]+}}: error: invalid operand in inline asm
  __asm__("add %0, %1, %q1" : "=r"(X) : "r"(X));
  return X;
}
int main(void) { return mnemonic(1) + modifier(2); }
