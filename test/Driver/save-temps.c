// -save-temps keeps what is on the way to the program and changes nothing in it.
// The whole program's bitcode, assembly and object are called like lld's.
//
// RUN: rm -rf %t && mkdir -p %t/cwd %t/out
// RUN: cd %t/cwd && tpcc -O2 %s %S/Inputs/answer.c -o plain.elf
// RUN: cd %t/cwd && tpcc -O2 -save-temps %s %S/Inputs/answer.c -o saved.elf
// RUN: cmp %t/cwd/plain.elf %t/cwd/saved.elf
// RUN: ls %t/cwd | FileCheck --check-prefix=FILES %s
// RUN: FileCheck --check-prefix=PREPROCESSED %s < %t/cwd/save-temps.i
// RUN: llvm-dis %t/cwd/answer.bc -o - | FileCheck --check-prefix=UNIT %s
// RUN: llvm-dis %t/cwd/saved.elf.lto.bc -o - | FileCheck --check-prefix=PROGRAM %s
// RUN: FileCheck --check-prefix=ASSEMBLY %s < %t/cwd/saved.elf.lto.s
// RUN: llvm-nm %t/cwd/saved.elf.lto.o | FileCheck --check-prefix=OBJECT %s
//
// RUN: cd %t/cwd && tpcc -O2 -save-temps=obj %s %S/Inputs/answer.c -o %t/out/saved.elf
// RUN: ls %t/out | FileCheck --check-prefix=OBJ %s
// RUN: rm %t/cwd/* %t/out/*
// RUN: cd %t/cwd && tpcc -O2 -save-temps=cwd %s %S/Inputs/answer.c -o %t/out/saved.elf
// RUN: ls %t/out | FileCheck --check-prefix=CWD %s
// RUN: ls %t/cwd | FileCheck --check-prefix=CWDFILES %s
//
// Without a link the names are clang's.
// RUN: rm %t/cwd/*
// RUN: cd %t/cwd && tpcc -O2 -save-temps -c %s
// RUN: ls %t/cwd | FileCheck --check-prefix=COMPILED %s
// RUN: FileCheck --check-prefix=MAIN %s < %t/cwd/save-temps.s

// FILES: answer.bc
// FILES-NEXT: answer.i
// FILES-NEXT: plain.elf
// FILES-NEXT: save-temps.bc
// FILES-NEXT: save-temps.i
// FILES-NEXT: saved.elf
// FILES-NEXT: saved.elf.lto.bc
// FILES-NEXT: saved.elf.lto.o
// FILES-NEXT: saved.elf.lto.s
// FILES-NOT: {{.}}
// PREPROCESSED: int main(void)
// UNIT: define {{.*}}i32 @answer()
// PROGRAM: define {{.*}}i32 @main(
// PROGRAM-NOT: @answer
// ASSEMBLY: main:
// OBJECT: T main
// OBJ: answer.bc
// OBJ: saved.elf.lto.s
// CWD-NOT: bc
// CWD: saved.elf
// CWD-NOT: {{.}}
// CWDFILES: answer.bc
// CWDFILES: saved.elf.lto.s
// COMPILED: save-temps.bc
// COMPILED-NEXT: save-temps.i
// COMPILED-NEXT: save-temps.o
// COMPILED-NEXT: save-temps.s
// MAIN: main:

int answer(void);
int main(void) { return answer() != 42; }
