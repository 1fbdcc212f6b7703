// A struct that is passed by value lives behind a pointer. Unoptimized code
// keeps the pointer in the frame, optimized code lets it go; then the caller
// knows it.
//
// RUN: tpcc -O0 -g -fno-lto -nostdlib -Wl,--no-gc-sections,-e,read %s -o %t.O0
// RUN: llvm-dwarfdump --name=Block %t.O0 | FileCheck %s --check-prefix=O0
// RUN: tpcc -O2 -g -fno-lto -nostdlib -Wl,--no-gc-sections,-e,read %s -o %t.O2
// RUN: llvm-dwarfdump --name=Block %t.O2 | FileCheck %s --check-prefix=O2
// Debug information does not change the code.
// RUN: tpcc -O0 -S -fno-lto %s -o - | FileCheck %s --check-prefix=CODE
// RUN: tpcc -O0 -g -S -fno-lto %s -o - | FileCheck %s --check-prefix=CODE

// O0: DW_AT_location (DW_OP_fbreg +{{[0-9]+}}, DW_OP_deref)
// O0-NEXT: DW_AT_name ("Block")
// O2: [0x00010000, 0x[[#%x,END:]]): DW_OP_breg4 +0
// O2-NEXT: [0x{{0*}}[[#END]], {{0x[0-9a-f]+}}): DW_OP_entry_value(DW_OP_reg4))
// O2-NEXT: DW_AT_name ("Block")
// CODE: read:
// CODE: addi r29, r29, -16
// CODE: sw r4, {{[0-9]+}}(r29)

struct Block {
  int Values[8];
};
int read(struct Block Block, int Index) {
  int Value = Block.Values[Index];
  __asm__ volatile("" ::: "r4");
  return Value * Value;
}
