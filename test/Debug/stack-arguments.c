// Arguments on the caller's stack, with and without a frame of the function's.
//
// RUN: tpcc -O2 -g -fno-lto -nostdlib -Wl,--no-gc-sections,-e,leaf %s -o %t
// RUN: llvm-dwarfdump --name=Ninth --name=Tenth %t | FileCheck %s

// CHECK: DW_AT_location (DW_OP_fbreg +0)
// CHECK-NEXT: DW_AT_name ("Ninth")
// CHECK: DW_AT_location (DW_OP_fbreg +4)
// CHECK-NEXT: DW_AT_name ("Tenth")
int leaf(int A, int B, int C, int D, int E, int F, int G, int H, int Ninth,
         int Tenth) {
  return A + B + C + D + E + F + G + H + Ninth + Tenth;
}
