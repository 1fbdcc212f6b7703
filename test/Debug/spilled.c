// Variables in slots of the frame, while there is no register for them.
//
// RUN: tpcc -O2 -g -fno-lto -nostdlib -Wl,--no-gc-sections,-e,spill %s -o %t
// RUN: llvm-dwarfdump --name=Variable %t | FileCheck %s

// CHECK: DW_OP_reg{{[0-9]+}}
// CHECK: DW_OP_breg29 +{{[0-9]+}}
// CHECK: DW_AT_name ("Variable")
int spill(int Argument) {
  int Variable = Argument * 3;
  __asm__ volatile("" ::"r"(Variable));
  __asm__ volatile("" ::: "r2", "r3", "r4", "r5", "r6", "r7", "r8", "r9", "r10",
                   "r11", "r12", "r13", "r14", "r15", "r16", "r17", "r18",
                   "r19", "r20", "r21", "r22", "r23", "r24", "r25", "r26",
                   "r27", "r28", "r30", "r31");
  return Variable;
}
