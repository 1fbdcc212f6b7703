// Assembly says what it takes of the stack in a record, unless it leaves the
// stack pointer alone; its calls are found in the instructions.
//
// RUN: tpcc -O1 %s -o %t.elf -DRECORD -Wl,-Map=%t.map -x c++ %S/Inputs/calls-assembly.cpp
// RUN: FileCheck %s < %t.map
// RUN: tpsim --chip 1x1 --quiet %t.elf
// CHECK: The stack of a thread takes at most
// CHECK: main
// CHECK-NEXT: 48 assembled
// CHECK-NEXT: 0 leaf
// CHECK-NEXT: {{[1-9][0-9]+}} compiled

// RUN: not tpcc -O1 %s -o %t.elf -x c++ %S/Inputs/calls-assembly.cpp 2>&1 \
// RUN:   | FileCheck %s --check-prefix=MISSING
// MISSING: assembled is not compiled and does not state what it takes of the stack (section .tp.frames)
// MISSING-NEXT: reached by _start -> __tp_start_thread -> main -> assembled

// RUN: not tpcc -O1 %s -o %t.elf -DCUT -x c++ %S/Inputs/calls-assembly.cpp 2>&1 \
// RUN:   | FileCheck %s --check-prefix=CUT
// CUT: error: {{.*}}:(.tp.frames+0x0): the record of a stack frame is cut off; compile or assemble the file again

// A jump through a register may go anywhere.
// RUN: not tpcc -O1 %s -o %t.elf -DRECORD -DREGISTER -x c++ %S/Inputs/calls-assembly.cpp 2>&1 \
// RUN:   | FileCheck %s --check-prefix=REGISTER
// REGISTER: recursion: assembled -> leaf -> (pointer) -> {{.*}}assembled

  .text
  .globl assembled
  .type assembled, @function
assembled:
  addi r29, r29, -48
  sw r31, 44(r29)
  jal leaf
  lw r31, 44(r29)
  addi r29, r29, 48
  ret
  .size assembled, .-assembled

leaf:
#ifdef REGISTER
  la r1, assembled
  jr r1
#else
  j compiled
#endif

#ifdef RECORD
  .section .tp.frames, "e"
  .word assembled, 48, 0, 0, 0
#endif
#ifdef CUT
  .section .tp.frames, "e"
  .word assembled, 48
#endif
