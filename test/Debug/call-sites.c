// What a caller passed: copies, sums, constants, addresses and reloaded values;
// the called function's entry values refer to that.
//
// RUN: tpcc -O2 -g -fno-lto -nostdlib -Wl,--no-gc-sections,-e,caller %s -o %t
// RUN: llvm-dwarfdump --debug-info %t | FileCheck %s
// RUN: tpcc -O2 -g -gdwarf-4 -fno-lto -nostdlib -Wl,--no-gc-sections,-e,caller %s -o %t.4
// RUN: llvm-dwarfdump --debug-info %t.4 | FileCheck %s --check-prefix=DWARF4
// The whole program has them too.
// RUN: tpcc -O2 -g -nostdlib -Wl,-e,caller %s -o %t.whole
// RUN: llvm-dwarfdump --debug-info %t.whole | FileCheck %s --check-prefix=WHOLE

// CHECK: DW_OP_entry_value(DW_OP_reg5), DW_OP_stack_value
// CHECK: DW_AT_name ("Second")
// CHECK: DW_AT_name ("caller")
// CHECK: DW_TAG_call_site
// CHECK: DW_AT_call_return_pc
// CHECK-DAG: DW_AT_location (DW_OP_reg5)
// CHECK-DAG: DW_AT_call_value (DW_OP_breg[[#REG:]] +0)
// CHECK: DW_TAG_call_site
// CHECK: DW_AT_call_value (DW_OP_breg[[#REG]] +12)
// CHECK: DW_TAG_call_site
// CHECK: DW_AT_call_value (DW_OP_constu 0xfffffb2e)
// CHECK: DW_TAG_call_site
// CHECK: DW_AT_call_value (DW_OP_constu 0x12340000)
// CHECK: DW_TAG_call_site
// CHECK: DW_AT_call_value (DW_OP_fbreg +{{[0-9]+}})
// DWARF4: DW_OP_GNU_entry_value(DW_OP_reg4), DW_OP_stack_value
// DWARF4: DW_TAG_GNU_call_site
// DWARF4: DW_TAG_GNU_call_site_parameter
// WHOLE: DW_TAG_call_site_parameter

__attribute__((noinline)) void callee(int Value, int Second) {
  __asm__ volatile("" ::"r"(Value));
  __asm__ volatile("" : "+r"(Second)::"r4", "memory");
}
__attribute__((noinline)) void pointer(int *Value) {
  __asm__ volatile("" ::"r"(Value) : "memory");
}
int caller(int Argument) {
  int Local;
  callee(1, Argument);
  callee(Argument + 12, 1);
  callee(-1234, 2);
  callee(0x12340000, 3);
  pointer(&Local);
  return Argument + Local;
}
