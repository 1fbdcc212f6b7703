// Objects of variable size, and a frame that is aligned anew.
//
// RUN: tpcc -O0 -g -fno-lto -nostdlib -Wl,--no-gc-sections,-e,allocate %s -o %t
// RUN: llvm-dwarfdump --debug-info %t | FileCheck %s
// The library is optimized and another kind of debug information is on for it.
// RUN: tpcc -O0 -g %s -o %t.whole
// RUN: llvm-dwarfdump --name=Variable %t.whole | FileCheck %s --check-prefix=O0
// RUN: tpcc -O2 -g %s -o %t.O2
// RUN: llvm-dwarfdump --name=Variable %t.O2 | FileCheck %s --check-prefix=O2
// Debug information does not change the code.
// RUN: tpcc -O0 -c -fno-lto %s -o %t.plain.o
// RUN: tpcc -O0 -g -c -fno-lto %s -o %t.debug.o
// RUN: llvm-objcopy -O binary -j '.text*' %t.plain.o %t.plain
// RUN: llvm-objcopy -O binary -j '.text*' %t.debug.o %t.debug
// RUN: test -s %t.plain && cmp %t.plain %t.debug

// CHECK: DW_AT_frame_base (DW_OP_reg30)
// CHECK: DW_TAG_formal_parameter
// CHECK-NEXT: DW_AT_location (DW_OP_breg{{23|30}} {{[+-][0-9]+}})
// CHECK: DW_TAG_variable
// CHECK-NEXT: DW_AT_location (DW_OP_breg23 +{{[0-9]+}})
// CHECK-NEXT: DW_AT_name ("Aligned")
// CHECK: DW_AT_location (DW_OP_breg23 +{{[0-9]+}}, DW_OP_deref)
// CHECK-NEXT: DW_AT_name ("Variable")
// O0: DW_AT_location (DW_OP_breg23 +{{[0-9]+}}, DW_OP_deref)
// O2: [0x{{.*}}): DW_OP_breg{{[0-9]+}} +0
// O2-NEXT: DW_AT_name ("Variable")
__attribute__((noinline)) int allocate(int Count) {
  _Alignas(64) volatile int Aligned[4] = {1, 2, 3, 4};
  volatile int Variable[Count];
  Variable[Count - 1] = Aligned[2];
  return Variable[Count - 1];
}

int main(int Count, char **Arguments) { return allocate(Count + 5) != 3; }
