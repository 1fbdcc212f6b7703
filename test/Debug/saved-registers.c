// A variable that outlives a call is in a register that the callee saves.
//
// RUN: tpcc -O2 -g -fno-lto -nostdlib -Wl,--no-gc-sections,-e,keep %s -o %t
// RUN: llvm-dwarfdump --name=Kept --name=KeptFloat %t | FileCheck %s

// CHECK: DW_TAG_formal_parameter
// CHECK: [0x{{.*}}): DW_OP_reg4
// CHECK-NEXT: [0x{{.*}}): DW_OP_reg{{1[6-9]|2[0-3]}}
// CHECK: DW_AT_name ("Kept")
// CHECK: DW_TAG_formal_parameter
// CHECK: [0x{{.*}}): DW_OP_regx 0x24
// CHECK-NEXT: [0x{{.*}}): DW_OP_regx 0x3{{[4-9a-f]}}
// CHECK: DW_AT_name ("KeptFloat")
__attribute__((noinline)) void callee(void) {
  __asm__ volatile("" ::: "memory");
}
float keep(int Kept, float KeptFloat) {
  callee();
  callee();
  return KeptFloat * KeptFloat + (float)(Kept * Kept);
}
