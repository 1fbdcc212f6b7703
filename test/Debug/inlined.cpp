// Inlined functions: where they were called, and their parameters.
//
// RUN: tpcc -O2 -g -fno-lto -nostdlib -Wl,--no-gc-sections,-e,outer %s -o %t
// RUN: llvm-dwarfdump --debug-info %t | FileCheck %s

// CHECK: DW_AT_inline (DW_INL_inlined)
// CHECK: DW_AT_name ("outer")
// CHECK: DW_TAG_inlined_subroutine
// CHECK-NEXT: DW_AT_abstract_origin ({{.*}} "{{.*}}middle{{.*}}")
// CHECK: DW_AT_call_line ([[#OUTER:]])
// CHECK: DW_TAG_formal_parameter
// CHECK: DW_OP_
// CHECK: DW_AT_abstract_origin ({{.*}} "Argument")
// CHECK: DW_TAG_inlined_subroutine
// CHECK-NEXT: DW_AT_abstract_origin ({{.*}} "{{.*}}inner{{.*}}")
// CHECK: DW_AT_call_line ([[#OUTER - 4]])
// CHECK: DW_TAG_formal_parameter
// CHECK: DW_OP_
// CHECK: DW_AT_abstract_origin ({{.*}} "Operand")
static inline int inner(int Operand) {
  int Result = Operand * Operand;
  asm volatile("" ::"r"(Result));
  return Result + 1;
}
static inline int middle(int Argument) {
  return inner(Argument + 1) * Argument;
}

extern "C" int outer(int Value) {
  return middle(Value * 3) + Value;
}
