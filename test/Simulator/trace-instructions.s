# A thread's instructions with the registers that they change; the errors.

# RUN: tpcc -nostdlib %s -o %t.elf
# RUN: tpsim --chip 1x1 --quiet --functional --trace-instructions %t.txt %t.elf
# RUN: FileCheck --strict-whitespace --match-full-lines %s < %t.txt
# RUN: tpsim --chip 4x32 --quiet --functional --trace-instructions %t.txt --trace-instructions-thread 77 %t.elf
# RUN: FileCheck %s --check-prefix=THREAD < %t.txt

#      CHECK:00010000
# CHECK-NEXT:00010004 r4=5
# CHECK-NEXT:00010008 f3=5
# CHECK-NEXT:0001000c
# CHECK-NEXT:00010010 r6=fffffffb
# CHECK-NEXT:00010014
#  CHECK-NOT:{{.}}

# THREAD: 00010014 r5=4d

# RUN: not tpsim --chip 1x1 --quiet --trace-instructions %t.txt %t.elf 2>&1 | FileCheck %s --check-prefix=TIMING
# TIMING: error: --trace-instructions needs --functional
# RUN: not tpsim --chip 1x1 --quiet --functional --trace-instructions-thread 0 %t.elf 2>&1 | FileCheck %s --check-prefix=ALONE
# ALONE: error: --trace-instructions-thread has no meaning without --trace-instructions
# RUN: not tpsim --chip 1x1 --quiet --functional --trace-instructions %t.txt --trace-instructions-thread 1 %t.elf 2>&1 | FileCheck %s --check-prefix=NO-THREAD
# NO-THREAD: error: --trace-instructions-thread 1: the chip has 1 threads
# RUN: not tpsim --chip 1x1 --quiet --functional --trace-instructions %t.none/a.txt %t.elf 2>&1 | FileCheck %s --check-prefix=FOLDER
# FOLDER: error: cannot write {{.*}}.none/a.txt: No such file or directory

  .globl _start
_start:
  addi r4, r0, 5
  mtc1 f3, r4
  addi r0, r4, 1
  sub r6, r0, r4
  mfsr r5, thread
  halt r0
