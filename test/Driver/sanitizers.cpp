// A failed check of -fsanitize= traps, and the simulator says which check it
// was and where, with and without -g and optimization.
//
// RUN: tpcc -O2 -fsanitize=undefined -DCHECK=0 %s -o %t.elf && not tpsim --chip 1x1 --quiet %t.elf 2>&1 | FileCheck --check-prefix=OVERFLOW %s
// RUN: tpcc -O0 -g -fsanitize=undefined -DCHECK=0 %s -o %t.elf && not tpsim --chip 1x1 --quiet %t.elf 2>&1 | FileCheck --check-prefix=OVERFLOW %s
// RUN: tpcc -O2 -fno-lto -fsanitize=signed-integer-overflow %s -DCHECK=0 -o %t.elf && not tpsim --chip 1x1 --quiet %t.elf 2>&1 | FileCheck --check-prefix=OVERFLOW %s
// RUN: tpcc -O1 -fsanitize=undefined -DCHECK=1 %s -o %t.elf && not tpsim --chip 1x1 --quiet %t.elf 2>&1 | FileCheck --check-prefix=BOUNDS %s
// RUN: tpcc -O1 -fsanitize=undefined -DCHECK=2 %s -o %t.elf && not tpsim --chip 1x1 --quiet %t.elf 2>&1 | FileCheck --check-prefix=SHIFT %s
// RUN: tpcc -O1 -fsanitize=undefined -DCHECK=3 %s -o %t.elf && not tpsim --chip 1x1 --quiet %t.elf 2>&1 | FileCheck --check-prefix=DIVISION %s
// RUN: tpcc -O1 -fsanitize=undefined -DCHECK=4 %s -o %t.elf && not tpsim --chip 1x1 --quiet %t.elf 2>&1 | FileCheck --check-prefix=NULLPOINTER %s
// RUN: tpcc -O1 -fsanitize=undefined -DCHECK=5 %s -o %t.elf && not tpsim --chip 1x1 --quiet %t.elf 2>&1 | FileCheck --check-prefix=UNREACHABLE %s
// RUN: tpcc -O1 -fsanitize=integer -DCHECK=6 %s -o %t.elf && not tpsim --chip 1x1 --quiet %t.elf 2>&1 | FileCheck --check-prefix=UNSIGNED %s
// RUN: tpcc -O1 -fsanitize=undefined,float-divide-by-zero,float-cast-overflow -DCHECK=7 %s -o %t.elf && not tpsim --chip 1x1 --quiet %t.elf 2>&1 | FileCheck --check-prefix=CONVERSION %s
//
// Nothing fails: the program does what it does without checks.
// RUN: tpcc -O2 -fsanitize=undefined,integer,nullability -DCHECK=8 %s -o %t.elf && tpsim --chip 1x1 --quiet %t.elf
//
// Without line tables only the trap is left.
// RUN: tpcc -O2 -fsanitize=undefined -g0 -DCHECK=0 %s -o %t.elf && not tpsim --chip 1x1 --quiet %t.elf 2>&1 | FileCheck --check-prefix=UNNAMED %s

volatile int Big = 0x7fffffff, One = 1, Zero = 0;
volatile unsigned UnsignedBig = 0xffffffff;
volatile float Float = 1e20f;
int Table[4];

int check() {
  int Value = Big;
  int Shift = One + 31;
  (void)Shift;
#if CHECK == 0
  // OVERFLOW: trapped at cycle {{[0-9]+}}: undefined behaviour: signed integer addition overflow in 'Value + Value'
  // OVERFLOW-NEXT: pc 0x{{[0-9a-f]+}} in check{{.*}} at {{.*}}sanitizers.cpp:[[@LINE+2]]:16
  // OVERFLOW-NOT: __clang_trap_msg
  return Value + Value;
#elif CHECK == 1
  // BOUNDS: undefined behaviour: array index out of bounds
  // BOUNDS-NEXT: in check{{.*}} at {{.*}}sanitizers.cpp:[[@LINE+1]]:
  return Table[Value & 7];
#elif CHECK == 2
  // SHIFT: undefined behaviour: shift
  return Value << Shift;
#elif CHECK == 3
  // DIVISION: undefined behaviour: integer divide or remainder
  return Value / Zero;
#elif CHECK == 4
  // NULLPOINTER: undefined behaviour: {{.*}}null
  return *reinterpret_cast<int *>(Zero);
#elif CHECK == 5
  // UNREACHABLE: undefined behaviour: {{.*}}unreachable
  if (One)
    __builtin_unreachable();
  return 0;
#elif CHECK == 6
  // UNSIGNED: undefined behaviour: unsigned integer addition overflow in 'UnsignedBig + 1U'
  return UnsignedBig + 1u;
#elif CHECK == 7
  // CONVERSION: undefined behaviour: {{.*}}overflow
  return static_cast<int>(Float);
#else
  return Table[Value & 3] + (Value - Value) / One;
#endif
}
// UNNAMED: trapped at cycle {{[0-9]+}}: break
// UNNAMED-NOT: undefined behaviour

int main() { return check(); }
