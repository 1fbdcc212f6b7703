// Debug data of an object: relocations for the linker, and the same values in
// place for tools that do not know the TP's relocations.
//
// RUN: tpcc -O1 -g -fno-lto -c %s -o %t.o
// RUN: llvm-dwarfdump --verify %t.o
// RUN: llvm-dwarfdump --name=square %t.o | FileCheck %s
// RUN: tp-objdump -r %t.o | FileCheck %s --check-prefix=RELOCATIONS
// RUN: tp-objdump -d -l %t.o | FileCheck %s --check-prefix=LINES

// CHECK: DW_AT_low_pc (0x00000000)
// CHECK-NEXT: DW_AT_high_pc (0x00000008)
// CHECK: DW_AT_name ("square")
// RELOCATIONS: .debug_info
// RELOCATIONS: R_TP_32
// RELOCATIONS: .debug_frame
// RELOCATIONS: R_TP_32
// LINES: <square>:
// LINES: unlinked.c:[[#@LINE + 2]]
// LINES: mul
int square(int Argument) { return Argument * Argument; }
int Global = 3;
int use(void) { return square(Global); }
