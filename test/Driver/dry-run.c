// -### prints commands that a shell can run, one per job, and that make the same
// program as tpcc does on its own. Nothing else is done.
//
// RUN: rm -rf %t && mkdir %t
// RUN: tpcc -O2 %s %S/Inputs/answer.c -o %t/direct.elf
// RUN: tpcc -### -O2 %s %S/Inputs/answer.c -o %t/steps.elf > %t/output.txt 2>&1
// RUN: not ls %t/steps.elf
// RUN: FileCheck %s < %t/output.txt
// RUN: grep '^ "' %t/output.txt > %t/jobs.sh
// RUN: sh -e %t/jobs.sh
// RUN: cmp %t/direct.elf %t/steps.elf
//
// The assembler's job and those of -fno-lto.
// RUN: tpcc -fno-lto -nostdlib -g %s %S/Inputs/startup.s %S/Inputs/answer.c -o %t/direct.elf
// RUN: tpcc -### -fno-lto -nostdlib -g %s %S/Inputs/startup.s %S/Inputs/answer.c -o %t/steps.elf 2>&1 | grep '^ "' > %t/jobs.sh
// RUN: FileCheck --check-prefix=SEPARATE %s < %t/jobs.sh
// RUN: sh -e %t/jobs.sh
// RUN: cmp %t/direct.elf %t/steps.elf
//
// -v prints them and runs them, -fdriver-only does not.
// RUN: tpcc -v %s %S/Inputs/answer.c -o %t/verbose.elf 2>&1 | FileCheck --check-prefix=VERBOSE %s
// RUN: ls %t/verbose.elf
// RUN: tpcc -v -fdriver-only %s -o %t/none.elf 2>&1 | FileCheck --check-prefix=VERBOSE %s
// RUN: not ls %t/none.elf
// RUN: tpcc -ccc-print-phases %s 2>&1 | FileCheck --check-prefix=PHASES %s

// CHECK: tpcc version
// CHECK: InstalledDir:
// CHECK: tpcc" "-cc1"
// CHECK: tpcc" "-cc1"
// CHECK: tpcc" "-o" "{{[^"]*}}steps.elf" "-O2" "{{[^"]*}}.o" "{{[^"]*}}.o"
// SEPARATE: tpcc" "-cc1" {{.*}}"-emit-obj"
// SEPARATE: tpcc" "-cc1as"
// VERBOSE: tpcc version
// VERBOSE: tpcc" {{"?}}-cc1
// VERBOSE: tpcc" {{"?}}-o
// PHASES: 5: linker, {4}, image

int answer(void);
int main(void) { return answer() != 42; }
