// A report names the thread and the place with the calls that were inlined.

// RUN: tpcc -O2 -ftp-check-fp %s -o %t.elf
// RUN: not tpsim --chip 4x32 --quiet %t.elf > %t.txt 2>&1
// RUN: FileCheck %s < %t.txt
// CHECK: tpsim: error: thread 7 (TM 0, TP 7) trapped at cycle {{[0-9]+}}: number out of range converted to an integer: 5.6e+10 (0x51509dc3) to int32_t
// CHECK-NEXT: pc 0x{{[0-9a-f]+}} in bin{{.*}} at {{.*}}report.cpp:36:
// CHECK-NEXT: inlined in count(float) at {{.*}}report.cpp:37:
// CHECK-NOT: instruction

// The same for any number of host threads.
// RUN: not tpsim --chip 4x32 --quiet --host-threads 3 %t.elf > %t3.txt 2>&1
// RUN: cmp %t.txt %t3.txt

// Line tables come with the option, and nothing is in the way of -g0.
// RUN: tpcc -O2 -ftp-check-fp -g0 %s -o %t0.elf
// RUN: not tpsim --chip 4x32 --quiet %t0.elf 2>&1 | FileCheck %s --check-prefix=NO-LINES
// NO-LINES: number out of range converted to an integer: 5.6e+10 (0x51509dc3) to int32_t
// NO-LINES-NEXT: pc 0x{{[0-9a-f]+}} in count(float){{$}}

// The report's code stands behind the function's, on no path of it.
// RUN: tpcc -O2 -ftp-check-fp -g0 -S %s -o - | FileCheck %s --check-prefix=CODE
// CODE-LABEL: _Z5countf:
// CODE: {{bne|beq|bltu|bgeu}}
// CODE: ret
// CODE-NOT: ret
// CODE: break 51202
// CODE: .size _Z5countf

// Their codes are not the user's.
// RUN: not tpcc -DCODE=49152 -c -fno-lto %s -o %t.o 2>&1 | FileCheck %s --check-prefix=RESERVED
// RESERVED: error: {{.*}}the first argument of 'tp_trap_break' has to be a constant from 0 to 49151

#include <tp/thread.h>

static inline int bin(float X) { return int(X * 16); }
__attribute__((noinline)) int count(float X) { return bin(X) + 1; }

int main() {
#ifdef CODE
  __builtin_tp_trap_break(CODE);
#endif
  volatile float Size = tp::threadId() == 7 ? 5e8f : 1;
  return count(Size * tp::threadId()) < 0;
}
