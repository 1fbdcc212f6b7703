// Arguments in integer and float registers, and a 64-bit one in two.
//
// RUN: tpcc -O2 -g -fno-lto -nostdlib -Wl,--no-gc-sections,-e,registers %s -o %t
// RUN: llvm-dwarfdump --debug-info %t | FileCheck %s

// CHECK: DW_TAG_subprogram
// CHECK: DW_AT_frame_base (DW_OP_reg29)
// CHECK: DW_TAG_formal_parameter
// CHECK-NEXT: DW_AT_location (DW_OP_reg4)
// CHECK: DW_AT_name ("First")
// CHECK: DW_TAG_formal_parameter
// CHECK-NEXT: DW_AT_location (DW_OP_regx 0x24)
// CHECK: DW_AT_name ("Second")
// CHECK: DW_TAG_formal_parameter
// CHECK: DW_OP_reg5, DW_OP_piece 0x4, DW_OP_reg6, DW_OP_piece 0x4
// CHECK: DW_AT_name ("Third")
void registers(int First, float Second, long long Third) {
  __asm__ volatile("" ::"r"(First), "f"(Second), "r"(Third));
}
