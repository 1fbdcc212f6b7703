// A tail call is a call site that nothing returns to.
//
// RUN: tpcc -O2 -g -fno-lto -nostdlib -Wl,--no-gc-sections,-e,caller %s -o %t
// RUN: llvm-dwarfdump --debug-info %t | FileCheck %s

// CHECK: DW_AT_name ("caller")
// CHECK: DW_TAG_call_site
// CHECK-NEXT: DW_AT_call_origin ({{.*}} "callee")
// CHECK-NEXT: DW_AT_call_tail_call (true)
// CHECK-NEXT: DW_AT_call_pc
// CHECK: DW_TAG_call_site_parameter
// CHECK-NEXT: DW_AT_location (DW_OP_reg5)
// CHECK-NEXT: DW_AT_call_value (DW_OP_lit7)
__attribute__((noinline)) int callee(int First, int Second) {
  __asm__ volatile("" : "+r"(First));
  return First * Second;
}
int caller(int Argument) { return callee(Argument, 7); }
