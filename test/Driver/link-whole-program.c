// C, IR, bitcode, assembly, objects and archives in one program; the optimizer
// sees across files.
//
// RUN: rm -rf %t && split-file %s %t && cd %t
// RUN: tpcc -O2 -c ir.ll -emit-llvm -o bitcode.bc
// RUN: tpcc -O2 -c member.c -o member.o && llvm-ar rc libarchive.a member.o
// RUN: tpcc -O2 -c unused.c -o unused.o && llvm-ar rc libarchive.a unused.o
// RUN: tpcc -O2 -c object.c -o object.o
// RUN: tpcc -O2 main.c ir.ll assembly.s object.o -L. -larchive -lm -o program.elf
// RUN: tpsim program.elf --chip 1x1 2>/dev/null | FileCheck main.c
// RUN: tpcc -O0 main.c bitcode.bc assembly.s object.o libarchive.a -o program.elf
// RUN: tpsim program.elf --chip 1x1 2>/dev/null | FileCheck main.c
// RUN: llvm-nm program.elf | FileCheck --check-prefix=SYMBOLS main.c
// RUN: tpcc -O2 -nostdlib across.c square.c -o across.elf
// RUN: tp-objdump -d across.elf | FileCheck --check-prefix=ACROSS across.c

//--- main.c
// CHECK: 1 2 3 4
// SYMBOLS-NOT: unused
#include <stdio.h>
int fromIr(void), fromAssembly(void), fromObject(void), fromArchive(void);
int main(void) {
  printf("%d %d %d %d\n", fromIr(), fromAssembly(), fromObject(), fromArchive());
  return 0;
}
int calledFromObject(void) { return 3; }

//--- ir.ll
target triple = "tp-unknown-elf"
define i32 @fromIr() {
  ret i32 1
}

//--- assembly.s
  .text
  .globl fromAssembly
fromAssembly:
  addi r4, r0, 2
  jr r31

//--- object.c
int calledFromObject(void);
int fromObject(void) { return calledFromObject(); }

//--- member.c
int fromArchive(void) { return 4; }

//--- unused.c
int unused(void) { return 5; }

//--- across.c
// ACROSS: addi r{{[0-9]+}}, r0, 49
// ACROSS-NOT: jal
int square(int X);
void _start(void) { __builtin_tp_halt(square(7)); }

//--- square.c
int square(int X) { return X * X; }
