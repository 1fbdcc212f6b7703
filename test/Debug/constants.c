// Values that no register holds.
//
// RUN: tpcc -O2 -g -fno-lto -nostdlib -Wl,--no-gc-sections,-e,constants %s -o %t
// RUN: llvm-dwarfdump --debug-info %t | FileCheck %s

// CHECK: DW_AT_name ("Global")
// CHECK: DW_AT_const_value (77)
// CHECK: DW_AT_const_value (42)
// CHECK: DW_AT_name ("Integer")
// CHECK: DW_AT_const_value (1075838976)
// CHECK: DW_AT_name ("Float")
// CHECK: DW_AT_const_value (-5)
// CHECK: DW_AT_name ("Wide")
// CHECK: DW_OP_consts +1, DW_OP_stack_value
// CHECK: DW_OP_consts +2, DW_OP_stack_value
// CHECK: DW_AT_name ("Changing")
static const int Global = 77;
int constants(int Argument) {
  int Integer = 42;
  float Float = 2.5f;
  long long Wide = -5;
  int Changing = 1;
  __asm__ volatile("" ::"r"(Argument));
  Changing = 2;
  __asm__ volatile("" ::"r"(Argument + 1));
  return Argument + Integer + (int)Float + (int)Wide + Changing + Global;
}
