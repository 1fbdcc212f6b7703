// A struct without an address: each member where it is.
//
// RUN: tpcc -O2 -g -fno-lto -nostdlib -Wl,--no-gc-sections,-e,split %s -o %t
// RUN: llvm-dwarfdump --name=Pair --name=Mixed %t | FileCheck %s

// CHECK: DW_OP_reg{{[0-9]+}}, DW_OP_piece 0x4, DW_OP_reg{{[0-9]+}}, DW_OP_piece 0x4
// CHECK: DW_AT_name ("Pair")
// CHECK: DW_OP_regx 0x{{[2-3][0-9a-f]}}, DW_OP_piece 0x4, DW_OP_lit5, DW_OP_stack_value, DW_OP_piece 0x4
// CHECK: DW_AT_name ("Mixed")
struct Pair {
  int Low, High;
};
struct Mixed {
  float Value;
  int Constant;
};
float split(int First, int Second, float Third) {
  struct Pair Pair = {First * 3, Second * 5};
  struct Mixed Mixed = {Third * Third, 5};
  __asm__ volatile("" ::"r"(Pair.Low), "r"(Pair.High), "f"(Mixed.Value));
  return Mixed.Value * (float)(Pair.Low + Pair.High + Mixed.Constant);
}
