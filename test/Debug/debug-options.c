// How much is described, in which version, and what the paths are.
//
// RUN: tpcc -O1 -g0 %s -o %t && llvm-dwarfdump --name=square %t | FileCheck %s --check-prefix=NONE
// RUN: tpcc -O1 -gline-tables-only %s -o %t && llvm-dwarfdump --verify %t
// RUN: llvm-dwarfdump --debug-line %t | FileCheck %s --check-prefix=LINES
// RUN: llvm-dwarfdump --name=Argument %t | FileCheck %s --check-prefix=NONE
// RUN: tpcc -O1 -g %s -o %t && llvm-dwarfdump --debug-info %t | FileCheck %s --check-prefix=FULL
// RUN: llvm-dwarfdump --debug-macro %t | FileCheck %s --check-prefix=NO-MACRO
//
// RUN: tpcc -O1 -gdwarf-4 %s -o %t && llvm-dwarfdump --verify %t
// RUN: llvm-dwarfdump --debug-info %t | FileCheck %s --check-prefix=VERSION4
// RUN: tpcc -O1 -gdwarf-3 -fno-lto %s -o %t && llvm-dwarfdump --verify %t
//
// RUN: tpcc -O1 -g3 -fdebug-macro %s -o %t && llvm-dwarfdump --debug-macro %t | FileCheck %s --check-prefix=MACRO
// RUN: tpcc -O1 -g -gdwarf-4 -fdebug-macro -fno-lto %s -o %t && llvm-dwarfdump --debug-macro %t | FileCheck %s --check-prefix=MACRO
//
// RUN: tpcc -O1 -g -fdebug-prefix-map=%S=/mapped %s -o %t && llvm-dwarfdump --name=square %t | FileCheck %s --check-prefix=MAPPED
//
// An object with compressed debug data links.
// RUN: tpcc -O1 -g -gz -fno-lto -c %s -o %t.o && llvm-readelf -S %t.o | FileCheck %s --check-prefix=COMPRESSED
// RUN: tpcc %t.o -o %t && llvm-dwarfdump --verify %t && llvm-dwarfdump --name=square %t | FileCheck %s --check-prefix=SQUARE
// RUN: tpcc -O1 -g -gz=zstd -fno-lto %s -o %t && llvm-dwarfdump --name=square %t | FileCheck %s --check-prefix=SQUARE
//
// Split debug data: an object has a file of its own for it, which the program
// names; a whole program keeps it.
// RUN: rm -rf %t.d && mkdir %t.d && cd %t.d
// RUN: tpcc -O1 -g -gsplit-dwarf -fno-lto -c %s -o split.o && tpcc split.o -o split
// RUN: llvm-dwarfdump --debug-info split | FileCheck %s --check-prefix=SKELETON
// RUN: llvm-dwarfdump --debug-info split.dwo | FileCheck %s --check-prefix=SQUARE
// RUN: tpcc -O1 -g -gsplit-dwarf %s -o whole && llvm-dwarfdump --name=square whole | FileCheck %s --check-prefix=SQUARE

// NONE-NOT: DW_TAG
// LINES: debug-options.c
// FULL: version = 0x0005
// FULL: DW_AT_name ("Argument")
// VERSION4: version = 0x0004
// VERSION4: DW_AT_name ("square")
// MACRO: macro: SQUARE(x) ((x) * (x))
// NO-MACRO-NOT: SQUARE
// MAPPED: DW_AT_decl_file ("/mapped/debug-options.c")
// SQUARE: DW_AT_name ("square")
// COMPRESSED: .debug_info {{.*}} C
// SKELETON: unit_type = DW_UT_skeleton
// SKELETON: DW_AT_dwo_name ("split.dwo")
#define SQUARE(x) ((x) * (x))
__attribute__((noinline)) int square(int Argument) { return SQUARE(Argument); }
int main(int Count, char **Words) { return square(Count) - 1; }
