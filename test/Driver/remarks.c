// Remarks and optimization records of the passes, in a compilation and in the
// link of the whole program, also those of the code generator.
//
// RUN: rm -rf %t && mkdir %t
// RUN: tpcc -O2 -Rpass=loop-unroll -Rpass-missed=inline -c %s -o %t/x.o 2>&1 | FileCheck --check-prefixes=UNROLL,MISSED --implicit-check-not=remark: %s
// RUN: tpcc -O2 -Rpass-analysis=asm-printer -c %s -o %t/x.o 2>&1 | FileCheck --check-prefix=MACHINE %s
//
// The callee is in another unit: only the link can inline it.
// RUN: tpcc -O2 -Rpass=inline %s %S/Inputs/increment.c -o %t/x.elf 2>&1 | FileCheck --check-prefix=LINK --implicit-check-not='runtime/' %s
// RUN: tpcc -O2 -Rpass=inline -Rno-pass %s %S/Inputs/increment.c -o %t/x.elf 2>&1 | count 0
// RUN: tpcc -O2 -Rpass-analysis=prologepilog %s %S/Inputs/increment.c -o %t/x.elf 2>&1 | FileCheck --check-prefix=FRAME --implicit-check-not='runtime/' %s
// RUN: tpcc -O2 %s %S/Inputs/increment.c -o %t/x.elf 2>&1 | count 0
// RUN: not tpcc '-Rpass=(' %s %S/Inputs/increment.c -o %t/x.elf 2>&1 | FileCheck --check-prefix=REGEX %s
//
// RUN: tpcc -O2 -fsave-optimization-record -c %s -o %t/x.o
// RUN: FileCheck --check-prefix=RECORD %s < %t/x.opt.yaml
// RUN: tpcc -O2 -fsave-optimization-record %s %S/Inputs/increment.c -o %t/x.elf
// RUN: FileCheck --check-prefix=LINKRECORD %s < %t/x.elf.opt.ld.yaml
// RUN: tpcc -O2 -foptimization-record-file=%t/named.yaml -foptimization-record-passes=inline %s %S/Inputs/increment.c -o %t/x.elf
// RUN: FileCheck --check-prefix=LINKRECORD --implicit-check-not='Pass:            {{[^i]}}' %s < %t/named.yaml.opt.ld.yaml

int increment(int By);
__attribute__((noinline)) static int zero(void) { return 0; }
int table[4];
int sum(void) {
  int Sum = 0;
  // UNROLL: remarks.c:[[@LINE+1]]:3: remark: completely unrolled loop with 4 iterations [-Rpass=loop-unroll]
  for (int I = 0; I < 4; ++I)
    Sum += table[I];
  return Sum;
}
// MACHINE: remarks.c:{{[0-9]+}}:{{[0-9]+}}: remark: {{[0-9]+}} instructions in function [-Rpass-analysis=asm-printer]

int main(void) {
  // MISSED: remarks.c:[[@LINE+4]]:25: remark: 'zero' not inlined into 'main' because {{.*}}noinline{{.*}} [-Rpass-missed=inline]
  // LINK: remarks.c:[[@LINE+3]]:10: remark: 'increment' inlined into 'main' with {{.*}} [-Rpass=inline]
  // LINK-NEXT: {{^}} [[@LINE+2]] | return increment(2)
  // LINK-NEXT: {{^}} | ^
  return increment(2) + zero() + sum() != 42;
}
// FRAME: remarks.c:{{.*}}: remark: {{[0-9]+}} stack bytes in function 'main' [-Rpass-analysis=prologepilog]
// REGEX: error: in pattern '-Rpass=(': parentheses not balanced
// RECORD: --- !Passed
// RECORD: Pass: {{.*}}loop-unroll
// LINKRECORD: Pass: {{.*}}inline
// LINKRECORD: Callee: {{.*}}increment
