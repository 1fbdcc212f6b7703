// A crash of the compiler leaves the preprocessed source and a script that
// repeats it, and clang's exit status.
//
// RUN: rm -rf %t && mkdir %t && echo '#define VALUE 3' > %t/value.h
// RUN: not tpcc -fcrash-diagnostics-dir=%t/report -I%t -DCRASH -O1 -c %s -o %t/x.o > %t/output.txt 2>&1
// RUN: FileCheck %s < %t/output.txt
// RUN: not ls %t/x.o
// RUN: rm %t/value.h
// RUN: FileCheck --check-prefix=SOURCE %s < %t/report/crash-*.c
// RUN: FileCheck --check-prefix=SCRIPT %s < %t/report/crash-*.sh
// RUN: not sh -c 'sh %t/report/crash-*.sh' 2>&1 | FileCheck --check-prefix=AGAIN %s
// RUN: not tpcc -fno-crash-diagnostics -fcrash-diagnostics-dir=%t/none -DCRASH -DVALUE=1 -c %s -o %t/x.o
// RUN: not ls %t/none
//
// What LLVM cannot do is no crash.
// RUN: not tpcc -DFATAL -fcrash-diagnostics-dir=%t/none -c %s -o %t/x.o 2>&1 | FileCheck --check-prefix=FATAL %s
// RUN: not ls %t/none
//
// A reproducer on request, which compiles and links.
// RUN: not tpcc -gen-reproducer -fcrash-diagnostics-dir=%t/wanted -DVALUE=1 %s -o program.elf 2>&1 | FileCheck --check-prefix=WANTED %s
// RUN: sh -c 'sh %t/wanted/crash-*.sh' && ls %t/wanted/program.elf
// RUN: not tpcc -gen-reproducer=error -fcrash-diagnostics-dir=%t/wrong -DWRONG -c %s -o %t/x.o 2>&1 | FileCheck --check-prefix=FILES %s

#ifdef CRASH
#include "value.h"
#endif
#ifdef FATAL
#pragma clang __debug llvm_fatal_error
#endif
#ifdef WRONG
int Wrong = ;
#endif
#ifndef VALUE
#define VALUE 0
#endif
int main(void) { return VALUE - VALUE; }
#ifdef CRASH
#pragma clang __debug crash
#endif

// CHECK: This is a bug of tpcc.
// CHECK: Program arguments: {{.*}}tpcc
// CHECK: crash.c:{{[0-9]+}}:{{[0-9]+}}: current parser token
// CHECK: tpcc: error: tpcc frontend command failed with exit code {{[0-9]+}} (use -v to see invocation)
// CHECK: tpcc version
// FILES: tpcc version
// CHECK: note: diagnostic msg: {{.*}}/crash-{{.*}}.c{{$}}
// CHECK: note: diagnostic msg: {{.*}}/crash-{{.*}}.sh{{$}}
// FILES: note: diagnostic msg: {{.*}}.sh{{$}}
// SOURCE: #define VALUE 3
// SCRIPT: -DCRASH -O1 -c {{.*}}crash.c
// SCRIPT: tpcc" "-DCRASH" "-O1" "-c" "crash-{{[0-9a-f]+}}.c"
// AGAIN: This is a bug of tpcc.
// FATAL: tpcc: error: #pragma clang __debug llvm_fatal_error
// FATAL-NOT: {{.}}
// WANTED: tpcc: error: failing because '-gen-reproducer' is used
