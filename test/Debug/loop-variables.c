// A loop's counter in its register, and what is computed from it.
//
// RUN: tpcc -O2 -g -fno-lto -fno-unroll-loops -nostdlib -Wl,--no-gc-sections,-e,store %s -o %t
// RUN: llvm-dwarfdump --name=Counter --name=Scaled %t | FileCheck %s

// CHECK: DW_OP_consts +0, DW_OP_stack_value
// CHECK-NEXT: [0x{{.*}}): DW_OP_reg[[#REG:]])
// CHECK-NEXT: DW_AT_name ("Counter")
// CHECK: DW_OP_breg[[#REG]] +0, DW_OP_lit12, DW_OP_mul, DW_OP_stack_value
// CHECK-NEXT: DW_AT_name ("Scaled")
void store(int *List, int Count, int Value) {
  for (int Counter = 0; Counter < Count; ++Counter) {
    int Scaled = Counter * 12;
    __asm__ volatile("" ::"r"(Counter));
    List[Counter] = Value;
  }
}
