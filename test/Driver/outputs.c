// Each stage at which clang stops, and its output.
//
// RUN: tpcc -E %s | FileCheck --check-prefix=PREPROCESSED %s
// RUN: tpcc -O1 -S -emit-llvm %s -o - | FileCheck --check-prefix=IR %s
// RUN: tpcc -O1 -c -emit-llvm %s -o %t.bc && llvm-dis %t.bc -o - | FileCheck --check-prefix=IR %s
// RUN: tpcc -O1 -S %s -o - | FileCheck --check-prefix=ASM %s
// RUN: tpcc -O1 -c %s -o %t.o && llvm-readelf -hs %t.o | FileCheck --check-prefix=OBJECT %s
// RUN: tpcc -fsyntax-only %s
// RUN: rm -rf %t.dir && mkdir %t.dir && cd %t.dir && tpcc -c %s %S/Inputs/answer.c
// RUN: llvm-nm %t.dir/outputs.o %t.dir/answer.o | FileCheck --check-prefix=SEVERAL %s
//
// RUN: echo 'int fromStdin;' | tpcc -x c -c - -o %t.o && llvm-nm %t.o | FileCheck --check-prefix=STDIN %s
// RUN: echo '-O1 -S %s -o -' > %t.response && tpcc @%t.response | FileCheck --check-prefix=ASM %s
// RUN: tpcc -c -MD -MF %t.d -o %t.o %s -include %S/Inputs/answer.c && FileCheck --check-prefix=DEPENDENCIES %s < %t.d
// RUN: tpcc -S -emit-llvm -x ir %t.bc -o - | FileCheck --check-prefix=IR %s
// RUN: tpcc -S -emit-llvm -mllvm -opt-bisect-limit=0 -O1 %s -o %t.ll 2>&1 | FileCheck --check-prefix=MLLVM %s

int twice(int X) { return X * 2; }

// PREPROCESSED: int twice(int X)
// IR: target datalayout = "e-m:e-p:32:32-i64:64-n32-S64"
// IR: target triple = "tp-unknown-elf"
// IR: define {{.*}}i32 @twice(i32
// ASM: twice:
// ASM: ret
// OBJECT: Class: ELF32
// OBJECT: Type: REL
// OBJECT: Machine: 5450
// OBJECT: FUNC GLOBAL DEFAULT {{[0-9]+}} twice
// SEVERAL: outputs.o:
// SEVERAL: T twice
// SEVERAL: answer.o:
// SEVERAL: T answer
// STDIN: fromStdin
// DEPENDENCIES: outputs.c.tmp.o:
// DEPENDENCIES: outputs.c
// DEPENDENCIES: answer.c
// MLLVM: BISECT: NOT running pass
