// Objects of variable size, and a frame that is aligned anew.
//
// RUN: tpcc -O0 -g -fno-lto -nostdlib -Wl,--no-gc-sections,-e,allocate %s -o %t
// RUN: llvm-dwarfdump --debug-info %t | FileCheck %s

// CHECK: DW_AT_frame_base (DW_OP_reg30)
// CHECK: DW_TAG_formal_parameter
// CHECK-NEXT: DW_AT_location (DW_OP_breg{{23|30}} {{[+-][0-9]+}})
// CHECK: DW_TAG_variable
// CHECK-NEXT: DW_AT_location (DW_OP_breg23 +{{[0-9]+}})
// CHECK-NEXT: DW_AT_name ("Aligned")
// CHECK: [0x{{.*}}): DW_OP_breg{{[0-9]+}} +0
// CHECK: DW_AT_name ("Variable")
int allocate(int Count) {
  _Alignas(64) volatile int Aligned[4] = {1, 2, 3, 4};
  volatile int Variable[Count];
  Variable[Count - 1] = Aligned[2];
  return Variable[Count - 1];
}
