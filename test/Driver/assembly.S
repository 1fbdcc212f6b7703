// Assembly with and without the preprocessor, debug lines, and errors.
//
// RUN: tpcc -c %s -DVALUE=7 -g -o %t.o
// RUN: llvm-nm %t.o | FileCheck %s
// RUN: tp-objdump -d %t.o | FileCheck --check-prefix=CODE %s
// RUN: tpcc -nostdlib -DVALUE=7 -g %s -o %t.elf
// RUN: llvm-symbolizer --obj=%t.elf 0x10000 | FileCheck --check-prefix=LINE %s
// RUN: llvm-dwarfdump --verify %t.elf
// RUN: not tpcc -c -DVALUE=7 -DBAD %s -o %t.o 2>&1 | FileCheck --check-prefix=BAD %s
// RUN: not tpcc -c -x assembler %S/Inputs/bad.s -o %t.o 2>&1 | FileCheck --check-prefix=PLAIN %s
//
// CHECK: T _start
// CODE: addi r2, r0, 7
// LINE: _start
// LINE-NEXT: assembly.S:[[#@LINE + 5]]
// PLAIN: bad.s:1:{{[0-9]+}}: error:

  .globl _start
_start:
  addi r2, r0, VALUE
  halt r2
#ifdef BAD
// BAD: assembly.S:[[#@LINE + 1]]:{{[0-9]+}}: error:
  frobnicate r1
#endif
